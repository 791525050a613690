//! A query of curved motion from its line.

use exact_ccd::motion::{BodyPair, Chain, InvalidMotion, RigidMotion};
use exact_ccd::{AnyKind, Point, with_kind};
use serde_json::Value;

use super::problem::CurvedProblem;
use super::value::{At, Members};
use super::{CurvedRecord, Paths, bezier};
use crate::record::is_count;

const MOTIONS: &str = "a list of motions; an empty list is a body at rest";

/// The query on a line.
pub(super) fn record(line: &[u8]) -> Result<CurvedRecord, CurvedProblem> {
    let value: Value = serde_json::from_slice(line).map_err(|error| json(&error))?;
    let line = At::line(&value);
    let members = line.members(&["kind", "points", "first", "second", "count", "toi"])?;
    let kind = kind(&members.get("kind", "the short name of the kind of the query, such as \"vf\"")?)?;
    let points = members.get("points", "a list of the points of the query")?;
    let paths = if members.find("first").or(members.find("second")).is_some() {
        bodies(kind, &points, &members)?
    } else {
        curves(kind, &points)?
    };
    Ok(CurvedRecord {
        kind,
        paths,
        count: members.find("count").map(|at| count(&at)).transpose()?,
        toi: members.find("toi").map(|at| toi(&at)).transpose()?.flatten(),
    })
}

fn json(error: &serde_json::Error) -> CurvedProblem {
    let message = error.to_string();
    let end = format!(" at line {} column {}", error.line(), error.column());
    CurvedProblem::Json {
        column: error.column(),
        message: message.strip_suffix(&end).unwrap_or(&message).to_owned(),
    }
}

fn kind(at: &At<'_>) -> Result<AnyKind, CurvedProblem> {
    let mut kinds = AnyKind::ALL.iter().copied();
    let found = kinds.find(|kind| at.value().as_str() == Some(kind.short()));
    found.ok_or_else(|| {
        let names: Vec<_> = AnyKind::ALL
            .iter()
            .map(|kind| format!("\"{}\"", kind.short()))
            .collect();
        at.other(names.join(", "))
    })
}

/// One entry for each point of the kind.
fn of_kind<'a>(kind: AnyKind, points: &At<'a>) -> Result<Vec<At<'a>>, CurvedProblem> {
    let names = kind.point_names();
    let expected = format!(
        "{} points in a query of the kind {}: {}",
        names.len(),
        kind.short(),
        names.join(", ")
    );
    let list = points.list(&expected)?;
    if list.len() == names.len() {
        Ok(list)
    } else {
        Err(points.other(expected))
    }
}

fn curves(kind: AnyKind, points: &At<'_>) -> Result<Paths, CurvedProblem> {
    let mut curves: Vec<Vec<Point>> = Vec::new();
    for point in of_kind(kind, points)? {
        let control = point.list("a list of control points; a query of bodies has first and second")?;
        let control: Vec<Point> = control.iter().map(At::numbers).collect::<Result<_, _>>()?;
        if let Some(first) = curves.first()
            && first.len() != control.len()
        {
            return Err(point.other(format!("{} control points, as the first point has", first.len())));
        }
        curves.push(control);
    }
    let motion = with_kind!(kind, K => bezier::<K>(&curves).map(drop));
    motion.map_err(|source| refused(points, source))?;
    Ok(Paths::Curves(curves))
}

fn bodies(kind: AnyKind, points: &At<'_>, members: &Members<'_>) -> Result<Paths, CurvedProblem> {
    let places = of_kind(kind, points)?;
    Ok(Paths::Bodies {
        points: places.iter().map(At::numbers).collect::<Result<_, _>>()?,
        pair: BodyPair::new(
            chain(&members.get("first", MOTIONS)?)?,
            chain(&members.get("second", MOTIONS)?)?,
        ),
    })
}

fn chain(at: &At<'_>) -> Result<Chain, CurvedProblem> {
    let motions = at.list(MOTIONS)?;
    let motions: Vec<RigidMotion> = motions.iter().map(motion).collect::<Result<_, _>>()?;
    Chain::new(motions).map_err(|source| refused(at, source))
}

fn motion(at: &At<'_>) -> Result<RigidMotion, CurvedProblem> {
    let members = at.members(&["q0", "q1", "o0", "o1"])?;
    let quaternion = |key| members.get(key, "a quaternion, the scalar first")?.numbers();
    let place = |key| members.get(key, "a place of the origin of the body")?.numbers();
    let quaternions = [quaternion("q0")?, quaternion("q1")?];
    RigidMotion::new(quaternions, &[place("o0")?, place("o1")?]).map_err(|source| refused(at, source))
}

fn refused(at: &At<'_>, source: InvalidMotion) -> CurvedProblem {
    CurvedProblem::Motion {
        field: at.path().to_owned(),
        source,
    }
}

fn count(at: &At<'_>) -> Result<i64, CurvedProblem> {
    let count = at.value().as_i64().filter(|&count| is_count(count));
    count.ok_or_else(|| at.other("a number of contact times, or -1 for infinitely many"))
}

fn toi(at: &At<'_>) -> Result<Option<f64>, CurvedProblem> {
    if at.value().is_null() {
        return Ok(None);
    }
    let time = at.value().as_f64().filter(|time| (0.0..=1.0).contains(time));
    match time {
        Some(time) => Ok(Some(time)),
        None => Err(at.other("a time from 0 to 1, or null if there is no contact")),
    }
}

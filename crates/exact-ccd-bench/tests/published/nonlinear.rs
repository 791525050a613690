//! Curved motion against truth from rational arithmetic: the number of contact times, and the first.

use std::fs;

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Point, VertexFace};
use serde::Deserialize;

/// A line of a file.
#[derive(Deserialize)]
struct Line {
    kind: String,
    #[serde(flatten)]
    motion: Motion,
    /// −1 for infinitely many.
    count: i64,
    toi: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Motion {
    Bodies {
        first: Vec<Rigid>,
        second: Vec<Rigid>,
        points: [Point; 4],
    },
    Bezier {
        points: [Vec<Point>; 4],
    },
}

#[derive(Deserialize)]
struct Rigid {
    q0: [f64; 4],
    q1: [f64; 4],
    o0: Point,
    o1: Point,
}

fn chain(motions: &[Rigid]) -> Chain {
    let motion = |m: &Rigid| RigidMotion::new([m.q0, m.q1], &[m.o0, m.o1]).unwrap();
    Chain::new(motions.iter().map(motion)).unwrap()
}

fn query<K: Kind<Points = [Point; 4]>>(motion: &Motion) -> CurvedQuery<K> {
    match motion {
        Motion::Bodies {
            first,
            second,
            points,
        } => CurvedQuery::of_bodies(*points, chain(first), chain(second)).unwrap(),
        Motion::Bezier { points } => {
            let set = |i: usize| [0, 1, 2, 3].map(|point: usize| points[point][i]);
            let control: Vec<_> = (0..points[0].len()).map(set).collect();
            Bezier::new(&control).unwrap().into()
        }
    }
}

fn check<K: Kind<Points = [Point; 4]>>(line: &Line, place: &str) {
    let query = query::<K>(&line.motion);
    let intervals = query.intervals(CONTACT);
    let expected = usize::try_from(line.count).ok();
    assert_eq!(intervals.count(), expected, "{place}");
    let first = intervals.first_time().map(|time| time.lower().to_bits());
    assert_eq!(first, line.toi.map(f64::to_bits), "{place}");
    assert_eq!(query.time_of_impact(CONTACT), line.toi, "{place}");
    assert_eq!(query.collides(CONTACT), line.toi.is_some(), "{place}");
}

/// The lines of all files about one kind.
fn check_files(kind: &str, expected: usize) {
    let mut count = 0;
    for path in crate::data().nonlinear().unwrap() {
        for (index, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            let place = format!("line {} of {}", index + 1, path.display());
            let line: Line = serde_json::from_str(line).unwrap();
            if line.kind == kind {
                match kind {
                    "vf" => check::<VertexFace>(&line, &place),
                    _ => check::<EdgeEdge>(&line, &place),
                }
                count += 1;
            }
        }
    }
    assert_eq!(count, expected);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertices_and_faces_on_curves() {
    check_files("vf", 2130);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn edges_on_curves() {
    check_files("ee", 2130);
}

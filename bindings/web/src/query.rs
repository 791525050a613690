//! The answers to one query.

use std::collections::BTreeMap;

use exact_ccd::{AnyKind, EdgeEdge, Kind, Point, Query, Separation, VertexFace, with_kind};
use exact_ccd_view::Page;
use serde::Serialize;

use crate::error::Error;
use crate::root_finder::{RootFinder, Verdict};

/// The answers, in the shape of the JSON object.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Answer {
    /// The data of the page.
    page: BTreeMap<String, String>,
    /// None for kinds without a root finder.
    root_finder: Option<Verdict>,
}

pub(crate) fn answer(
    kind: &str,
    coordinates: &[f64],
    distance: f64,
    tolerance: f64,
) -> Result<String, Error> {
    let separation = Separation::new(distance)?;
    let finder = RootFinder::new(distance + tolerance)?;
    let method = finder.method();
    let mut kinds = AnyKind::ALL.iter().copied();
    let kind = kinds
        .find(|any| any.name() == kind)
        .ok_or_else(|| Error::Kind(kind.to_owned()))?;
    let page = with_kind!(kind, K => Page::of_query(title(kind), &query::<K>(coordinates)?, separation));
    let root_finder = match kind {
        AnyKind::VertexFace => Some(Verdict::of::<VertexFace>(method, &query(coordinates)?)),
        AnyKind::EdgeEdge => Some(Verdict::of::<EdgeEdge>(method, &query(coordinates)?)),
        _ => None,
    };
    let page = page.blocks();
    // Cannot panic: the keys are strings.
    Ok(serde_json::to_string(&Answer { page, root_finder }).expect("the answer has a text"))
}

/// The title of the page of a query.
fn title(kind: AnyKind) -> &'static str {
    match kind {
        AnyKind::VertexFace => "A vertex and a face",
        AnyKind::EdgeEdge => "Two edges",
        AnyKind::VertexEdge => "A vertex and an edge",
        AnyKind::VertexVertex => "Two vertices",
    }
}

/// The query of these coordinates.
fn query<K: Kind>(coordinates: &[f64]) -> Result<Query<K>, Error> {
    let mut ends = [K::Points::default(), K::Points::default()];
    let (points, rest) = coordinates.as_chunks::<3>();
    let count = ends[0].as_ref().len();
    let (start, end) = match points.split_at_checked(count) {
        Some(both) if both.1.len() == count && rest.is_empty() => both,
        _ => {
            return Err(Error::Coordinates {
                found: coordinates.len(),
                expected: 6 * count,
            });
        }
    };
    let given: [&[Point]; 2] = [start, end];
    for (points, given) in ends.iter_mut().zip(given) {
        points.as_mut().copy_from_slice(given);
    }
    let [t0, t1] = ends;
    Ok(Query::new(t0, t1)?)
}

#[cfg(test)]
mod tests {
    use super::answer;

    const FACE: [f64; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];

    fn falling(from: f64, to: f64) -> Vec<f64> {
        let at = |z: f64| [&[0.25, 0.25, z], &FACE[..]].concat();
        [at(from), at(to)].concat()
    }

    fn object(kind: &str, coordinates: &[f64], distance: f64) -> serde_json::Value {
        let text = answer(kind, coordinates, distance, 0.0).expect("the query is valid");
        serde_json::from_str(&text).expect("it is JSON")
    }

    #[test]
    fn a_vertex_falls_through_a_face() {
        let answer = object("vertex-face", &falling(1.0, -2.0), 0.0);
        let page: serde_json::Value =
            serde_json::from_str(answer["page"]["page"].as_str().expect("a text")).expect("the page is JSON");
        assert_eq!(page["contacts"][0]["time"], 1.0 / 3.0);
        assert_eq!(answer["rootFinder"]["contact"], true);
        assert!(answer["page"]["frame-1"].is_string());
    }

    #[test]
    fn kinds_without_a_root_finder_have_exact_answers() {
        let vertices = [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0];
        let answer = object("vertex-vertex", &vertices, 1.0);
        assert!(answer["rootFinder"].is_null());
        assert!(
            answer["page"]["page"]
                .as_str()
                .expect("a text")
                .contains("within 1 at t = 1")
        );
    }

    #[test]
    fn errors_name_the_fault() {
        let message = |kind: &str, coordinates: &[f64], distance: f64| {
            answer(kind, coordinates, distance, 0.0)
                .expect_err("it is invalid")
                .to_string()
        };
        assert!(message("edge", &falling(1.0, -1.0), 0.0).starts_with("\"edge\" is not a kind of query"));
        assert!(message("edge-edge", &[0.0; 23], 0.0).starts_with("23 coordinates, expected 24"));
        assert!(message("vertex-edge", &[0.0; 24], 0.0).starts_with("24 coordinates, expected 18"));
        assert!(message("edge-edge", &[f64::NAN; 24], 0.0).contains("not a finite number"));
        assert!(message("vertex-face", &falling(1.0, -1.0), -1.0).contains("-1"));
    }
}

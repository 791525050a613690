//! The closest points of the primitives at an instant, and the direction from one to the other.

use core::cmp::Ordering;

use super::feature::{Feature, Pair};
use super::scaled::Scaled;
use crate::exact::instant::Instant;
use crate::exact::narrowing::Narrowing;
use crate::exact::polynomial::{Vector, dot};
use crate::tables::{Point, Side, Tables};
use crate::values::Impact;

/// The parameters of two points, and the direction from the point on the second primitive to the point on the
/// first one.
type PointPair = ([f64; 2], Option<Point>);

/// The closest points at the first instant within d.
pub(super) fn impact<K: Tables>(scaled: &Scaled, features: &[Feature], first: &Instant) -> Impact {
    let time = first.round();
    // In a bracket narrower than the resolution of the ratios, approximations prove nearly all of
    // their signs.
    let instant = Narrowing::new(first.clone());
    instant.narrow_to(80);
    let within = features.iter().filter(|feature| feature.is_within(&instant));
    // Cannot panic: at each time some features have the closest points of the primitives, which are
    // within d at this one.
    let closest = within.min_by(|one, other| one.compare(other, &instant));
    let closest = closest.expect("some features are within the separation at the first time");
    let (parameters, normal) = match closest.pair {
        Pair::Vertices(difference, parameters) => (
            parameters,
            scaled.direction(scaled.difference(difference), &instant),
        ),
        Pair::VertexEdge(side) => vertex_edge(scaled, side, &instant),
        Pair::Inner => inner::<K>(scaled, closest, &instant),
    };
    Impact {
        time,
        parameters,
        normal,
    }
}

/// With x from the edge's start to the vertex, the closest point is at s = (e · x) / (e · e), and the vector
/// (e · e) x − (e · x) e points from it to the vertex.
fn vertex_edge(scaled: &Scaled, side: &Side, instant: &Narrowing) -> PointPair {
    let [a, b] = side.edge;
    let (x, e) = (
        scaled.difference((side.vertex, a)),
        scaled.weighted_difference((b, a)),
    );
    let (along, squared_length) = (dot(&e, &x), dot(&e, &e));
    let s = instant.ratio(&along, &squared_length);
    let is_of_first = side.vertex < a;
    let direction: Vector = [0, 1, 2].map(|axis: usize| {
        let towards_vertex = &(&squared_length * &x[axis]) - &(&along * &e[axis]);
        if is_of_first {
            towards_vertex
        } else {
            -towards_vertex
        }
    });
    (side.parameters(s), scaled.direction(direction, instant))
}

/// The parameters are guards of the feature over n · n. The direction is n or −n, on the side of w.
fn inner<K: Tables>(scaled: &Scaled, feature: &Feature, instant: &Narrowing) -> PointPair {
    let (volume, n) = scaled.plane::<K>();
    let squared_length = dot(&n, &n);
    let parameters = K::PARAMETERS.map(|side| instant.ratio(&feature.guards[side], &squared_length));
    let side = instant.sign(&volume);
    let direction = match side {
        Ordering::Greater => scaled.direction(n, instant),
        Ordering::Less => scaled.direction(n.map(|component| -component), instant),
        Ordering::Equal => None,
    };
    (parameters, direction)
}

//! Edges that move alongside each other: a plane through an edge and the relative velocity.
//!
//! The hull of F for two long, nearly parallel edges that pass near each other is nearly flat: it has the
//! directions of the edges and of the velocity. If the plane through these directions misses the origin, its
//! normal separates. An iteration towards the nearest point would approach it slowly.

use super::gap::Touching;
use super::hull::Hull;
use crate::numbers::number::subtract;
use crate::numbers::vector::{cross, minus};
use crate::tables::{Points, Tables};

/// Returns true if the plane of an edge of the span and of the velocity separates.
pub(super) fn separates<K: Tables>(points: &Points<f64>, hull: &Hull<f64>) -> bool {
    let [w, e1, e2] = K::SPAN.map(|difference| subtract::<f64>(points, difference));
    let velocity = minus(w[1], w[0]);
    [e1[0], e2[0]]
        .into_iter()
        .any(|edge| hull.is_beyond(cross(edge, velocity), Touching))
}

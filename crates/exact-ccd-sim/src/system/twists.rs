//! The twist of rods whose ends are held.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::System;
use crate::elasticity::{Chain, angle_about, transported};
use crate::scripted::Axes;

impl System {
    /// The chains of which the first and the last edge are held, by their numbers.
    pub(crate) fn held_chains(&self, held: &[Axes]) -> Vec<(u32, &Chain)> {
        let is_held = |vertex: &u32| held[*vertex as usize] == [true; 3];
        let numbered = (0..).zip(&self.chains);
        let both = numbered.filter(|(_, chain)| chain.ends().as_flattened().iter().all(is_held));
        both.collect()
    }
}

/// The scripted position of a point that a vertex carries, at two times: the vertex, and the vector from the
/// vertex to the point where the script began.
pub(crate) type Carried<'a> = dyn Fn(u32, Vector3<f64>) -> [Point; 2] + 'a;

/// The angle by which the cross section at the last edge of a chain turns between two times, minus the angle
/// at the first edge. It is measured about the direction of the edge, relative to a frame that turns with
/// this direction by the least rotation, and less than half a turn for each end.
pub(crate) fn turn(chain: &Chain, carried: &Carried<'_>) -> f64 {
    let [first, last] = chain.ends().map(|edge| turn_of(edge, carried));
    last - first
}

/// The turn at one edge. Its first vertex carries the frame.
fn turn_of([a, b]: [u32; 2], carried: &Carried<'_>) -> f64 {
    let [from, to] = [a, b].map(|vertex| carried(vertex, Vector3::zeros()).map(Vector3::from));
    // An edge without a length has no direction, and turns by 0 about it.
    let directions = [0, 1].map(|time: usize| (to[time] - from[time]).try_normalize(0.0).unwrap_or_default());
    let across = |time: usize, vector: Vector3<f64>| {
        let direction = directions[time];
        vector - direction * direction.dot(&vector)
    };
    // One of the three axes is across the edge by more than half of its length.
    let frames = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| {
        let at = carried(a, axis).map(Vector3::from);
        [0, 1].map(|time: usize| across(time, at[time] - from[time]))
    });
    let widest = frames
        .into_iter()
        .max_by(|a, b| a[0].norm().total_cmp(&b[0].norm()));
    let [before, after] = widest.unwrap_or_default();
    let [s, t] = directions;
    angle_about(&t, &transported(&before, &s, &t), &after)
}

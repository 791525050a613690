//! The exact filter.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use exact_ccd::batch::Trajectories;
use exact_ccd::{Collision, EdgeEdge, Kind, VertexFace};
use exact_ccd_mesh::Point;
use rayon::prelude::*;

use super::increment::Increment;
use super::{LAST, StepFilter};

/// The exact time of impact of the full step, and the exact decision of the step that is taken.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

/// How many pairs a thread looks at before it asks whether that is enough.
const GRAIN: usize = 2048;

impl StepFilter for Exact {
    fn name(&self) -> &'static str {
        "exact"
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        let earliest = Earliest::default();
        let is_sound = collisions(
            increment,
            |collision| earliest.add(&collision),
            |collision| earliest.add(&collision),
            || false,
        );
        if is_sound {
            earliest.time().map_or(1.0, |time| time.min(LAST))
        } else {
            0.0
        }
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        let is_free = AtomicBool::new(true);
        let step = increment.between(increment.start(), end);
        let is_sound = collisions(
            &step,
            |_| is_free.store(false, Ordering::Relaxed),
            |_| is_free.store(false, Ordering::Relaxed),
            || !is_free.load(Ordering::Relaxed),
        );
        is_sound && is_free.into_inner()
    }
}

/// Finds the pairs of a step that collide, until that is enough. Whether the step is sound: of finite positions.
fn collisions(
    step: &Increment<'_>,
    vertex_face: impl Fn(Collision<'_, VertexFace>) + Sync,
    edge_edge: impl Fn(Collision<'_, EdgeEdge>) + Sync,
    is_enough: impl Fn() -> bool + Sync,
) -> bool {
    let (surface, pairs) = (step.surface(), step.pairs());
    let Ok(trajectories) = Trajectories::new(step.start(), step.end()) else {
        return false;
    };
    among(
        &trajectories,
        &pairs.vertex_face,
        |pair| surface.vertex_face(pair),
        vertex_face,
        &is_enough,
    ) && among(
        &trajectories,
        &pairs.edge_edge,
        |pair| surface.edge_edge(pair),
        edge_edge,
        &is_enough,
    )
}

fn among<K: Kind>(
    trajectories: &Trajectories,
    pairs: &[[u32; 2]],
    vertices: impl Fn([u32; 2]) -> [u32; 4] + Sync,
    found: impl Fn(Collision<'_, K>) + Sync,
    is_enough: impl Fn() -> bool + Sync,
) -> bool {
    pairs.par_chunks(GRAIN).all(|pairs| {
        let queries: Vec<[u32; 4]> = pairs.iter().map(|&pair| vertices(pair)).collect();
        is_enough()
            || trajectories
                .collisions(&queries, |_, collision| found(collision))
                .is_ok()
    })
}

/// The earliest of some contacts.
struct Earliest(AtomicU64);

impl Default for Earliest {
    fn default() -> Self {
        Self(AtomicU64::new(f64::INFINITY.to_bits()))
    }
}

impl Earliest {
    fn add<K: Kind>(&self, collision: &Collision<'_, K>) {
        // The bits of positive numbers have the order of the numbers. 0.0 may have a sign.
        let time = collision.time_of_impact().abs();
        self.0.fetch_min(time.to_bits(), Ordering::Relaxed);
    }

    /// Its time, rounded down.
    fn time(&self) -> Option<f64> {
        Some(f64::from_bits(self.0.load(Ordering::Relaxed))).filter(|time| time.is_finite())
    }
}

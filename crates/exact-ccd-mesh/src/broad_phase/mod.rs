//! The broad phase: pairs of boxes that meet. The boxes are of anything: no mesh is needed.

mod aabb;
mod all_pairs;
mod block;
mod boxes;
mod bvh;
mod collector;
mod members;
mod moving_box;
mod order;
mod outward;
mod pairs;
mod primitive_count;
mod sweep;
mod units;
mod vectors;

use core::ops::ControlFlow;

pub use aabb::Aabb;
pub use all_pairs::AllPairs;
pub use boxes::Boxes;
pub use bvh::Bvh;
pub use collector::PairCollector;
pub use primitive_count::TooManyPrimitives;
pub use sweep::Sweep;

pub(crate) use aabb::meet;
pub(crate) use members::Members;
pub(crate) use moving_box::MovingBox;
pub(crate) use order::{extent, order};
#[cfg(test)]
pub(crate) use outward::small;
pub(crate) use outward::{Format, sum_above};
pub(crate) use primitive_count::check_primitive_count;
pub(crate) use units::Units;

/// A callback for batches of pairs from a broad phase; `Break` ends the search.
pub type PairSink<'a> = dyn Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync + 'a;

/// An algorithm that finds the pairs of boxes that meet: of boxes at rest (T = 1), or of boxes that move
/// (T = 2). [`Boxes`] have no other T.
///
/// Two boxes do not meet if some axis separates them at t = 0 and, in the same order, at t = 1,
/// hence at all times in between. Boxes at rest meet if they overlap, even if only in a point. A
/// broad phase may find other pairs too.
///
/// Pairs are passed to the sink as they are found, in batches, from any thread and in any order;
/// each pair is passed on once. When the sink breaks, each thread calls it at most once more, and
/// the broad phase breaks too.
///
/// ```
/// use core::ops::ControlFlow;
/// use std::sync::Mutex;
///
/// use exact_ccd_mesh::{Aabb, BoxPairs, Boxes, Bvh};
///
/// let cube = |x: f64| Aabb::of([x, 0.0, 0.0]).union(&Aabb::of([x + 1.0, 1.0, 1.0]));
/// let cubes = Boxes::new(&[0.0, 1.0, 2.5, 2.0].map(|x| [cube(x)]))?;
/// let found = Mutex::new(Vec::new());
/// let _ = Bvh.within(&cubes, &|pairs: &[_]| {
///     found.lock().unwrap().extend_from_slice(pairs);
///     ControlFlow::Continue(())
/// });
/// let mut pairs = found.into_inner().unwrap();
/// pairs.sort();
/// assert_eq!(pairs, [[0, 1], [1, 3], [2, 3]]);
/// # Ok::<(), exact_ccd_mesh::TooManyPrimitives>(())
/// ```
pub trait BoxPairs<const T: usize>: Send + Sync {
    /// Finds the pairs of a box in `a` and a box in `b`: their indices, in this order.
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()>;

    /// Finds the pairs of two boxes in `boxes`, the smaller index first.
    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()>;
}

/// A broad phase of meshes: the pairs of boxes at rest and of boxes that move.
///
/// Every type that implements [`BoxPairs`] for both is a broad phase of meshes: implement that trait.
/// `impl<const T: usize> BoxPairs<T>` serves both; if it calls [`Bvh`], it has the bound `Bvh: BoxPairs<T>`.
pub trait BroadPhase: BoxPairs<1> + BoxPairs<2> {}

impl<B: BoxPairs<1> + BoxPairs<2>> BroadPhase for B {}

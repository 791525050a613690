//! Pairs of boxes that meet.

mod all_pairs;
mod block;
mod boxes;
mod bvh;
mod found;
mod moving_box;
mod order;
mod pairs;
mod sweep;

use core::ops::ControlFlow;

pub use all_pairs::AllPairs;
pub use boxes::Boxes;
pub use bvh::Bvh;
pub use found::Found;
pub use sweep::Sweep;

pub(crate) use moving_box::MovingBox;
pub(crate) use order::{extent, order};

/// Who is shown the pairs that a broad phase finds, and may tell it to break.
pub type Visit<'a> = dyn Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync + 'a;

/// A way to find the pairs of moving boxes that meet.
///
/// Two boxes do not meet if some axis separates them at t = 0 and, the same way round, at t = 1, hence at all times
/// between. Boxes that rest meet if they overlap, be it in a point. A broad phase may find other pairs too.
///
/// Pairs are handed on as they are found, some at a time, on any thread and in any order; each is handed on once. When
/// `visit` breaks, it is not called much longer, and the broad phase breaks too.
///
/// ```
/// use core::ops::ControlFlow;
/// use std::sync::Mutex;
///
/// use exact_ccd_mesh::{Bounds, Boxes, BroadPhase, Bvh};
///
/// let cube = |x: f64| Bounds::of([x, 0.0, 0.0]).union(&Bounds::of([x + 1.0, 1.0, 1.0]));
/// let cubes = Boxes::new(&[0.0, 1.0, 2.5, 2.0].map(|x| [cube(x)]));
/// let found = Mutex::new(Vec::new());
/// let _ = Bvh.within(&cubes, &|pairs: &[_]| {
///     found.lock().unwrap().extend_from_slice(pairs);
///     ControlFlow::Continue(())
/// });
/// let mut pairs = found.into_inner().unwrap();
/// pairs.sort();
/// assert_eq!(pairs, [[0, 1], [1, 3], [2, 3]]);
/// ```
pub trait BroadPhase: Sync {
    /// Finds the pairs of the index of a box in `a` and that of a box in `b`.
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()>;

    /// Finds the pairs of two boxes in `boxes`, the lesser index first.
    fn within<const T: usize>(&self, boxes: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()>;
}

impl<B: BroadPhase> BroadPhase for &B {
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()> {
        (**self).between(a, b, visit)
    }

    fn within<const T: usize>(&self, boxes: &Boxes<T>, visit: &Visit<'_>) -> ControlFlow<()> {
        (**self).within(boxes, visit)
    }
}

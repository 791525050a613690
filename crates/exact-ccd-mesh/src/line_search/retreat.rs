//! The vertices that contacts hold back.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use arrayvec::ArrayVec;
use exact_ccd::Impact;

use crate::gathered::Gathered;
use crate::pairs::{Pair, PairKind, Searched};
use crate::search::{Collect, PairCollision};
use crate::steps::Step;
use crate::vector::{dot, minus};

/// The collector of all contacts of a step, which hold vertices back.
pub(super) struct Retreats<'a> {
    step: Step<'a>,
    /// The vertices that can be held back.
    can_retreat: &'a [bool],
    /// For each vertex, the time of the first contact that holds it back, as far as it is known. The bits of
    /// f64 that are not negative are in the order of the numbers.
    times: Vec<AtomicU64>,
    stuck: Gathered<Pair>,
}

impl<'a> Retreats<'a> {
    pub(super) fn new(step: Step<'a>, can_retreat: &'a [bool]) -> Self {
        let never = f64::INFINITY.to_bits();
        Self {
            step,
            can_retreat,
            times: can_retreat.iter().map(|_| AtomicU64::new(never)).collect(),
            stuck: Gathered::default(),
        }
    }

    /// For each vertex, the largest f64 not above the time of the first contact that holds it back, or
    /// infinity; and the pairs in contact that have no vertex that can be held back, in no order.
    pub(super) fn found(self) -> (Vec<f64>, Vec<Pair>) {
        let bits = self.times.into_iter().map(AtomicU64::into_inner);
        (bits.map(f64::from_bits).collect(), self.stuck.into_list())
    }

    /// The bits of the time of the first contact that holds a vertex back, as far as it is known.
    fn first(&self, vertex: u32) -> u64 {
        self.times[vertex as usize].load(Ordering::Relaxed)
    }

    /// The vertices that can be held back.
    fn able(&self, vertices: &[u32]) -> ArrayVec<u32, 4> {
        let mut able: ArrayVec<u32, 4> = vertices.iter().copied().collect();
        able.retain(|&mut vertex| self.can_retreat[vertex as usize]);
        able
    }

    /// The vertices of a contact to hold back: the vertices that approach the other primitive. It is all
    /// vertices if the contact has no normal, or if no vertex that approaches can be held back.
    ///
    /// A vertex with the weight w in the vector between the closest points, and the displacement d, changes
    /// the gap along the normal n by w n · d, to first order. The gap closes: a vertex approaches if its
    /// change has the sign of the sum of all changes.
    fn held_back<K: PairKind>(&self, vertices: &[u32], impact: &Impact) -> ArrayVec<u32, 4> {
        let mut held_back = self.able(vertices);
        let Some(normal) = impact.normal else {
            return held_back;
        };
        let [x0, x1] = self.step.positions();
        let weights = impact.weights::<K>();
        let change = |place: usize| {
            let vertex = vertices[place] as usize;
            weights[place] * dot(normal, minus(x1[vertex], x0[vertex]))
        };
        let sum: f64 = (0..vertices.len()).map(change).sum();
        let approaches = |vertex: u32| {
            let place = vertices.iter().position(|&other| other == vertex);
            place.is_some_and(|place| change(place) * sum > 0.0)
        };
        if held_back.iter().any(|&vertex| approaches(vertex)) {
            held_back.retain(|&mut vertex| approaches(vertex));
        }
        held_back
    }
}

impl Collect for Retreats<'_> {
    /// The pairs that have no vertex that can be held back.
    type Batch = Vec<Pair>;

    fn until(&self) -> f64 {
        1.0
    }

    fn add<K: Searched>(&self, stuck: &mut Vec<Pair>, ids: [u32; 2], found: PairCollision<'_, K>) {
        let Some((collision, vertices)) = found.contact().zip(K::vertices(self.step.mesh(), ids)) else {
            return;
        };
        let able = self.able(vertices.as_ref());
        let Some(last) = able.iter().map(|&vertex| self.first(vertex)).max() else {
            stuck.push(Pair::new(K::KIND, ids));
            return;
        };
        // Otherwise, an earlier contact already holds back each vertex that this one would.
        if collision.is_before(f64::from_bits(last)) {
            let impact = collision.impact();
            let time = impact.time.lower().to_bits();
            for vertex in self.held_back::<K>(vertices.as_ref(), &impact) {
                self.times[vertex as usize].fetch_min(time, Ordering::Relaxed);
            }
        }
    }

    fn end<K: Searched>(&self, stuck: Vec<Pair>, _: usize) -> ControlFlow<()> {
        self.stuck.append(stuck);
        ControlFlow::Continue(())
    }
}

//! The vertices that contacts hold back.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use arrayvec::ArrayVec;
use exact_ccd::Impact;

use crate::mesh::TriangleMesh;
use crate::pairs::{Pair, PairKind};
use crate::search::{Collect, NarrowPhase};
use crate::steps::Step;
use crate::vector::{dot, minus};

/// A contact, and the vertices that it holds back.
#[derive(Clone, Debug)]
pub(super) struct Retreat {
    pub(super) pair: Pair,
    /// The largest f64 not above the time of the contact.
    pub(super) time: f64,
    /// None, if no vertex of the pair can be held back.
    pub(super) vertices: ArrayVec<u32, 4>,
}

/// The collector of all contacts of a step, with the vertices that they hold back.
pub(super) struct Retreats<'a> {
    step: Step<'a>,
    /// The vertices that can be held back.
    can_retreat: &'a [bool],
    found: Mutex<Vec<Retreat>>,
}

impl<'a> Retreats<'a> {
    pub(super) fn new(step: Step<'a>, can_retreat: &'a [bool]) -> Self {
        Self {
            step,
            can_retreat,
            found: Mutex::default(),
        }
    }

    /// The contacts in no order, some of them twice.
    pub(super) fn found(self) -> Vec<Retreat> {
        self.found.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// The vertices of a contact to hold back: those that approach the other primitive, or all of them where
    /// the contact has no normal, or none of those that approach can be held back.
    ///
    /// A vertex with the weight w in the vector between the closest points, and the displacement d, changes
    /// the gap along the normal n by w n · d, to first order. The gap closes: a vertex approaches if its
    /// change has the sign of the sum of all changes.
    fn held_back<K: PairKind>(&self, vertices: &[u32], impact: &Impact) -> ArrayVec<u32, 4> {
        let mut held_back: ArrayVec<u32, 4> = vertices.iter().copied().collect();
        held_back.retain(|&mut vertex| self.can_retreat[vertex as usize]);
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
    const PROFITS_FROM_SAMPLE: bool = false;

    fn until(&self) -> f64 {
        1.0
    }

    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        // Rounding depends on the order of the primitives, which must not be that in which they are found.
        let pairs: Vec<[u32; 2]> = pairs.iter().map(|&ids| K::pair(ids).ids()).collect();
        let mut found = Vec::new();
        narrow_phase.approaches::<K>(mesh, &pairs, self.until(), |ids, approach| {
            let Some((collision, vertices)) = approach.contact().zip(K::vertices(mesh, ids)) else {
                return;
            };
            let impact = collision.impact();
            found.push(Retreat {
                pair: K::pair(ids),
                time: impact.time.lower(),
                vertices: self.held_back::<K>(vertices.as_ref(), &impact),
            });
        });
        if !found.is_empty() {
            let mut all = self.found.lock().unwrap_or_else(PoisonError::into_inner);
            all.append(&mut found);
        }
        ControlFlow::Continue(())
    }
}

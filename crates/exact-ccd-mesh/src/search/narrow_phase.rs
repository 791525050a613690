//! The narrow phase: exact tests of candidates, in batches, whose contacts a collector receives.

use std::ops::ControlFlow;

use exact_ccd::batch::Trajectories;
use exact_ccd::{Options, Query, Separation, Separations};

use super::chunks::for_each_chunk;
use super::collect::Collect;
use super::pair_collision::PairCollision;
use crate::mesh::TriangleMesh;
use crate::pairs::{CanCollide, MinDistance, PairKind, Receive, Searched};
use crate::steps::Step;

/// Exact tests of the candidates of a step, in batches.
#[derive(Clone, Debug)]
pub(crate) struct NarrowPhase {
    can_collide: CanCollide,
    min_distance: MinDistance,
    trajectories: Trajectories,
}

impl NarrowPhase {
    /// A narrow phase without a step, for the pairs that can collide.
    pub(crate) fn new(can_collide: CanCollide) -> Self {
        Self {
            can_collide,
            min_distance: MinDistance::default(),
            trajectories: Trajectories::default(),
        }
    }

    /// The narrow phase of a step, for all pairs.
    pub(crate) fn of(step: &Step<'_>, min_distance: MinDistance) -> Self {
        let mut narrow_phase = Self::new(CanCollide::all());
        narrow_phase.begin(step, min_distance);
        narrow_phase
    }

    /// Takes the positions of another step, and the distance at which primitives touch in it.
    pub(crate) fn begin(&mut self, step: &Step<'_>, min_distance: MinDistance) {
        self.min_distance = min_distance;
        let [x0, x1] = step.positions();
        self.trajectories
            .set(x0, x1)
            .expect("a step has as many positions at both ends, and all are finite");
    }

    pub(crate) fn can_collide(&self) -> &CanCollide {
        &self.can_collide
    }

    /// Passes the contacts among some pairs to a collector. `Break` ends the search.
    fn examine<K: Searched, C: Collect>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        collector: &C,
    ) -> ControlFlow<()> {
        let (relevant, until) = collector.relevant::<K>(pairs)?;
        let mut batch = C::Batch::default();
        self.collisions::<K>(mesh, &relevant, until, |ids, found| {
            collector.add::<K>(&mut batch, ids, found);
        });
        collector.end::<K>(batch, pairs.len())
    }

    /// Calls `found` with each pair that first comes within its minimum distance at a time not after `until`.
    ///
    /// Pairs with a common vertex are left out, and pairs that cannot collide, and pairs that `mesh`, the
    /// mesh of the step, does not have.
    fn collisions<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        until: f64,
        mut found: impl FnMut([u32; 2], PairCollision<'_, K>),
    ) {
        let separations = self.min_distance.separations();
        // Each case compiles to a copy of the loop, so that the usual loop calls no predicate.
        if self.can_collide.is_all() && !K::CAN_BE_CONNECTED {
            self.collisions_if(mesh, pairs, until, separations, K::are_apart, found);
            return;
        }
        let can_collide = |vertices: &K::Vertices| self.can_collide.allows_pair::<K>(vertices);
        if !K::CAN_BE_CONNECTED {
            self.collisions_if(mesh, pairs, until, separations, can_collide, found);
            return;
        }
        let not_connected =
            |vertices: &K::Vertices| can_collide(vertices) && !K::are_connected(mesh, vertices);
        let connected = |vertices: &K::Vertices| can_collide(vertices) && K::are_connected(mesh, vertices);
        let contact = Separation::default().into();
        self.collisions_if(mesh, pairs, until, separations, not_connected, &mut found);
        self.collisions_if(mesh, pairs, until, contact, connected, found);
    }

    fn collisions_if<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        until: f64,
        separations: Separations<'_>,
        can_collide: impl Fn(&K::Vertices) -> bool,
        mut found: impl FnMut([u32; 2], PairCollision<'_, K>),
    ) {
        let inner = self.min_distance.inner();
        let options = Options::within(separations).until(until);
        for_each_chunk::<K>(mesh, pairs, can_collide, |ids, queries| {
            self.trajectories
                .collisions::<K>(queries, options, |index, collision| {
                    found(ids[index], PairCollision::new(collision, inner, until));
                })
                .expect("a mesh has the vertices of its primitives, and each has a thickness");
        });
    }

    /// Calls `found` with the vertices and the query of each pair that [`collisions`](Self::collisions)
    /// decides.
    pub(crate) fn queries<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        mut found: impl FnMut(&K::Vertices, Query<K>),
    ) {
        for vertices in pairs.iter().filter_map(|&ids| K::vertices(mesh, ids)) {
            if self.can_collide.allows_pair::<K>(&vertices)
                && let Some(query) = self.trajectories.query::<K>(vertices)
            {
                found(&vertices, query);
            }
        }
    }
}

/// The narrow phase of a step, as a receiver of candidates.
pub(crate) struct Examiner<'a, C> {
    pub(crate) narrow_phase: &'a NarrowPhase,
    pub(crate) mesh: &'a TriangleMesh,
    pub(crate) collector: &'a C,
}

impl<C: Collect> Receive for Examiner<'_, C> {
    fn receive<K: Searched>(&self, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        self.narrow_phase
            .examine::<K, C>(self.mesh, pairs, self.collector)
    }
}

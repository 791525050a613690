//! The narrow phase: exact tests of candidates, in batches.

use exact_ccd::Collision;
use exact_ccd::batch::Trajectories;

use crate::can_collide::CanCollide;
use crate::mesh::TriangleMesh;
use crate::pair::PairKind;
use crate::step::Step;

/// Exact tests of the candidates of a step, in batches.
#[derive(Clone, Debug)]
pub(crate) struct NarrowPhase {
    can_collide: CanCollide,
    trajectories: Trajectories,
}

/// The number of pairs in a batch.
const CHUNK: usize = 256;

impl NarrowPhase {
    /// A narrow phase without a step, for the pairs that can collide.
    pub(crate) fn new(can_collide: CanCollide) -> Self {
        let trajectories =
            Trajectories::new(&[], &[]).expect("there are as many positions at both ends: none");
        Self {
            can_collide,
            trajectories,
        }
    }

    /// The narrow phase of a step, for all pairs.
    pub(crate) fn of(step: &Step<'_>) -> Self {
        let mut narrow_phase = Self::new(CanCollide::all());
        narrow_phase.begin(step);
        narrow_phase
    }

    /// Takes the positions of another step.
    pub(crate) fn begin(&mut self, step: &Step<'_>) {
        let [x0, x1] = step.positions();
        self.trajectories
            .set(x0, x1)
            .expect("a step has as many positions at both ends, and all are finite");
    }

    pub(crate) fn can_collide(&self) -> &CanCollide {
        &self.can_collide
    }

    pub(crate) fn trajectories(&self) -> &Trajectories {
        &self.trajectories
    }

    /// Calls `found` with each pair that is in contact, and its collision.
    ///
    /// Pairs with a common vertex are left out, as are those that cannot collide and those that
    /// `mesh`, the mesh of the step, does not have.
    pub(crate) fn collisions<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        found: impl FnMut([u32; 2], Collision<'_, K>),
    ) {
        // Two copies of the loop: the usual one has no call of a predicate.
        if self.can_collide.is_all() {
            self.collisions_if(mesh, pairs, K::are_apart, found);
        } else {
            let can_collide = |four: &[u32; 4]| {
                let (a, b) = four.split_at(K::FIRST);
                K::are_apart(four) && self.can_collide.allows(a, b)
            };
            self.collisions_if(mesh, pairs, can_collide, found);
        }
    }

    fn collisions_if<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
        can_collide: impl Fn(&[u32; 4]) -> bool,
        mut found: impl FnMut([u32; 2], Collision<'_, K>),
    ) {
        let (mut kept, mut vertices) = ([[0; 2]; CHUNK], [[0; 4]; CHUNK]);
        for pairs in pairs.chunks(CHUNK) {
            let mut count = 0;
            for &ids in pairs {
                if let Some(four) = K::vertices(mesh, ids) {
                    // Without a branch: about half of all pairs from a broad phase are neighbours
                    // in the mesh.
                    (kept[count % CHUNK], vertices[count % CHUNK]) = (ids, four);
                    count += usize::from(can_collide(&four));
                }
            }
            self.trajectories
                .collisions::<K>(&vertices[..count], |index, collision| {
                    found(kept[index], collision);
                })
                .expect("a mesh has the vertices of its primitives");
        }
    }
}

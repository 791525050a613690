//! Which candidates are in contact.

use exact_ccd::Collision;
use exact_ccd::batch::Trajectories;

use crate::kind::PairKind;
use crate::mesh::TriangleMesh;
use crate::step::Step;

/// What is asked about candidates, laid out for many of them.
#[derive(Clone, Debug)]
pub(crate) struct NarrowPhase<'a> {
    mesh: &'a TriangleMesh,
    trajectories: Trajectories,
}

/// How many pairs are looked up at a time.
const CHUNK: usize = 256;

impl<'a> NarrowPhase<'a> {
    /// Nothing can be asked before there is a step.
    pub(crate) fn new(mesh: &'a TriangleMesh) -> Self {
        let trajectories = Trajectories::new(&[], &[]).expect("as many positions as positions");
        Self { mesh, trajectories }
    }

    /// Takes another step of the mesh.
    pub(crate) fn begin(&mut self, step: &Step<'_>) {
        let [x0, x1] = step.positions();
        self.trajectories
            .set(x0, x1)
            .expect("the positions of a step are sound");
    }

    /// Calls `found` with each pair that is in contact, and its collision. Pairs with a common vertex are left out.
    pub(crate) fn collisions<K: PairKind>(
        &self,
        pairs: &[[u32; 2]],
        mut found: impl FnMut([u32; 2], Collision<'_, K>),
    ) {
        let (mut kept, mut vertices) = ([[0; 2]; CHUNK], [[0; 4]; CHUNK]);
        for pairs in pairs.chunks(CHUNK) {
            let mut count = 0;
            for &ids in pairs {
                if let Some(four) = K::vertices(self.mesh, ids) {
                    // Without a branch: about half of all pairs that are found near each other are neighbours in the mesh.
                    (kept[count % CHUNK], vertices[count % CHUNK]) = (ids, four);
                    count += usize::from(K::are_apart(&four));
                }
            }
            self.trajectories
                .collisions(&vertices[..count], |index, collision| {
                    found(kept[index], collision)
                })
                .expect("a mesh has the vertices of its primitives");
        }
    }
}

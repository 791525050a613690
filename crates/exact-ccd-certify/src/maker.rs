//! The maker of certificates.

use exact_ccd::{Point, Separation, Separations};
use exact_ccd_check::certificate::{CONTACT, FREE, MAGIC, REST};
use exact_ccd_check::grid::Grid;
use exact_ccd_check::motion::Motion;
use exact_ccd_check::{Kind, Mesh, tree};
use exact_ccd_mesh::{Contact, MinDistance, Pair, StepError, TriangleMesh};
use rayon::prelude::*;

use crate::stretches::Step;
use crate::{contact, encode};

/// A certificate in the making: steps are added in the order of time.
#[derive(Clone, Debug)]
pub struct Maker {
    bytes: Vec<u8>,
    pub(crate) distance: Separation,
    steps: usize,
    uncertified: Uncertified,
}

/// The reason why a step cannot be added.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MakerError {
    /// The positions are no step, or an edge passes through a face at its start.
    #[error(transparent)]
    Step(#[from] StepError),
    /// Only some pairs can collide, or not all keep the same distance.
    #[error(
        "a certificate is about all pairs and one distance: leave out rules and groups, thicknesses and the inner distance"
    )]
    Rules,
}

/// The pairs for which no proof was found.
#[derive(Clone, Debug, Default, PartialEq, Eq, thiserror::Error)]
#[error(
    "{missing} of {pairs} pairs not certified{}: a shorter step, or a smaller distance, may have a certificate",
    first.as_ref().map(|first| format!(", the first of them {first}")).unwrap_or_default()
)]
pub struct Uncertified {
    /// The number of pairs without a proof.
    pub missing: usize,
    /// The number of pairs that boxes do not separate, and that need a proof.
    pub pairs: usize,
    /// The first pair without a proof, by name.
    pub first: Option<String>,
}

impl Uncertified {
    fn add(&mut self, kind: Kind, [a, b]: [u32; 2]) {
        let [first, second] = kind.names();
        self.missing += 1;
        self.first
            .get_or_insert_with(|| format!("{first} {a} and {second} {b}"));
    }
}

impl Maker {
    /// A certificate without steps, about a distance, which is 0 for contact.
    #[must_use]
    pub fn new(distance: Separation) -> Self {
        let mut maker = Self::continued(distance);
        maker.bytes = [MAGIC, &distance.get().to_le_bytes()].concat();
        maker
    }

    /// A part without steps, to be written behind a certificate for the same distance, or behind another
    /// part of it. All parts together are, byte for byte, the certificate of all steps.
    #[must_use]
    pub fn continued(distance: Separation) -> Self {
        Self {
            bytes: Vec::new(),
            distance,
            steps: 0,
            uncertified: Uncertified::default(),
        }
    }

    /// The distance of a certificate, if all pairs keep the same.
    ///
    /// # Errors
    /// [`MakerError::Rules`] if they do not.
    pub fn distance(min_distance: &MinDistance) -> Result<Separation, MakerError> {
        match min_distance.separations() {
            Separations::Uniform(d) if min_distance.inner().is_none() => Ok(d),
            _ => Err(MakerError::Rules),
        }
    }

    /// The number of steps that have been added.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Adds the step of a mesh from the first positions to the second: that it is free until its
    /// earliest contact, and has that contact; and, with `rest`, that no edge pierces a face at its
    /// start.
    ///
    /// # Errors
    /// [`MakerError::Step`], if there are too many or too few positions, or one is not finite.
    pub fn add_step(
        &mut self,
        mesh: &TriangleMesh,
        positions: [&[Point]; 2],
        rest: bool,
        earliest: Option<&Contact>,
    ) -> Result<(), MakerError> {
        exact_ccd_mesh::Step::new(mesh, positions[0], positions[1])?;
        let [free, contact] = times(earliest);
        let distance = self.distance.get();
        let motion = Motion::new(positions[0], positions[1], distance).expect("a step has finite positions");
        let mesh = Mesh::new(positions[0].len(), mesh.faces().to_vec(), mesh.loose_edges())
            .expect("a step has the vertices of its mesh");
        self.steps += 1;
        let flag = |is_on: bool, flag: u8| if is_on { flag } else { 0 };
        self.bytes
            .push(flag(rest, REST) | flag(free.is_some(), FREE) | flag(contact.is_some(), CONTACT));
        for time in [free, contact].into_iter().flatten() {
            self.bytes.extend(time.to_le_bytes());
        }
        let until = free.unwrap_or(0.0);
        if rest || free.is_some() {
            let grid = Grid::new(&motion, until);
            let step = Step {
                motion: &motion,
                grid: &grid,
                positions,
                distance,
                until,
            };
            if rest {
                self.add_table(&mesh, &step, Kind::EdgeFace);
            }
            for kind in Kind::ALL.into_iter().take(4).filter(|_| free.is_some()) {
                self.add_table(&mesh, &step, kind);
            }
        }
        if let (Some(earliest), Some(time)) = (earliest, contact) {
            let kind = match earliest.pair {
                Pair::VertexFace { .. } => Kind::VertexFace,
                Pair::EdgeEdge { .. } => Kind::EdgeEdge,
                Pair::VertexEdge { .. } => Kind::VertexEdge,
                Pair::VertexVertex { .. } => Kind::VertexVertex,
            };
            let ids = earliest.pair.ids();
            let pair = mesh.pair(kind, &ids);
            let proof = pair.and_then(|pair| contact::proof(&motion, kind, &pair, [until, time]));
            self.uncertified.pairs += 1;
            match proof {
                Some(proof) => encode::contact(&mut self.bytes, kind, ids, &proof),
                None => self.uncertified.add(kind, ids),
            }
        }
        Ok(())
    }

    /// Adds the proofs of one kind of pairs.
    fn add_table(&mut self, mesh: &Mesh, step: &Step<'_>, kind: Kind) {
        let mut needed = Vec::new();
        tree::pairs(mesh, step.grid, kind, |ids| {
            needed.push(ids);
            true
        });
        needed.par_sort_unstable();
        let proof = |&ids: &[u32; 2]| encode::stretches(&step.stretches(kind, &mesh.pair(kind, &ids)?)?);
        let proofs: Vec<Option<Box<[u8]>>> = needed.par_iter().map(proof).collect();
        encode::number(&mut self.bytes, needed.len() as u32);
        let mut last = None;
        for (ids, proof) in needed.iter().zip(&proofs) {
            match proof {
                Some(proof) => {
                    encode::ids(&mut self.bytes, last, *ids);
                    self.bytes.extend(proof);
                    last = Some(*ids);
                }
                None => self.uncertified.add(kind, *ids),
            }
        }
        self.uncertified.pairs += needed.len();
    }

    /// The certificate.
    ///
    /// # Errors
    /// The number of pairs for which no proof was found, if there are any: the certificate would be refused.
    pub fn finish(self) -> Result<Vec<u8>, Uncertified> {
        if self.uncertified.missing > 0 {
            Err(self.uncertified)
        } else {
            Ok(self.bytes)
        }
    }
}

/// The last f64 before the earliest contact, and the first that is not before it. Without a contact,
/// the end of the step; if it is at t = 0, no f64 is before it.
fn times(earliest: Option<&Contact>) -> [Option<f64>; 2] {
    match earliest.map(|contact| contact.impact.time) {
        None => [Some(1.0), None],
        Some(time) if time.is_start() => [None, Some(0.0)],
        Some(time) if time.is_exact() => [Some(time.lower().next_down()), Some(time.lower())],
        Some(time) => [Some(time.lower()), Some(time.upper())],
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd_mesh::PositionsError;

    use super::*;

    #[test]
    fn a_step_has_as_many_positions_as_its_mesh_has_vertices() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (vertex_count, positions) in [(3, &points[..]), (4, &points[..3])] {
            let mesh = TriangleMesh::with_edges(vertex_count, vec![[0, 1, 2]], &[]).unwrap();
            let mut maker = Maker::new(Separation::ZERO);
            let count = PositionsError::Count {
                positions: positions.len(),
                vertex_count,
            };
            assert_eq!(
                maker.add_step(&mesh, [positions; 2], true, None),
                Err(MakerError::Step(StepError::Start(count)))
            );
            assert_eq!(maker.steps(), 0);
        }
    }
}

//! The distance of each vertex to the rest of the mesh.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use exact_ccd::{Kind, Options, Point, Query, Separation};

use super::detector::{Begun, Detector};
use super::narrow_phase::NarrowPhase;
use crate::mesh::TriangleMesh;
use crate::pairs::{Receive, Searched};
use crate::steps::StepError;

impl Detector {
    /// The clearance of each vertex at rest: the least distance of a [`Pair`] whose primitives have the
    /// vertex, or the cut-off, if all are farther apart. It is the largest f64 that is not above.
    ///
    /// The pairs of a vertex are the vertex with a face, a face of the vertex with another vertex, and an
    /// edge of the vertex with another edge; with points and rods, also the others that [`Pair`] lists. If
    /// each vertex moves by less than half of its clearance, on whatever path, the motion is free of
    /// contact: no point of a primitive moves farther than one of its vertices, which is less than half of
    /// the distance of any of its pairs.
    ///
    /// The cost grows with the number of pairs within the cut-off, which should be about twice the largest
    /// displacement of interest.
    ///
    /// ```
    /// use exact_ccd::Separation;
    /// use exact_ccd_mesh::{Detector, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(5, vec![[0, 1, 2]])?;
    /// let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let x = [&floor[..], &[[0.25, 0.25, 0.5], [5.0, 0.0, 1.0]]].concat();
    ///
    /// let clearances = Detector::new(mesh).clearances(&x, Separation::new(2.0)?)?;
    /// assert_eq!(clearances, [0.5, 0.5, 0.5, 0.5, 2.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or, with the check of the
    /// start, the edge that passes through a face.
    ///
    /// [`Pair`]: crate::Pair
    pub fn clearances(&mut self, x: &[Point], cut_off: Separation) -> Result<Vec<f64>, StepError> {
        let Begun { step, search, .. } = self.begin(x, x, Options::within(cut_off))?;
        let least = Clearances::new(x.len(), cut_off);
        search.pass_within(&step, cut_off, |narrow_phase| Measured {
            narrow_phase,
            mesh: step.mesh(),
            least: &least,
        });
        Ok(least.into_values())
    }
}

/// The least distances of the pairs so far, for each vertex.
struct Clearances {
    /// Their bits, which are in the order of the numbers.
    least: Vec<AtomicU64>,
}

impl Clearances {
    fn new(vertex_count: usize, cut_off: Separation) -> Self {
        let bits = cut_off.get().to_bits();
        Self {
            least: (0..vertex_count).map(|_| AtomicU64::new(bits)).collect(),
        }
    }

    fn into_values(self) -> Vec<f64> {
        let bits = self.least.into_iter().map(AtomicU64::into_inner);
        bits.map(f64::from_bits).collect()
    }

    /// The distance below which a pair matters.
    fn of(&self, vertices: &[u32]) -> f64 {
        let bits = vertices
            .iter()
            .map(|&vertex| self.least[vertex as usize].load(Ordering::Relaxed));
        f64::from_bits(bits.max().unwrap_or_default())
    }

    /// Takes a pair at rest.
    fn add<K: Kind>(&self, vertices: &[u32], query: &Query<K>) {
        // Most pairs are farther apart than the clearances of their vertices so far; filters prove it.
        let Ok(most) = Separation::new(self.of(vertices)) else {
            return;
        };
        if !query.collides(most) {
            return;
        }
        let Ok(distance) = query.distance_at(0.0) else {
            return;
        };
        for &vertex in vertices {
            self.least[vertex as usize].fetch_min(distance.lower.to_bits(), Ordering::Relaxed);
        }
    }
}

/// The narrow phase of a mesh at rest, as a receiver of candidates whose distances it computes.
struct Measured<'a> {
    narrow_phase: &'a NarrowPhase,
    mesh: &'a TriangleMesh,
    least: &'a Clearances,
}

impl Receive for Measured<'_> {
    fn receive<K: Searched>(&self, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        self.narrow_phase
            .queries::<K>(self.mesh, pairs, |vertices, query| {
                self.least.add(vertices.as_ref(), &query);
            });
        ControlFlow::Continue(())
    }
}

//! A step for every vertex: certified to be free of contact.

use exact_ccd::{Options, Point};

use super::error::LineSearchError;
use super::free_step::certified;
use super::options::FreeStepOptions;
use super::sizes::Sizes;
use super::watched::Watch;
use crate::pairs::Pair;
use crate::search::{CulledSearch, Detector};
use crate::steps::Step;

/// A part of a step for each vertex, such that together they are free of contact.
///
/// The straight motion from the start to `positions` has been decided exactly, for the positions as they
/// are, rounded: the pairs in `blocked` touch, and no others.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeSteps {
    /// The part of its displacement that each vertex takes, from 0 to 1. It is 1 if the vertex is pinned, or
    /// if no contact held it back in any round and there are fewer than 64 rounds.
    pub sizes: Vec<f64>,
    /// The positions at the ends of these parts, as [`Step::at`] computes them, vertex by vertex, in the
    /// [`Precision`](super::Precision) of the options.
    pub positions: Vec<Point>,
    /// The pairs that touch, whatever the sizes of the vertices that are not pinned. They touch at the
    /// start, or all of their vertices that are not pinned stay at the start. Sorted.
    pub blocked: Vec<Pair>,
    /// The number of rounds, without the searches that certify the common step, where it is needed.
    pub rounds: usize,
}

/// The round from which on a contact brings the vertices that it holds back to the least size.
const LAST_FALL: usize = 32;

/// The round from which on a contact brings all vertices to the least size.
const LAST_OF_SOME: usize = 64;

impl Detector {
    /// A step for each vertex, from positions `x0` towards positions `x1`, such that the motion of all
    /// vertices is certified to be free of contact.
    ///
    /// In each round, the step to the positions so far is searched for contact. A contact at time t holds
    /// back the vertices that approach the other primitive, to first order: in the k-th round that does so,
    /// their sizes are multiplied by t `keep`ᵏ, and by the least of these factors if several contacts hold a
    /// vertex back. The next round searches the pairs that have a vertex that was held back. The last one
    /// finds no contact, which is the certificate.
    ///
    /// No size falls below the size that [`free_step`](Self::free_step) returns, to which the step of all
    /// vertices is certified. So the rounds end: from round 32 on, a contact brings vertices to that size,
    /// and from round 64 on, all that are not pinned.
    ///
    /// `pinned` are vertices that go all the way, such as the vertices of obstacles and scripts. If there
    /// are any, the least size of the others is 0, and a pair that touches nonetheless is reported as
    /// blocked.
    ///
    /// ```
    /// use exact_ccd_mesh::{Detector, FreeStepOptions, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(5, vec![[0, 1, 2]])?;
    /// let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let x0 = [&floor[..], &[[0.25, 0.25, 1.0], [5.0, 0.0, 1.0]]].concat();
    /// let x1 = [&floor[..], &[[0.25, 0.25, -1.0], [5.0, 0.0, -1.0]]].concat();
    ///
    /// // Vertex 3 stops above the face; vertex 4 passes by.
    /// let options = FreeStepOptions::default().with_keep(0.5);
    /// let steps = Detector::new(mesh).free_steps(&x0, &x1, &[], &options)?;
    /// assert_eq!(steps.sizes, [1.0, 1.0, 1.0, 0.25, 1.0]);
    /// assert_eq!(steps.positions[3], [0.25, 0.25, 0.5]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`free_step`](Self::free_step); [`LineSearchError::Pinned`] names a pinned vertex that is not one
    /// of the mesh.
    pub fn free_steps(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        pinned: &[u32],
        options: &FreeStepOptions<'_>,
    ) -> Result<FreeSteps, LineSearchError> {
        let mut begun = self.begin(x0, x1, Options::within(options.min_distance.clone()))?;
        let taken = free_steps(begun.search, begun.step, pinned, options)?;
        if taken.blocked.is_empty() {
            begun.found_free(&taken.positions);
        }
        Ok(taken)
    }
}

fn free_steps(
    search: &mut CulledSearch,
    step: Step<'_>,
    pinned: &[u32],
    options: &FreeStepOptions<'_>,
) -> Result<FreeSteps, LineSearchError> {
    let keep = options.checked(&step)?;
    let watch = Watch::new(options);
    let mut sizes = Sizes::new(step, pinned, options.precision)?;
    let mut is_least_certified = !pinned.is_empty();
    let (mut kept, mut rounds, mut blocked) = (1.0, 0, Vec::new());
    loop {
        let (times, stuck) = sizes.search(search, &options.min_distance, &watch)?;
        rounds += 1;
        let earliest = times.iter().copied().fold(f64::INFINITY, f64::min);
        if stuck.is_empty() && earliest == f64::INFINITY {
            break;
        }
        if rounds == 1 && pinned.is_empty() {
            // The common step is not larger. It is certified only if it is needed.
            sizes.set_least(keep * earliest);
        }
        if !stuck.is_empty() && !is_least_certified {
            let common = certified(search, step, sizes.least(), |size| step.at(size), options, &watch)?;
            sizes.set_least(common.map_or(0.0, |(size, _)| size));
            is_least_certified = true;
            continue;
        }
        blocked.extend(stuck);
        kept = if rounds < LAST_FALL { kept * keep } else { 0.0 };
        if rounds < LAST_OF_SOME {
            sizes.hold_back(&times, kept);
        } else {
            sizes.hold_all_back();
        }
    }
    blocked.sort_unstable();
    let Sizes { sizes, positions, .. } = sizes;
    Ok(FreeSteps {
        sizes,
        positions,
        blocked,
        rounds,
    })
}

//! The step that a solver can take: certified to be free of contact.

use exact_ccd::{Options, Point};

use super::advance::advance;
use super::error::LineSearchError;
use super::options::FreeStepOptions;
use super::precision::Precision;
use super::watched::{Watch, watched};
use crate::mesh::check_positions;
use crate::pairs::PairCounts;
use crate::search::{AnyContact, Contact, CulledSearch, Detector, Earliest};
use crate::steps::Step;

/// A step that is free of contact, for the minimum distance of the options.
///
/// Unless `size` is 0, the straight motion from the start to `positions`, as they are after rounding, has
/// been checked exactly to be free of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeStep {
    /// The part of the full step that is taken, from 0 to 1; at most the time of impact of the full
    /// step. It is 1 if the full step is free of contact, also to its rounded end. It is 0 if none of the
    /// sizes that are tried is certified: the mesh touches itself at the start, or is nearer to itself
    /// there than rounded positions are to the path. If it is tiny, the rounded positions may equal the
    /// start.
    pub size: f64,
    /// The positions at its end, in the [`Precision`](super::Precision) of the options: the start if the
    /// size is 0, and the end of the full step if it is 1.
    pub positions: Vec<Point>,
    /// The earliest contact of the full step, or `None` if the full step is free of contact.
    pub contact: Option<Contact>,
    /// The numbers of pairs that touch at the start: pairs within their minimum distance, even if an [inner
    /// one](crate::MinDistance::with_inner) holds for them.
    pub touching: PairCounts,
}

impl Detector {
    /// A step from positions `x0` towards positions `x1` that is certified to be free of contact.
    ///
    /// The size is 1 if the full step is free, otherwise `keep` times the largest f64 not above its time of
    /// impact, the product rounded to nearest. The positions there, by [`Step::at`], are rounded to the
    /// [`Precision`](super::Precision) of the options, and the step from `x0` to them is checked exactly.
    /// If it is not free, the f64 1, 2, 4, … places below the first size are tried, until one is free or
    /// the size is 0; in single precision, 2²⁹, 2³⁰, … places.
    ///
    /// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact, and the
    /// size is 1: without [`with_start_check`](Self::with_start_check), this is not found.
    ///
    /// ```
    /// use exact_ccd::CONTACT;
    /// use exact_ccd_mesh::{Detector, FreeStepOptions, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
    /// let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
    /// let mut x1 = x0;
    /// x1[3][2] = -1.0;
    ///
    /// let mut detector = Detector::new(mesh);
    /// let step = detector.free_step(&x0, &x1, &FreeStepOptions::default().with_keep(0.5))?;
    /// assert_eq!((step.size, step.positions[3]), (0.25, [0.25, 0.25, 0.5]));
    /// assert!(!detector.collides(&x0, &step.positions, CONTACT)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LineSearchError`] names the positions that are too many, too few or not finite, or a
    /// fraction to keep that is out of range, or, with the check of the start, the edge that passes through
    /// a face; it is [`LineSearchError::Cancelled`] if the search was cancelled.
    pub fn free_step(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: &FreeStepOptions<'_>,
    ) -> Result<FreeStep, LineSearchError> {
        let mut begun = self.begin(x0, x1, Options::within(options.min_distance.clone()))?;
        let step = begun.step;
        let taken = free_step(begun.search, step, |size| step.at(size), options)?;
        begun.found_free(&taken.positions);
        Ok(taken)
    }

    /// [`free_step`](Self::free_step) from positions `x0` towards `x0` + `direction`. The function
    /// [`advance`] computes the positions at a size α: x₀ + fl(α d), rounded.
    ///
    /// # Errors
    /// As [`free_step`](Self::free_step); [`LineSearchError::Direction`] names the part of the
    /// direction that is wrong.
    pub fn free_step_along(
        &mut self,
        x0: &[Point],
        direction: &[Point],
        options: &FreeStepOptions<'_>,
    ) -> Result<FreeStep, LineSearchError> {
        check_positions(self.mesh().vertex_count(), direction).map_err(LineSearchError::Direction)?;
        let x1 = advance(x0, direction, 1.0);
        let mut begun = self.begin(x0, &x1, Options::within(options.min_distance.clone()))?;
        let taken = free_step(
            begun.search,
            begun.step,
            |size| advance(x0, direction, size),
            options,
        )?;
        begun.found_free(&taken.positions);
        Ok(taken)
    }
}

/// The free step of a step, with the memory of a search.
fn free_step(
    search: &mut CulledSearch,
    step: Step<'_>,
    at: impl Fn(f64) -> Vec<Point>,
    options: &FreeStepOptions<'_>,
) -> Result<FreeStep, LineSearchError> {
    let keep = options.checked(&step)?;
    let watch = Watch::new(options);
    let earliest = watched(Earliest::with_touching(), &watch, |watched| {
        search.run_keeping(&step, &options.min_distance, watched);
    })?;
    let [x0, x1] = step.positions();
    let contact = earliest.contact();
    let touching = earliest.touching();
    let free = |size, positions| FreeStep {
        size,
        positions,
        contact,
        touching,
    };
    if contact.is_none() && options.precision.first_other(x1).is_none() {
        return Ok(free(1.0, x1.to_vec()));
    }
    let first = contact.map_or(1.0, |contact| keep * contact.impact.time.lower());
    Ok(match certified(search, step, first, at, options, &watch)? {
        Some((size, positions)) => free(size, positions),
        None => free(0.0, x0.to_vec()),
    })
}

/// The first f64 to which the step is free, with the rounded positions there: `first`, or the f64 1, 2, 4, …
/// times [`first_retreat`](super::Precision::first_retreat) places below it. `None` if the step is free to
/// none of them.
pub(super) fn certified(
    search: &mut CulledSearch,
    step: Step<'_>,
    first: f64,
    at: impl Fn(f64) -> Vec<Point>,
    options: &FreeStepOptions<'_>,
    watch: &Watch<'_>,
) -> Result<Option<(f64, Vec<Point>)>, LineSearchError> {
    let [x0, _] = step.positions();
    let (mut size, mut retreat) = (first, options.precision.first_retreat());
    // By its bits: a comparison may read a subnormal number as zero, and a difference may be flushed to
    // zero.
    while size.to_bits() > 0 {
        let positions = options.precision.rounded(at(size));
        let shorter = Step::new(step.mesh(), x0, &positions)?;
        let any = AnyContact::new(1.0, &|_| true);
        let contact = watched(any, watch, |watched| match options.precision {
            Precision::Double => search.run_in_part(&shorter, &options.min_distance, watched),
            // These positions are farther off the path than a part of the step may be.
            Precision::Single => search.run(&shorter, &options.min_distance, watched),
        })?;
        if !contact.is_found() {
            return Ok(Some((size, positions)));
        }
        size = f64::from_bits(first.to_bits().saturating_sub(retreat));
        retreat = retreat.saturating_mul(2);
    }
    Ok(None)
}

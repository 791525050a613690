//! Detectors: contact in the steps of one mesh.

use exact_ccd::{Options, Point};
use exact_ccd_mesh::{FreeStepOptions, MinDistance};

use crate::border::call;
use crate::error::{Error, Status};
use crate::mesh::Mesh;
use crate::pointers::{Out, ends, free, reference, reference_mut};
use crate::threads::Threads;

/// Finds contact in successive steps of one mesh. It keeps memory from step to step, and no answer
/// depends on earlier steps.
pub struct Detector {
    pub(crate) inner: exact_ccd_mesh::Detector,
    /// The distance at which primitives touch.
    pub(crate) min_distance: MinDistance,
    pub(crate) threads: Threads,
}

impl Detector {
    /// Replaces the minimum distance. In case of an error, the detector keeps the one it has.
    pub(crate) fn set_min_distance(&mut self, min_distance: MinDistance) -> Result<(), Error> {
        min_distance.check(self.inner.mesh())?;
        self.min_distance = min_distance;
        Ok(())
    }

    /// The minimum distance, and the whole step.
    pub(crate) fn options(&self) -> Options<MinDistance> {
        Options::within(self.min_distance.clone())
    }

    /// The minimum distance, and the part of the time of impact that a certified step keeps.
    pub(crate) fn free_step_options(&self, keep: f64) -> FreeStepOptions<'static> {
        let options = FreeStepOptions::default().with_keep(keep);
        options.with_min_distance(self.min_distance.clone())
    }

    /// The result of a computation with the detector, on its threads.
    pub(crate) fn run<T: Send>(
        &mut self,
        compute: impl FnOnce(&mut exact_ccd_mesh::Detector) -> Result<T, Error> + Send,
    ) -> Result<T, Error> {
        let Self { inner, threads, .. } = self;
        threads.run(|| compute(inner))
    }
}

/// A detector, and the positions at both ends of a step.
///
/// # Safety
/// As for [`reference_mut`] and [`ends`].
pub(crate) unsafe fn with_ends<'a>(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
) -> Result<(&'a mut Detector, [&'a [Point]; 2]), Error> {
    // SAFETY: the caller's promise.
    Ok(unsafe { (reference_mut("detector", detector)?, ends(x0, x1, vertex_count)?) })
}

/// The detector for steps of a mesh, to be freed with `exact_ccd_detector_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_new(mesh: *const Mesh, detector: *mut *mut Detector) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Mesh(mesh), detector) = unsafe { (reference("mesh", mesh)?, Out::new("detector", detector)?) };
        detector.give(Detector {
            inner: exact_ccd_mesh::Detector::new(mesh.clone()),
            min_distance: MinDistance::default(),
            threads: Threads::default(),
        });
        Ok(())
    })
}

/// Frees a detector. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_free(detector: *mut Detector) {
    // SAFETY: the caller's promise.
    unsafe { free(detector) }
}

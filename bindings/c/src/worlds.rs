//! Steps of many worlds, which have one mesh and positions of their own.

use exact_ccd::Point;
use exact_ccd_mesh::FreeStepOptions;
use rayon::prelude::*;

use crate::border::call;
use crate::contact::Contact;
use crate::detector::Detector;
use crate::error::{Error, Status};
use crate::pointers::{array, fill, places, reference};

/// The positions of worlds: as many for each as there are vertices.
struct Worlds<'a> {
    x0: &'a [Point],
    x1: &'a [Point],
    vertex_count: usize,
    world_count: usize,
}

impl<'a> Worlds<'a> {
    /// # Safety
    /// As for [`array`], with `vertex_count` times `world_count` points in both arrays.
    unsafe fn new(
        x0: *const f64,
        x1: *const f64,
        vertex_count: usize,
        world_count: usize,
    ) -> Result<Self, Error> {
        let count = vertex_count.checked_mul(world_count).unwrap_or(usize::MAX);
        // SAFETY: the caller's promise.
        let (x0, x1) = unsafe { (array("x0", x0.cast(), count)?, array("x1", x1.cast(), count)?) };
        Ok(Self {
            x0,
            x1,
            vertex_count,
            world_count,
        })
    }

    /// The results of `work` for the positions of each world, or the error of the first world that has
    /// one. A thread keeps a detector from world to world.
    fn each<T: Send>(
        &self,
        detector: &Detector,
        work: impl Fn(&mut exact_ccd_mesh::Detector, &'a [Point], &'a [Point]) -> Result<T, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        let own = || detector.inner.clone();
        let answer = |detector: &mut exact_ccd_mesh::Detector, world: usize| {
            let of_world = |x: &'a [Point]| &x[world * self.vertex_count..][..self.vertex_count];
            let answer = work(detector, of_world(self.x0), of_world(self.x1));
            answer.map_err(|error| error.of_world(world))
        };
        detector.threads.run(|| {
            let worlds = (0..self.world_count).into_par_iter();
            let answers: Vec<_> = worlds.map_init(own, answer).collect();
            answers.into_iter().collect()
        })
    }
}

/// `exact_ccd_detector_is_free` for each of `world_count` worlds, with the mesh and the settings of the
/// detector.
///
/// `x0` and `x1` have the positions of the `vertex_count` vertices of the first world, then those of
/// the next, and so on. `is_free` has room for `world_count` results. The message of an error names the
/// first world that is wrong, from 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_is_free(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    is_free: *mut bool,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, worlds, is_free) = unsafe {
            let detector = reference("detector", detector)?;
            let worlds = Worlds::new(x0, x1, vertex_count, world_count)?;
            (detector, worlds, places("is_free", is_free, world_count)?)
        };
        let options = detector.options();
        let free = worlds.each(detector, |detector, x0, x1| {
            Ok(!detector.collides(x0, x1, options.clone())?)
        })?;
        fill(is_free, free);
        Ok(())
    })
}

/// `exact_ccd_detector_earliest_contact` for each world; `is_found` and `contacts` have room for
/// `world_count` results, and a contact is written only where one is found. Other arguments as in
/// `exact_ccd_worlds_is_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_earliest_contact(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    is_found: *mut bool,
    contacts: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, worlds, is_found, contacts) = unsafe {
            let detector = reference("detector", detector)?;
            let worlds = Worlds::new(x0, x1, vertex_count, world_count)?;
            let is_found = places("is_found", is_found, world_count)?;
            (
                detector,
                worlds,
                is_found,
                places("contacts", contacts, world_count)?,
            )
        };
        let options = detector.options();
        let found = worlds.each(detector, |detector, x0, x1| {
            let earliest = detector.collision(x0, x1, options.clone())?;
            Ok(earliest.map(|earliest| Contact::of(detector.mesh(), [x0, x1], &earliest)))
        })?;
        fill(is_found, found.iter().map(Option::is_some));
        for (place, contact) in contacts.iter_mut().zip(found) {
            if let Some(contact) = contact {
                place.write(contact);
            }
        }
        Ok(())
    })
}

/// `exact_ccd_detector_free_step` for each world: `sizes` has room for `world_count` numbers, and
/// `positions` for the points of all worlds. `positions` may be `x0` or `x1`. Other arguments as in
/// `exact_ccd_worlds_is_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_free_step(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    keep: f64,
    sizes: *mut f64,
    positions: *mut f64,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise. The results are written after
        // the last use of the positions, which may be the same memory.
        unsafe {
            let detector = reference("detector", detector)?;
            let options = FreeStepOptions::default().with_keep(keep);
            let options = options.with_min_distance(detector.min_distance.clone());
            let steps = {
                let worlds = Worlds::new(x0, x1, vertex_count, world_count)?;
                worlds.each(detector, |detector, x0, x1| {
                    Ok(detector.free_step(x0, x1, &options)?)
                })?
            };
            let points = places("positions", positions.cast::<Point>(), vertex_count * world_count)?;
            let sizes = places("sizes", sizes, world_count)?;
            fill(sizes, steps.iter().map(|step| step.size));
            fill(points, steps.into_iter().flat_map(|step| step.positions));
        }
        Ok(())
    })
}

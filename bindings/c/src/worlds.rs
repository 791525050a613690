//! Steps of many worlds, which have one mesh and positions of their own.

use exact_ccd::Point;
use rayon::prelude::*;

use crate::border::call;
use crate::contact::Contact;
use crate::detector::Detector;
use crate::error::{Error, Status};
use crate::lists::Contacts;
use crate::pointers::{Out, ends, fill, fill_some, optional_places, places, reference};

/// A detector, and the positions of worlds: as many for each as there are vertices.
struct Worlds<'a> {
    detector: &'a Detector,
    x0: &'a [Point],
    x1: &'a [Point],
    vertex_count: usize,
    world_count: usize,
}

impl<'a> Worlds<'a> {
    /// # Safety
    /// As for [`reference`] and [`ends`], with `vertex_count` times `world_count` points in both arrays.
    unsafe fn new(
        detector: *const Detector,
        x0: *const f64,
        x1: *const f64,
        vertex_count: usize,
        world_count: usize,
    ) -> Result<Self, Error> {
        let count = vertex_count.saturating_mul(world_count);
        // SAFETY: the caller's promise.
        let (detector, [x0, x1]) = unsafe { (reference("detector", detector)?, ends(x0, x1, count)?) };
        Ok(Self {
            detector,
            x0,
            x1,
            vertex_count,
            world_count,
        })
    }

    /// The results of `work` for the positions of each world, or the error of the first world that has
    /// one.
    fn each<T: Send>(
        &self,
        work: impl Fn(&mut exact_ccd_mesh::Detector, &'a [Point], &'a [Point]) -> Result<T, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        let searches = exact_ccd_mesh::Worlds::default();
        let answer = |world: usize| {
            let of_world = |x: &'a [Point]| &x[world * self.vertex_count..][..self.vertex_count];
            let (x0, x1) = (of_world(self.x0), of_world(self.x1));
            let answer = searches.search(&self.detector.inner, |detector| work(detector, x0, x1));
            answer.map_err(|error| error.of_world(world))
        };
        self.detector.threads.run(|| {
            let worlds = (0..self.world_count).into_par_iter();
            let answers: Vec<_> = worlds.map(answer).collect();
            answers.into_iter().collect()
        })
    }
}

/// `exact_ccd_detector_collides` for each of `world_count` worlds, with the mesh and the settings of the
/// detector.
///
/// `x0` and `x1` have the positions of the `vertex_count` vertices of the first world, then of the next one,
/// and so on. `collides` has room for `world_count` results. The message of an error names the first world
/// that is wrong, from 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_collides(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    until: f64,
    collides: *mut bool,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (worlds, collides) = unsafe {
            let worlds = Worlds::new(detector, x0, x1, vertex_count, world_count)?;
            (worlds, places("collides", collides, world_count)?)
        };
        let options = worlds.detector.options().until(until);
        let found = worlds.each(|detector, x0, x1| Ok(detector.collides(x0, x1, options.clone())?))?;
        fill(collides, found);
        Ok(())
    })
}

/// `exact_ccd_detector_collision` for each world; `collides` and `contacts` have room for `world_count`
/// results, and a contact is written only where `collides` is true. Other arguments as in
/// `exact_ccd_worlds_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_collision(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    until: f64,
    collides: *mut bool,
    contacts: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (worlds, collides, contacts) = unsafe {
            let worlds = Worlds::new(detector, x0, x1, vertex_count, world_count)?;
            let collides = places("collides", collides, world_count)?;
            (worlds, collides, places("contacts", contacts, world_count)?)
        };
        let options = worlds.detector.options().until(until);
        let found = worlds.each(|detector, x0, x1| {
            let earliest = detector.collision(x0, x1, options.clone())?;
            Ok(earliest.map(|earliest| Contact::of(detector.mesh(), [x0, x1], &earliest)))
        })?;
        fill(collides, found.iter().map(Option::is_some));
        fill_some(contacts, found);
        Ok(())
    })
}

/// `exact_ccd_detector_collisions` for each world: one list with the contacts of the first world, then of
/// the next one, and so on. `counts` has room for `world_count` numbers of contacts. Other arguments as in
/// `exact_ccd_worlds_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_worlds_collisions(
    detector: *const Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    world_count: usize,
    until: f64,
    counts: *mut usize,
    contacts: *mut *mut Contacts,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (worlds, counts, contacts) = unsafe {
            let worlds = Worlds::new(detector, x0, x1, vertex_count, world_count)?;
            let counts = places("counts", counts, world_count)?;
            (worlds, counts, Out::new("contacts", contacts)?)
        };
        let options = worlds.detector.options().until(until);
        let found = worlds.each(|detector, x0, x1| {
            let found = detector.collisions(x0, x1, options.clone())?;
            Ok(Contacts::of(detector.mesh(), [x0, x1], &found).0)
        })?;
        fill(counts, found.iter().map(Vec::len));
        contacts.give(Contacts(found.concat()));
        Ok(())
    })
}

/// `exact_ccd_detector_free_step` for each world: `sizes` has room for `world_count` numbers, and
/// `positions` for the points of all worlds. `positions` may be `x0` or `x1`. `collides` and `contacts` are
/// about the full steps, as in `exact_ccd_worlds_collision`; both may be null. Other arguments as in
/// `exact_ccd_worlds_collides`.
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
    collides: *mut bool,
    contacts: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise. The results are written after
        // the last use of the positions, which may be the same memory.
        unsafe {
            let worlds = Worlds::new(detector, x0, x1, vertex_count, world_count)?;
            let options = worlds.detector.free_step_options(keep);
            let steps = worlds.each(|detector, x0, x1| {
                let step = detector.free_step(x0, x1, &options)?;
                let earliest = step
                    .contact
                    .map(|one| Contact::of(detector.mesh(), [x0, x1], &one));
                Ok((step.size, step.positions, earliest))
            })?;
            let points = places("positions", positions.cast::<Point>(), vertex_count * world_count)?;
            let sizes = places("sizes", sizes, world_count)?;
            let collides = optional_places("collides", collides, world_count)?;
            let contacts = optional_places("contacts", contacts, world_count)?;
            fill(sizes, steps.iter().map(|(size, ..)| *size));
            fill(collides, steps.iter().map(|(.., earliest)| earliest.is_some()));
            fill_some(contacts, steps.iter().map(|(.., earliest)| *earliest));
            fill(points, steps.into_iter().flat_map(|(_, positions, _)| positions));
        }
        Ok(())
    })
}

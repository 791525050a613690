//! Single queries.

use exact_ccd::{Options, Query, Separation, with_kind};

use crate::border::call;
use crate::contact::{Impact, Interval};
use crate::error::{Error, Status};
use crate::kind::query_kind;
use crate::pointers::{Out, fill, places, reference};

/// The points of one end of a step: an array of `double[3]`, as many as the kind has.
///
/// # Safety
/// `pointer` is null, or points to the points of a query of kind `K` that nobody changes during the call.
#[inline]
unsafe fn points<'a, K: exact_ccd::Kind>(name: &str, pointer: *const f64) -> Result<&'a K::Points, Error> {
    // SAFETY: `Points` is an array of `[f64; 3]`; the rest is the caller's promise.
    unsafe { reference(name, pointer.cast::<K::Points>()) }
}

/// # Safety
/// As for [`points`].
#[inline]
unsafe fn query<K: exact_ccd::Kind>(x0: *const f64, x1: *const f64) -> Result<Query<K>, Error> {
    // SAFETY: the caller's promise.
    let (x0, x1) = unsafe { (points::<K>("x0", x0)?, points::<K>("x1", x1)?) };
    Ok(Query::new(*x0, *x1)?)
}

/// The distance at which primitives touch, and the last time that counts.
#[inline]
pub(crate) fn options(separation: f64, until: f64) -> Result<Options, Error> {
    if until.is_nan() {
        return Err(Error::argument("until is NaN, expected a time"));
    }
    Ok(Options::within(Separation::new(separation)?).until(until))
}

/// Decides if two primitives touch in a time step: if they come within the distance `separation` of each
/// other, or are in contact if it is 0. Exact.
///
/// `x0` and `x1` are the points of the query, in the order of its kind, at t = 0 and at t = 1; in
/// between, each moves in a straight line. `separation` is a finite number of at least 0. `until` is
/// the last time that counts, 1 for the whole step: primitives that first touch later do not collide.
/// The exact time is compared, not the rounded one; `until` may be any number but NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_collides(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    separation: f64,
    until: f64,
    collides: *mut bool,
) -> Status {
    call(|| {
        let options = options(separation, until)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let collides = Out::new("collides", collides)?;
            with_kind!(query_kind(kind)?, K => {
                collides.write(query::<K>(x0, x1)?.collides(options));
                Ok(())
            })
        }
    })
}

/// The first time at which two primitives touch, rounded down to `double`. It is 0 if they touch at the
/// start, and NaN if they do not collide.
///
/// Arguments as in `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_time_of_impact(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    separation: f64,
    until: f64,
    time: *mut f64,
) -> Status {
    call(|| {
        let options = options(separation, until)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let time = Out::new("time", time)?;
            with_kind!(query_kind(kind)?, K => {
                time.write(query::<K>(x0, x1)?.time_of_impact(options).unwrap_or(f64::NAN));
                Ok(())
            })
        }
    })
}

/// The first time at which two primitives touch, with the closest points and the normal then. `impact`
/// is written only if `collides` is.
///
/// Arguments as in `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_impact(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    separation: f64,
    until: f64,
    collides: *mut bool,
    impact: *mut Impact,
) -> Status {
    call(|| {
        let options = options(separation, until)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let collides = Out::new("collides", collides)?;
            let impact = Out::new("impact", impact)?;
            with_kind!(query_kind(kind)?, K => {
                let found = query::<K>(x0, x1)?.impact(options);
                collides.write(found.is_some());
                if let Some(found) = found {
                    let (x0, x1) = (points::<K>("x0", x0)?, points::<K>("x1", x1)?);
                    impact.write(Impact::of_query::<K>(&found, x0, x1));
                }
                Ok(())
            })
        }
    })
}

/// The times at which two primitives touch: the maximal closed intervals, in increasing order; none if
/// the first is after `until`.
///
/// The first `capacity` intervals are written to `intervals`, which may be null for 0, and their
/// number to `count`, even if that is larger. There are at most 32. Other arguments as in
/// `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_intervals(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    separation: f64,
    until: f64,
    intervals: *mut Interval,
    capacity: usize,
    count: *mut usize,
) -> Status {
    call(|| {
        let options = options(separation, until)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let intervals = places("intervals", intervals, capacity)?;
            let count = Out::new("count", count)?;
            with_kind!(query_kind(kind)?, K => {
                let found = query::<K>(x0, x1)?.intervals(options);
                count.write(found.len());
                fill(intervals, found.iter().map(Interval::from));
                Ok(())
            })
        }
    })
}

/// Bounds of the distance of two primitives at a time of the step, which is in [0, 1]: the nearest
/// `double` that are not above and not below it.
///
/// `upper` is infinite if the distance exceeds all `double`. Other arguments as in
/// `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_distance_at(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    time: f64,
    lower: *mut f64,
    upper: *mut f64,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let lower = Out::new("lower", lower)?;
            let upper = Out::new("upper", upper)?;
            with_kind!(query_kind(kind)?, K => {
                let bounds = query::<K>(x0, x1)?.distance_at(time)?;
                lower.write(bounds.lower);
                upper.write(bounds.upper);
                Ok(())
            })
        }
    })
}

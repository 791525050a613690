//! Single queries.

use exact_ccd::{Options, Query, Separation};

use crate::border::call;
use crate::contact::{Impact, Interval};
use crate::error::{Error, Status};
use crate::kind::with_kind;
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
unsafe fn query<K: exact_ccd::Kind>(points_t0: *const f64, points_t1: *const f64) -> Result<Query<K>, Error> {
    // SAFETY: the caller's promise.
    let (t0, t1) = unsafe {
        (
            points::<K>("points_t0", points_t0)?,
            points::<K>("points_t1", points_t1)?,
        )
    };
    Ok(Query::new(*t0, *t1)?)
}

/// Decides if two primitives come within a distance of each other in a time step; for
/// `min_distance` = 0, if they touch. Exact.
///
/// `points_t0` and `points_t1` are the points of the query, in the order of its kind, at t = 0 and at
/// t = 1; in between, each moves in a straight line. `min_distance` is a finite number of at least 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_collides(
    kind: u32,
    points_t0: *const f64,
    points_t1: *const f64,
    min_distance: f64,
    collides: *mut bool,
) -> Status {
    call(|| {
        let d = Separation::new(min_distance)?;
        // SAFETY: the documentation of the function states the promise.
        let (collides, answer) = unsafe {
            let collides = Out::new("collides", collides)?;
            let answer = with_kind!(kind, K => {
                Ok(query::<K>(points_t0, points_t1)?.collides(d))
            })?;
            (collides, answer)
        };
        collides.write(answer);
        Ok(())
    })
}

/// The first time at which two primitives come within a distance of each other, rounded down to
/// `double`; for `min_distance` = 0, at which they touch. It is 0 if they are within it at the
/// start, and NaN if they never come within it.
///
/// Arguments as in `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_time_of_impact(
    kind: u32,
    points_t0: *const f64,
    points_t1: *const f64,
    min_distance: f64,
    time: *mut f64,
) -> Status {
    call(|| {
        let d = Separation::new(min_distance)?;
        // SAFETY: the documentation of the function states the promise.
        let (time, answer) = unsafe {
            let time = Out::new("time", time)?;
            let answer = with_kind!(kind, K => {
                Ok(query::<K>(points_t0, points_t1)?.time_of_impact(d))
            })?;
            (time, answer)
        };
        time.write(answer.unwrap_or(f64::NAN));
        Ok(())
    })
}

/// `exact_ccd_time_of_impact` until a time: NaN also if the primitives come within the distance only
/// after `until`. The exact time is compared, not the rounded one. `until` may be any number but NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_time_of_impact_until(
    kind: u32,
    points_t0: *const f64,
    points_t1: *const f64,
    min_distance: f64,
    until: f64,
    time: *mut f64,
) -> Status {
    call(|| {
        let options = Options::within(Separation::new(min_distance)?).until(until);
        if until.is_nan() {
            return Err(Error::argument("until is NaN, expected a time"));
        }
        // SAFETY: the documentation of the function states the promise.
        let (time, answer) = unsafe {
            let time = Out::new("time", time)?;
            let answer = with_kind!(kind, K => {
                Ok(query::<K>(points_t0, points_t1)?.time_of_impact(options))
            })?;
            (time, answer)
        };
        time.write(answer.unwrap_or(f64::NAN));
        Ok(())
    })
}

/// The first time at which two primitives come within a distance of each other, with the closest
/// points and the normal then. `impact` is written only if `collides` is.
///
/// Arguments as in `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_impact(
    kind: u32,
    points_t0: *const f64,
    points_t1: *const f64,
    min_distance: f64,
    collides: *mut bool,
    impact: *mut Impact,
) -> Status {
    call(|| {
        let d = Separation::new(min_distance)?;
        // SAFETY: the documentation of the function states the promise.
        let (collides, impact, answer) = unsafe {
            let collides = Out::new("collides", collides)?;
            let impact = Out::new("impact", impact)?;
            let answer = with_kind!(kind, K => {
                let found = query::<K>(points_t0, points_t1)?.impact(d);
                let (t0, t1) = (points::<K>("points_t0", points_t0)?, points::<K>("points_t1", points_t1)?);
                Ok(found.map(|found| Impact::of_query::<K>(&found, t0, t1)))
            })?;
            (collides, impact, answer)
        };
        collides.write(answer.is_some());
        if let Some(answer) = answer {
            impact.write(answer);
        }
        Ok(())
    })
}

/// The times at which two primitives are within a distance of each other: the maximal closed
/// intervals, in increasing order. For `min_distance` = 0, the times at which they touch.
///
/// The first `capacity` intervals are written to `intervals`, which may be null for 0, and their
/// number to `count`, even if that is larger. There are at most 32. Other arguments as in
/// `exact_ccd_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_intervals(
    kind: u32,
    points_t0: *const f64,
    points_t1: *const f64,
    min_distance: f64,
    intervals: *mut Interval,
    capacity: usize,
    count: *mut usize,
) -> Status {
    call(|| {
        let d = Separation::new(min_distance)?;
        // SAFETY: the documentation of the function states the promise.
        let (intervals, count, answer) = unsafe {
            let intervals = places("intervals", intervals, capacity)?;
            let count = Out::new("count", count)?;
            let answer = with_kind!(kind, K => {
                Ok(query::<K>(points_t0, points_t1)?.intervals(d))
            })?;
            (intervals, count, answer)
        };
        count.write(answer.len());
        fill(intervals, answer.iter().map(Interval::from));
        Ok(())
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
    points_t0: *const f64,
    points_t1: *const f64,
    time: f64,
    lower: *mut f64,
    upper: *mut f64,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (lower, upper, answer) = unsafe {
            let lower = Out::new("lower", lower)?;
            let upper = Out::new("upper", upper)?;
            let answer = with_kind!(kind, K => {
                Ok(query::<K>(points_t0, points_t1)?.distance_at(time)?)
            })?;
            (lower, upper, answer)
        };
        lower.write(answer.lower);
        upper.write(answer.upper);
        Ok(())
    })
}

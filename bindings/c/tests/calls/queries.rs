//! Single queries: verdict, time, impact, intervals and distance agree.

use arbitrary::{Result, Unstructured};
use exact_ccd_c::{
    Impact, Interval, exact_ccd_collides, exact_ccd_distance_at, exact_ccd_impact, exact_ccd_intervals,
    exact_ccd_time_of_impact,
};

use super::{input, succeeds};

const UNWRITTEN: f64 = -7.0;

/// Returns true if the query collides.
pub(super) fn check(bytes: &mut Unstructured<'_>) -> Result<bool> {
    let (kind, count) = input::kind(bytes)?;
    let (t0, t1) = (input::points(bytes, count)?, input::points(bytes, count)?);
    let (t0, t1) = (input::pointer(bytes, &t0)?, input::pointer(bytes, &t1)?);
    let d = input::distance(bytes)?;

    let (mut collides, mut is_found) = (false, false);
    let (mut time, mut impact) = (
        UNWRITTEN,
        Impact {
            time: UNWRITTEN,
            ..Impact::default()
        },
    );
    let mut intervals = [Interval {
        start: UNWRITTEN,
        end: UNWRITTEN,
    }; 3];
    let mut interval_count = 99;
    // SAFETY: pointers are null, or point to arrays of the kind's size.
    let statuses = unsafe {
        [
            exact_ccd_collides(kind, t0, t1, d, 1.0, &raw mut collides),
            exact_ccd_time_of_impact(kind, t0, t1, d, 1.0, &raw mut time),
            exact_ccd_impact(kind, t0, t1, d, 1.0, &raw mut is_found, &raw mut impact),
            exact_ccd_intervals(
                kind,
                t0,
                t1,
                d,
                1.0,
                intervals.as_mut_ptr(),
                3,
                &raw mut interval_count,
            ),
        ]
    };
    assert_eq!(statuses, [statuses[0]; 4]);
    if succeeds(statuses[0]) {
        assert_eq!([is_found, !time.is_nan(), interval_count > 0], [collides; 3]);
        if collides {
            assert_eq!([impact.time, intervals[0].start], [time; 2]);
            let until = |until: f64| {
                let mut found = UNWRITTEN;
                // SAFETY: as above.
                let status = unsafe { exact_ccd_time_of_impact(kind, t0, t1, d, until, &raw mut found) };
                assert!(succeeds(status));
                (!found.is_nan()).then_some(found)
            };
            // A time that is rounded down is after the number that it is rounded to.
            assert_eq!(until(time), impact.time_is_exact.then_some(time));
            assert_eq!(
                [until(time.next_up()), until(time.next_down())],
                [Some(time), None]
            );
            let written = &intervals[..interval_count.min(3)];
            assert!(
                written
                    .iter()
                    .all(|i| 0.0 <= i.start && i.start <= i.end && i.end <= 1.0)
            );
        }
    } else {
        assert!(!collides && !is_found && interval_count == 99);
        assert_eq!([time, impact.time, intervals[0].start], [UNWRITTEN; 3]);
    }

    let at = input::number(bytes)? / 4.0;
    let (mut lower, mut upper) = (UNWRITTEN, UNWRITTEN);
    // SAFETY: as above.
    let status = unsafe { exact_ccd_distance_at(kind, t0, t1, at, &raw mut lower, &raw mut upper) };
    if succeeds(status) {
        assert!(0.0 <= lower && lower <= upper);
    } else {
        assert_eq!([lower, upper], [UNWRITTEN; 2]);
    }
    Ok(collides)
}

//! Extreme numbers, invalid bounds, and the limit.

use exact_ccd::{Axis, VertexFace, VertexVertex};
use exact_ccd_curved::{
    End, FromFunctions, Polynomial, Position, RigidMotion, RigidMotionError, SearchError, SearchOptions,
    Trajectory, time_of_impact,
};

use crate::{at_rest, close, timed, within};

/// A point that moves by a function along x, with a bound of its deviation.
fn along_x(x: impl Fn(f64) -> f64, error: f64, deviation: f64) -> impl Trajectory {
    FromFunctions {
        position: move |time: f64| Position {
            point: [x(time), 0.0, 0.0],
            error,
        },
        deviation: move |start: f64, end: f64| deviation * (end - start),
    }
}

fn search(a: &dyn Trajectory, options: &SearchOptions) -> Result<exact_ccd_curved::Answer, SearchError> {
    time_of_impact::<VertexVertex, _>(&[a, &at_rest([0.0; 3])], within(1.0), options)
}

#[test]
fn positions_and_bounds_that_are_not_numbers_are_errors() {
    let options = close(1e-3);
    let nan = search(
        &along_x(|t| if t > 0.5 { f64::NAN } else { 9.0 }, 0.0, 0.0),
        &options,
    );
    let Err(SearchError::Position { start, end, source }) = nan else {
        panic!("{nan:?}")
    };
    assert_eq!(
        (start, end, source.point, source.time, source.axis),
        (0.0, 1.0, 0, Some(1), Axis::X)
    );
    for (error, deviation) in [(f64::NAN, 0.0), (-1.0, 0.0), (0.0, f64::NAN), (0.0, -1e-300)] {
        let answer = search(&along_x(|_| 9.0, error, deviation), &options);
        assert_eq!(
            answer,
            Err(SearchError::Bound {
                point: 0,
                start: 0.0,
                end: 1.0
            })
        );
    }
    for tolerance in [f64::NAN, -1.0] {
        let answer = search(&along_x(|_| 9.0, 0.0, 0.0), &timed(tolerance));
        assert!(matches!(answer, Err(SearchError::Tolerance(_))));
    }
    let message = search(&along_x(|_| f64::INFINITY, 0.0, 0.0), &options)
        .unwrap_err()
        .to_string();
    assert_eq!(
        message,
        "in the chord for the times from 0 to 1, coordinate x of point 0 at t = 0 is inf, not a finite number"
    );
}

#[test]
fn a_bound_that_says_nothing_leaves_all_open() {
    for (error, deviation) in [(f64::INFINITY, 0.0), (0.0, f64::INFINITY), (1e300, 0.0)] {
        let answer = search(&along_x(|_| 9.0, error, deviation), &close(1e-3)).unwrap();
        assert!(
            matches!(answer.end, End::Precision | End::ChordLimit),
            "{answer:?}"
        );
        assert_eq!((answer.free_until, answer.within), (0.0, None));
    }
}

#[test]
fn the_limit_ends_the_search_with_the_part_that_is_certain() {
    // x = 2 − t with a deviation that shrinks no faster than the chords: at t = 1 the distance is 1.
    let slow = along_x(|t| 2.0 - t, 0.0, 4.0);
    let mut last = -1.0;
    for limit in [0, 1, 10, 40, 100] {
        let answer = search(&slow, &timed(0.0).with_chord_limit(limit)).unwrap();
        assert_eq!((answer.end, answer.chords), (End::ChordLimit, limit));
        assert!(answer.free_until >= last && answer.free_until <= 1.0);
        last = answer.free_until;
    }
    assert!(last > 0.8, "{last}");
}

#[test]
fn a_rigid_motion_needs_finite_numbers_and_an_axis() {
    let motion = |center: f64, direction: f64, angle: f64, displacement: f64| {
        RigidMotion::new([center; 3], [direction; 3], angle, [displacement; 3])
    };
    for bad in [f64::NAN, f64::INFINITY] {
        for (quantity, motion) in [
            ("center", motion(bad, 1.0, 1.0, 1.0)),
            ("direction", motion(1.0, bad, 1.0, 1.0)),
            ("angle", motion(1.0, 1.0, bad, 1.0)),
            ("displacement", motion(1.0, 1.0, 1.0, bad)),
        ] {
            let Err(RigidMotionError::NotFinite { quantity: named, .. }) = motion else {
                panic!("{motion:?}")
            };
            assert_eq!(named, quantity);
        }
    }
    assert_eq!(motion(0.0, 0.0, 1.0, 0.0), Err(RigidMotionError::Axis([0.0; 3])));
    assert!(motion(0.0, 0.0, 0.0, 1.0).is_ok());
    // The length of the direction does not matter, down to the smallest number.
    let expected = motion(0.0, 1.0, 1.0, 1.0);
    for length in [5e-324, 1e-300, 1e-200, f64::MAX] {
        assert_eq!(motion(0.0, length, 1.0, 1.0), expected);
    }
}

/// A quarter turn of a bar towards a post, all scaled.
#[test]
fn huge_and_tiny_coordinates_have_the_same_times() {
    let times = [-900, -300, 0, 300, 1000].map(|exponent| {
        let scale = 2.0_f64.powi(exponent);
        let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], 2.0, [0.0; 3]).unwrap();
        let tip = motion.point([scale, 0.0, 0.0]);
        let wall =
            [[0.0, 0.5, -1.0], [0.0, 0.5, 1.0], [0.0, 2.0, 0.0]].map(|p| at_rest(p.map(|x| x * scale)));
        let points: [&dyn Trajectory; 4] = [&tip, &wall[0], &wall[1], &wall[2]];
        let answer = time_of_impact::<VertexFace, _>(&points, within(0.0), &timed(1e-9)).unwrap();
        assert_eq!(answer.end, End::Tolerance, "{exponent} {answer:?}");
        let time = std::f64::consts::FRAC_PI_4;
        assert!(
            answer.free_until <= time && time <= answer.within.unwrap().by.next_up(),
            "{exponent} {answer:?}"
        );
        answer.free_until
    });
    assert!(times.iter().all(|time| (time - times[0]).abs() < 1e-9));
}

#[test]
fn no_number_causes_a_panic() {
    let numbers = [0.0, -0.0, 5e-324, -1e-300, 1.0, 1e150, -1e300, f64::MAX];
    let mut random = fastrand::Rng::with_seed(9);
    let mut free = 0;
    for _ in 0..3_000 {
        let mut pick = || numbers[random.usize(0..numbers.len())];
        let mut point = || [pick(), pick(), pick()];
        let polynomial = Polynomial::new([point(), point(), point()]);
        let coefficients = Polynomial::from_coefficients([point(), point(), point(), point()]);
        let (center, axis, displacement, start) = (point(), point(), point(), point());
        let rest = at_rest(point());
        let angle = pick();
        let mut points: Vec<&dyn Trajectory> = vec![&polynomial, &coefficients];
        let motion = RigidMotion::new(center, axis, angle, displacement).map(|motion| motion.point(start));
        if let Ok(point) = &motion {
            points.push(point);
        }
        let d = within(pick().abs());
        let options = SearchOptions::default()
            .with_distance_tolerance(within(1e-3))
            .with_chord_limit(20);
        for point in points {
            // Overflow is an error of the search, not of the program.
            if let Ok(answer) = time_of_impact::<VertexVertex, _>(&[point, &rest], d, &options) {
                free += usize::from(answer.is_free());
            }
        }
    }
    assert!(free > 100, "{free}");
}

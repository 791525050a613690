//! The moments of cubics with known roots, and their times.

use alloc::vec::Vec;

use super::*;
use crate::exact::FirstContact;
use crate::numbers::cubic::Root;
use crate::tables::EdgeEdge;

/// The coefficients of the product of linear functions, given at both ends of the step.
fn product(factors: [[i128; 2]; 3]) -> [Volume; 4] {
    let [[a, b], [c, d], [e, f]] = factors.map(|ends| ends.map(Volume::from));
    [
        a * c * e,
        b * c * e + a * d * e + a * c * f,
        b * d * e + b * c * f + a * d * f,
        b * d * f,
    ]
}

/// The times at which a cubic vanishes, if they are certain.
fn times(cubic: &[Volume; 4]) -> Option<Vec<ContactTime>> {
    let exact = ExactCubic::new(*cubic);
    zeros(cubic)?.iter().map(|moment| exact.time(moment)).collect()
}

/// The time a / (a + b).
fn quotient(a: i128, b: i128) -> ContactTime {
    let nearest = a as f64 / (a + b) as f64;
    // Positive if the nearest f64 is above the quotient.
    let excess = libm::fma(nearest, (a + b) as f64, -(a as f64));
    if excess == 0.0 {
        ContactTime::exactly(nearest)
    } else if excess > 0.0 {
        ContactTime::just_above(nearest.next_down())
    } else {
        ContactTime::just_above(nearest)
    }
}

#[test]
fn double_and_triple_roots_are_certain_at_times_with_few_digits() {
    let parts = 1 << 3;
    for roots in (0..10_i128.pow(3)).map(|index| [100, 10, 1].map(|power| index / power % 10)) {
        // The product of linear functions from −a to 8 − a. Some of them vanish at an end, or outside.
        let cubic = product(roots.map(|a| [-a, parts - a]));
        let mut expected: Vec<_> = roots.into_iter().filter(|&a| a <= parts).collect();
        expected.sort_unstable();
        expected.dedup();
        let expected: Vec<_> = expected.into_iter().map(|a| quotient(a, parts - a)).collect();
        assert_eq!(times(&cubic), Some(expected), "{roots:?}");
    }
}

#[test]
fn roots_next_to_each_other_are_certain() {
    for digits in 3..=61 {
        let whole = 1_i128 << digits;
        // In the middle of the step, at its ends, and in its first thousandth.
        for (middle, must_be_known) in [
            (whole / 2, true),
            (4, digits < 9),
            (whole - 4, true),
            (whole >> 12, false),
        ] {
            for [x, y] in [[-1, 0], [-1, 1], [1, 2], [-3, 1]] {
                let all = [0, x, y].map(|units| middle + units);
                let cubic = product(all.map(|a| [-a, whole - a]));
                let mut distinct = all.map(|a| a as i64).to_vec();
                distinct.sort_unstable();
                distinct.dedup();
                distinct.retain(|&a| a >= 0 && i128::from(a) <= whole);
                let time = |a: i64| Fraction::from(Dyadic::START.plus(a << (62 - digits))).time();
                let expected: Vec<_> = distinct.into_iter().map(time).collect();
                let found = times(&cubic);
                let is_known = found.is_some();
                assert!(
                    !is_known || found == Some(expected),
                    "{digits} {middle} {x} {y} {found:?}"
                );
                assert!(is_known || !must_be_known, "{digits} {middle} {x} {y}");
            }
        }
    }
}

#[test]
fn times_of_early_roots_are_right_or_unknown() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut known = 0;
    for _ in 0..1000 {
        let whole = random.i128(1 << 50..1 << 53);
        let first = random.i128(1 << 20..whole >> 9);
        let near = first + random.i128(-(1 << 18)..1 << 18);
        let cubic = product([
            [-first, whole - first],
            [-near, whole - near],
            [-1, random.i128(0..3)],
        ]);
        let mut expected = Vec::from([quotient(first, whole - first), quotient(near, whole - near)]);
        expected.sort_unstable();
        expected.dedup();
        for moment in zeros(&cubic).unwrap_or_default() {
            let narrow = narrower(&cubic, &moment);
            for time in [Some(moment), narrow]
                .iter()
                .flatten()
                .flat_map(|moment| ExactCubic::new(cubic).time(moment))
            {
                let is_last = time.lower() > 0.3;
                assert!(
                    is_last || expected.contains(&time),
                    "{first} {near} {whole} {time:?}"
                );
                known += u32::from(!is_last);
            }
        }
    }
    assert!(known > 100, "{known}");
}

#[test]
fn a_cubic_without_bend_at_the_start() {
    // −(2 t − 1)² (1 + t): the root of its second derivative is −0.
    let cubic = [-1, 0, 3, -2].map(Volume::from);
    assert_eq!(times(&cubic), Some(Vec::from([ContactTime::exactly(0.5)])));
}

#[test]
fn a_root_next_to_a_fraction_of_the_step_is_not_taken_for_it() {
    // The roots are 1/2 and a / (2 a ± 1), before it or after it.
    for a in [300, 1000, 100_000, 1 << 40] {
        let half = ContactTime::exactly(0.5);
        for (ends, expected) in [
            ([-a, a + 1], [quotient(a, a + 1), half]),
            ([-a - 1, a], [half, quotient(a + 1, a)]),
        ] {
            let cubic = product([[-1, 1], ends, [1, 1]]);
            assert_eq!(times(&cubic), Some(expected.to_vec()), "{ends:?}");
        }
    }
}

#[test]
fn a_root_next_to_a_multiple_of_two_to_the_minus_ten_is_not_taken_for_it() {
    for multiple in [2, 341, 512, 1023] {
        for size in (10..40).map(|digits| 1_i128 << digits) {
            // The simple root differs from the multiple by less than 2⁻²⁰, down to 2⁻⁵⁰, on either side.
            for sign in [-1, 1] {
                let (a, b) = (multiple * size + sign, (1024 - multiple) * size);
                let cubic = product([[-a, b], [1, 1], [1, 2]]);
                let expected = quotient(a, b);
                assert_eq!(
                    times(&cubic),
                    Some([expected].to_vec()),
                    "{multiple} {size} {sign}"
                );
            }
        }
    }
}

#[test]
fn a_root_next_to_an_end_at_which_the_cubic_vanishes_is_not_taken_for_the_end() {
    for digits in 2..=61 {
        let after = (1_i128 << digits) - 1;
        let [first, last] = [Fraction::START, Fraction::END].map(Fraction::time);
        let unit = 1 << (62 - digits);
        for other in [[1, 1], [1, 3], [-1, -5]] {
            let cubic = product([[0, 1], [-1, after], other]);
            let root = Fraction::from(Dyadic::START.plus(unit)).time();
            // The f64 below 2⁻¹⁰ are not all multiples of the unit.
            let found = times(&cubic);
            assert!(found.is_some() || digits > 10, "{digits} {other:?}");
            assert!(
                found.is_none_or(|found| found == [first, root]),
                "{digits} {other:?}"
            );
            let cubic = product([[1, 0], [-after, 1], other]);
            let root = Fraction::from(Dyadic::END.plus(-unit)).time();
            assert_eq!(times(&cubic), Some([root, last].to_vec()), "{digits} {other:?}");
        }
    }
}

#[test]
fn a_time_is_inserted_before_or_after_a_root_or_in_its_place() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut counts = [0; 3];
    for _ in 0..2000 {
        let [a, b] = [(); 2].map(|()| random.i128(1..1 << 20));
        let sign = [-1, 1][random.usize(..2)];
        let cubic = product([[-a * sign, b * sign], [1, 1], [1, 2]]);
        // At the root, and off it by one part in m or less.
        let m = 1 << random.u32(0..42);
        let [elapsed, left] = [[a, b], [a * m + 1, b * m], [a * m, b * m + 1]][random.usize(..3)];
        let time = Fraction::zero_of(elapsed, -left).expect("the time is short");
        let mut moments = zeros(&cubic).expect("the root is simple");
        if insert(&mut moments, &cubic, time).is_none() {
            continue;
        }
        let place = moments.iter().position(|moment| matches!(moment, Moment::At(_)));
        let order = (elapsed * b).cmp(&(left * a));
        let expected = match order {
            Ordering::Less => (2, 0),
            Ordering::Equal => (1, 0),
            Ordering::Greater => (2, 1),
        };
        assert_eq!(
            (moments.len(), place),
            (expected.0, Some(expected.1)),
            "{a} {b} {time:?}"
        );
        counts[expected.0 + expected.1 - 1] += 1;
    }
    assert!(counts.iter().all(|&count| count > 500), "{counts:?}");
}

/// Returns true if a time is inserted among the roots of a cubic, in the same units. Asserts that it is then
/// in its place.
#[track_caller]
fn is_inserted(roots: &[i128], time: i128, cubic: &[Volume; 4], fraction: Fraction) -> bool {
    let Some(mut moments) = zeros(cubic) else {
        return false;
    };
    if insert(&mut moments, cubic, fraction).is_none() {
        return false;
    }
    let mut expected = roots.to_vec();
    expected.push(time);
    expected.sort_unstable();
    expected.dedup();
    let is_time = |moment: &Moment| matches!(moment, Moment::At(at) if *at == fraction);
    assert_eq!(moments.len(), expected.len(), "{roots:?} {time}");
    let place = expected.iter().position(|&other| other == time);
    assert_eq!(moments.iter().position(is_time), place, "{roots:?} {time}");
    true
}

#[test]
fn a_time_is_inserted_among_roots_next_to_each_other() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut known = 0;
    for index in 0..6000 {
        let digits = random.u32(4..61);
        let whole = 1_i128 << digits;
        let middle = random.i128(whole / 8..whole - whole / 8);
        // In units of half of the last digit: a time is a root, or between two.
        let mut roots = [(); 3].map(|()| 2 * (middle + random.i128(-2..=2)));
        if index % 2 == 0 {
            // One root has more digits than the ends of windows.
            roots[0] += 1;
        }
        let cubic = product(roots.map(|a| [-a, 2 * whole - a]));
        let time = 2 * middle + random.i128(-4..=4);
        let fraction = Fraction::zero_of(time, time - 2 * whole).expect("the time is short");
        known += usize::from(is_inserted(&roots, time, &cubic, fraction));
    }
    assert!(known > 3000, "{known}");
}

/// Two edges whose points are coplanar at a time with 53 digits, at which an axis has a factor, and touch
/// 2⁻¹⁰⁵ before: both are roots of the rest.
#[test]
fn a_root_just_before_the_zero_of_a_factor_is_kept() {
    let points = [
        [[0.0; 3]; 2],
        [
            [0.0, 5_191_522_382_721_412.0, -6_147_789_742_948_876.0],
            [0.0, -5_504_607_116_136_910.0, 6_518_544_017_103_947.0],
        ],
        [
            [0.0, -7_104_057_103_176_340.0, -7_923_804_018_742_961.0],
            [0.0, 7_532_480_918_070_984.0, 8_401_664_246_621_693.0],
        ],
        [
            [4_371_775_467_154_791.0, 3.0, 5.0],
            [-4_635_423_787_586_201.0, 3.0, 5.0],
        ],
    ];
    let [start, end] = [0, 1].map(|time: usize| points.map(|ends| ends[time]));
    let time = 4_371_775_467_154_791.0 / (1_u64 << 53) as f64;
    let expected = ContactTime::just_above(time.next_down());
    assert!(!matches!(first_moment::<EdgeEdge>(&[start, end]), Some(None)));
    let all = moments::<EdgeEdge>(&[start, end]);
    assert!(all.is_none_or(|all| all == Intervals::from_iter([Interval::moment(expected)])));
    let truth = FirstContact::<EdgeEdge>::of(&[start, end]);
    assert_eq!(truth.map(|contact| contact.time()), Some(expected));
}

/// Returns true if a moment is a time, or a root in a window that contains the bracket of a root in another
/// window.
fn contains(narrow: &Moment, window: &Window, root: &Root) -> bool {
    let Moment::Root(narrow, _) = narrow else {
        return true;
    };
    let [low, high] = narrow.ends();
    low <= window.around(root.low)[0] && high >= window.around(root.high)[1]
}

#[test]
fn a_narrower_window_has_the_same_root() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut narrow = 0;
    for _ in 0..300 {
        let roots = [(); 3].map(|()| [random.i128(1..1 << 20), random.i128(1..1 << 20)]);
        let cubic = product(roots.map(|[a, b]| [-a, b]));
        for moment in zeros(&cubic).expect("the roots are apart") {
            if let Some(found) = narrower(&cubic, &moment) {
                let exact = ExactCubic::new(cubic);
                assert_eq!(exact.time(&found), exact.time(&moment));
                if let Moment::Root(window, root) = &moment {
                    assert!(contains(&found, window, root), "{roots:?}");
                }
                narrow += 1;
            }
        }
    }
    assert!(narrow > 800, "{narrow}");
}

#[test]
fn a_narrower_window_contains_brackets_of_few_units() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut narrow = 0;
    for _ in 0..1000 {
        // The root, in units, is below 2⁴⁴: an f64 has some of its digits after the point.
        let (a, b) = (random.i128(1..1 << 10), random.i128(1 << 30..1 << 40));
        let units = Dyadic::END.units() as f64;
        let near = a as f64 / (a + b) as f64;
        let [below, above] = [(); 2].map(|()| [0.2, 0.7, 1.5, 20.0][random.usize(..4)]);
        // A bracket may begin with its window.
        let low = [near - below / units, 0.0][random.usize(..2)];
        let root = Root {
            low,
            high: near + above / units,
            near,
            slope: 0.0,
            before: Ordering::Less,
        };
        let cubic = product([[-a, b], [1, 1], [1, 1]]);
        if let Some(found) = narrowed(&cubic, &Window::STEP, &root) {
            assert!(contains(&found, &Window::STEP, &root), "{a} {b} {root:?}");
            narrow += 1;
        }
    }
    assert!(narrow > 250, "{narrow}");
}

#[test]
fn signs_in_twice_the_precision_are_those_of_the_integers() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut certain = 0;
    for _ in 0..10_000 {
        // The root is off the time m 2⁻⁵³ by one part in 2⁵³⁺ˢ.
        let (m, s) = (random.i128(1..1 << 53), random.i32(1..70));
        let sign = [-1, 1][random.usize(..2)];
        let (a, whole) = ((m << s) + sign, 1_i128 << (53 + s));
        let mut other = || [(); 2].map(|()| random.i128(1 << 50..1 << 60));
        let cubic = product([[-a, whole - a], other(), other()]);
        let time = m as f64 / (1_u64 << 53) as f64;
        if let Some(found) = ExactCubic::new(cubic).approximate_sign_at(time) {
            assert_eq!(found, 0.cmp(&sign), "{m} {s} {sign}");
            certain += 1;
        }
    }
    assert!((5_000..9_500).contains(&certain), "{certain}");
}

/// In the first half of the step, the root 1/3 is at the place 2/3, and the step has a root at that time.
#[test]
fn a_place_in_a_window_is_not_taken_for_a_time() {
    let cubic = product([[-1, 2], [-11, 9], [-2, 1]]);
    let half = Dyadic::new(0.5).expect("a multiple of the unit");
    let window = Window::new(Dyadic::START, half).expect("a window");
    let root = Root {
        low: 0.66,
        high: 0.67,
        near: 2.0 / 3.0,
        slope: 1.0,
        before: Ordering::Less,
    };
    let time = ExactCubic::new(cubic).time(&Moment::Root(window, root));
    assert_eq!(time, Some(quotient(1, 2)));
}

/// Roots and times are multiples of a quarter of the unit of times.
#[test]
fn a_time_is_inserted_among_roots_in_one_unit() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut known = 0;
    let whole = 1_i128 << 64;
    for _ in 0..6000 {
        let middle = random.i128(whole / 8..whole - whole / 8) & !3;
        let roots = [(); 3].map(|()| middle + random.i128(-6..=6));
        let cubic = product(roots.map(|a| [-a, whole - a]));
        let time = middle + 4 * random.i128(-2..=2);
        let fraction = Fraction::zero_of(time, time - whole);
        known += usize::from(fraction.is_some_and(|fraction| is_inserted(&roots, time, &cubic, fraction)));
    }
    assert!(known > 100, "{known}");
}

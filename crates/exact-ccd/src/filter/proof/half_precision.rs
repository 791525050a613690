//! Steps between adjacent numbers, and times between them, for all numbers of half precision and their
//! neighbours among f64.

use alloc::vec::Vec;

use crate::values::{ContactTime, NonNegative};

/// All finite numbers of half precision that are not negative: subnormal ones are multiples of 2⁻²⁴, the
/// others have ten binary digits after the first.
fn half_precision() -> impl Iterator<Item = f64> {
    (0..31_u32 << 10).map(|bits| {
        let (exponent, fraction) = (bits >> 10, f64::from(bits & 1023));
        match exponent {
            0 => fraction / f64::from(1 << 24),
            _ => (1024.0 + fraction) * (f64::from(exponent) - 25.0).exp2(),
        }
    })
}

#[test]
fn the_next_number_is_the_next_number() {
    let numbers: Vec<f64> = half_precision().collect();
    assert!(numbers.is_sorted() && numbers.len() == 31_744 && numbers.last() == Some(&65_504.0));
    for scale in [1.0, 2.0_f64.powi(-1050), 2.0_f64.powi(1008)] {
        for x in numbers.iter().map(|x| x * scale) {
            for x in [x, x.next_up(), x.next_down().max(0.0)] {
                let number = NonNegative::new(x).unwrap();
                assert_eq!((number.get(), number.next_up()), (x, x.next_up()));
                assert_eq!(NonNegative::new(-x).is_some(), x == 0.0);
            }
        }
    }
}

#[test]
fn times_lie_between_their_ends() {
    for t in half_precision().filter(|&t| t < 1.0) {
        let next = t.next_up();
        let [before, between, after] = [
            ContactTime::exactly(t),
            ContactTime::just_above(t),
            ContactTime::exactly(next),
        ];
        assert!(before < between && between < after);
        assert_eq!([before, between, after].map(ContactTime::lower), [t, t, next]);
        assert_eq!([before, between, after].map(ContactTime::upper), [t, next, next]);
        assert_eq!(
            [before, between, after].map(|time| time.is_at_most(t)),
            [true, false, false]
        );
        assert_eq!(
            [before, between, after].map(|time| time.is_at_most(next)),
            [true; 3]
        );
        assert_eq!([before, between, after].map(|time| time.is_before(t)), [false; 3]);
        assert_eq!(
            [before, between, after].map(|time| time.is_before(next)),
            [true, true, false]
        );
    }
}

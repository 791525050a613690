//! Sums of thicknesses, against rational numbers.

use dashu_ratio::RBig;
use exact_ccd::{InvalidThickness, Separations, Thickness};
use proptest::prelude::*;

use exact_ccd_testing::alphabet::ALPHABET;
use exact_ccd_testing::runner::for_all;

fn exact(x: f64) -> RBig {
    RBig::try_from(x).unwrap()
}

/// Any thickness; among them neighbours of powers of two, and subnormal numbers.
fn any_thickness() -> impl Strategy<Value = f64> {
    let any = any::<f64>().prop_map(f64::abs);
    let near_power = (-1074..1023_i32, -2..=2_i64).prop_map(|(exponent, steps)| {
        let power = 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
        f64::from_bits(power.to_bits().saturating_add_signed(steps))
    });
    let subnormal = (0..1_u64 << 53).prop_map(f64::from_bits);
    let alphabet = prop::sample::select(ALPHABET.as_slice()).prop_map(f64::abs);
    prop_oneof![any, near_power, subnormal, alphabet, 0.0..1.0]
        .prop_filter("in range", |&x| x <= Thickness::MAX)
}

#[test]
fn sums_are_rounded_up() {
    for_all(20_000, (any_thickness(), any_thickness()), |(a, b)| {
        let thickness = Thickness::new(&[a, b]).unwrap();
        let sum = Separations::Thickness(&thickness).between(&[0], &[1]).get();
        let sum_of_both = exact(a) + exact(b);
        assert!(exact(sum) >= sum_of_both, "{a:e} + {b:e} = {sum:e}");
        assert!(
            sum == 0.0 || exact(sum.next_down()) < sum_of_both,
            "{a:e} + {b:e} = {sum:e}"
        );
    });
}

#[test]
fn primitives_are_as_thick_as_their_thickest_vertex() {
    let thickness = Thickness::new(&[1.0, 0.0, -0.0, 3.0, f64::from_bits(1)]).unwrap();
    let of = |vertices: &[u32]| thickness.of(vertices).get();
    assert_eq!(
        [of(&[0, 1]), of(&[1, 2]), of(&[0, 3, 1]), of(&[4, 2])],
        [1.0, 0.0, 3.0, f64::from_bits(1)]
    );
    assert_eq!((of(&[]), of(&[9])), (0.0, 0.0));
    assert_eq!(thickness.vertex_count(), 5);
}

#[test]
fn errors_name_vertex_and_value() {
    for value in [-1.0, f64::INFINITY, Thickness::MAX.next_up()] {
        let error = Thickness::new(&[0.0, Thickness::MAX, value]).unwrap_err();
        assert_eq!(error, InvalidThickness { vertex: 2, value });
    }
    assert_eq!(Thickness::new(&[f64::NAN]).unwrap_err().vertex, 0);
    assert_eq!(
        Thickness::new(&[0.0, -0.5]).unwrap_err().to_string(),
        "the thickness of vertex 1 is -0.5, expected a number from 0 to 8.988465674311579e307"
    );
}

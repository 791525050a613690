//! Square and cube roots as contact times, checked in integers.

use std::cmp::Ordering;

use dashu_int::UBig;
use exact_ccd::{CONTACT, EdgeEdge, Kind, Query, Separation, VertexFace};
use proptest::prelude::*;

use exact_ccd_testing::laws::checked;
use exact_ccd_testing::runner::for_all;

/// A vertex at (n t, 0, m) meets the tilting plane z = t x when n t² = m.
fn square_root(m: f64, n: f64) -> Query<VertexFace> {
    const L: f64 = 8192.0;
    let at = |t: f64| [[n * t, 0.0, m], [-L, -L, -L * t], [L, -L, L * t], [0.0, L, 0.0]];
    Query::new(at(0.0), at(1.0)).unwrap()
}

/// The lines y = t, z = n t x − m and x = t y, z = 0 meet when n t³ = m.
fn cube_root(m: f64, n: f64) -> Query<EdgeEdge> {
    const L: f64 = 2.0;
    let at = |t: f64| {
        let end = |x: f64| [x, t, n * t * x - m];
        [end(-L), end(L), [-L * t, -L, 0.0], [L * t, L, 0.0]]
    };
    Query::new(at(0.0), at(1.0)).unwrap()
}

/// The comparison of n tᵏ with m.
fn compare_power(t: f64, k: usize, m: u32, n: u32) -> Ordering {
    const SHIFT: i32 = 1074;
    let bits = t.to_bits();
    let (fraction, exponent) = (bits & ((1 << 52) - 1), (bits >> 52) as usize);
    // t · 2¹⁰⁷⁴
    let integer = match exponent {
        0 => UBig::from(fraction),
        _ => UBig::from(fraction | 1 << 52) << (exponent - 1),
    };
    (integer.pow(k) * n).cmp(&(UBig::from(m) << (SHIFT as usize * k)))
}

fn is_rounded_root<K: Kind>(query: &Query<K>, k: usize, m: u32, n: u32) {
    let times = checked(query, Separation::ZERO);
    assert_eq!(times.count(), Some(1), "{times:?}: {query:?}");
    let time = times[0].start;
    let lower = compare_power(time.lower(), k, m, n);
    assert!(lower.is_le(), "{times:?}: {query:?}");
    assert_eq!(lower.is_eq(), time.is_exact(), "{times:?}: {query:?}");
    if !time.is_exact() {
        assert!(
            compare_power(time.upper(), k, m, n).is_gt(),
            "{times:?}: {query:?}"
        );
    }
}

fn ratios() -> impl Strategy<Value = (u32, u32)> {
    (0..=4000u32, 1..=4000u32).prop_map(|(a, b)| (a.min(b), a.max(b)))
}

#[test]
fn square_roots_are_rounded_down() {
    for_all(2_000, ratios(), |(m, n)| {
        is_rounded_root(&square_root(m.into(), n.into()), 2, m, n);
    });
}

#[test]
fn cube_roots_are_rounded_down() {
    for_all(2_000, ratios(), |(m, n)| {
        is_rounded_root(&cube_root(m.into(), n.into()), 3, m, n);
    });
}

#[test]
fn roots_of_squares_and_cubes_are_exact() {
    for m in 0..=16u32 {
        is_rounded_root(&square_root((m * m).into(), 256.0), 2, m * m, 256);
        assert_eq!(
            square_root((m * m).into(), 256.0).time_of_impact(CONTACT),
            Some(f64::from(m) / 16.0)
        );
        is_rounded_root(&cube_root((m * m * m).into(), 4096.0), 3, m * m * m, 4096);
        assert_eq!(
            cube_root((m * m * m).into(), 4096.0).time_of_impact(CONTACT),
            Some(f64::from(m) / 16.0)
        );
    }
}

//! The sides on which a point lies at the roots of Y.

use std::cmp::Ordering;

use super::curve::{Curve, Roots};
use super::number::{Number, Signed};

/// True if, at one of the roots of Y, none of the quartics is negative for certain.
pub(super) fn is_inside<N: Signed>(
    curve: &Curve<N>,
    roots: Roots,
    quartics: impl Iterator<Item = [N; 5]>,
) -> Option<bool> {
    if matches!(roots, Roots::None) {
        return Some(false);
    }
    let mut inside = [true; 2];
    for quartic in quartics {
        let signs = curve.signs_of_quadratic(roots, &reduce(curve.coefficients(), quartic))?;
        for (inside, sign) in inside.iter_mut().zip(signs) {
            *inside &= sign != Ordering::Less;
        }
        if inside == [false; 2] {
            return Some(false);
        }
    }
    Some(true)
}

/// A quadratic J with the signs of the quartic L at the roots of Y, as long as k₀ is not zero:
/// twice, a multiple of Y is taken from a multiple of L to make the value at t = 0 vanish, and a
/// factor t removed.
fn reduce<N: Number>([k0, k1, k2, k3]: &[N; 4], [l0, l1, l2, l3, l4]: [N; 5]) -> [N; 3] {
    // 4 Y as a quartic.
    let elevated = [
        k0.clone().times(4),
        k0.clone() + k1.clone().times(3),
        (k1.clone() + k2.clone()).times(2),
        k2.clone().times(3) + k3.clone(),
        k3.clone().times(4),
    ];
    let cubic =
        |i: usize, l: N, scale| (l * elevated[0].clone() - l0.clone() * elevated[i].clone()).times(scale);
    let [s0, s1, s2, s3] = [
        cubic(1, l1, 12),
        cubic(2, l2, 6),
        cubic(3, l3, 4),
        cubic(4, l4, 3),
    ];
    let quadratic = |s: N, k: &N, scale| (s * k0.clone() - s0.clone() * k.clone()).times(scale);
    [quadratic(s1, k1, 6), quadratic(s2, k2, 3), quadratic(s3, k3, 2)]
}

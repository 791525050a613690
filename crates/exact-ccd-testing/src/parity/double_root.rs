//! The times at which the coplanarity of four points vanishes without a change of sign.

use dashu_int::IBig;
use exact_ccd::{ContactTime, Point};

use super::integers::{exactly, in_one_unit};

/// A rational number; the denominator is not zero.
pub(crate) struct Ratio {
    numerator: IBig,
    denominator: IBig,
}

impl Ratio {
    /// Returns true if a contact time may be this number: it is equal, or lies between the same two
    /// f64.
    pub(crate) fn may_be(&self, time: ContactTime) -> bool {
        let sign = self.denominator.signum();
        let compare =
            |t: f64| (&self.numerator * &sign * exactly(1.0)).cmp(&(exactly(t) * &self.denominator * &sign));
        if time.is_exact() {
            compare(time.lower()).is_eq()
        } else {
            compare(time.lower()).is_gt() && compare(time.upper()).is_lt()
        }
    }
}

/// The root of multiplicity two of the coplanarity of four points, if there is one.
///
/// For a₃ (t − r)² (t − s), a₂² − 3 a₁ a₃ is a₃² (r − s)², and for a₂ (t − r)², a₂²; then the ratio
/// below is r.
pub(crate) fn double_root(points: &[[Point; 4]; 2]) -> Option<Ratio> {
    let [a0, a1, a2, a3] = coplanarity(points);
    let numerator = IBig::from(9) * &a0 * &a3 - &a1 * &a2;
    let denominator = IBig::from(2) * (&a2 * &a2 - IBig::from(3) * &a1 * &a3);
    if denominator.is_zero() {
        return None;
    }
    let (n, d) = (&numerator, &denominator);
    let value = a0 * d.pow(3) + &a1 * d.pow(2) * n + &a2 * d * n.pow(2) + &a3 * n.pow(3);
    let slope = a1 * d.pow(2) + IBig::from(2) * a2 * d * n + IBig::from(3) * a3 * n.pow(2);
    (value.is_zero() && slope.is_zero()).then_some(Ratio {
        numerator,
        denominator,
    })
}

/// The coefficients of a multiple of the determinant of x₁ − x₀, x₂ − x₀, x₃ − x₀, from its values
/// at four times.
fn coplanarity(points: &[[Point; 4]; 2]) -> [IBig; 4] {
    let axes = [0, 1, 2]
        .map(|axis: usize| in_one_unit([0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| points[i / 4][i % 4][axis])));
    let value = |t: i32| {
        let at = |axis: usize, i: usize| &axes[axis][i] + (&axes[axis][i + 4] - &axes[axis][i]) * t;
        let [a, b, c] = [1, 2, 3].map(|i| [0, 1, 2].map(|axis| at(axis, i) - at(axis, 0)));
        &a[0] * (&b[1] * &c[2] - &b[2] * &c[1])
            + &a[1] * (&b[2] * &c[0] - &b[0] * &c[2])
            + &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
    };
    let [before, start, end, after] = [-1, 0, 1, 2].map(value);
    // Newton's differences, times six.
    let cubic = &after - IBig::from(3) * &end + IBig::from(3) * &start - &before;
    let quadratic = IBig::from(3) * (&end + &before - IBig::from(2) * &start);
    let linear = IBig::from(3) * (end - before) - &cubic;
    [IBig::from(6) * start, linear, quadratic, cubic]
}

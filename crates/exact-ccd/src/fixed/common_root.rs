//! The common root of a quadratic and another polynomial, by their resultant.

use arrayvec::ArrayVec;

use super::dyadic::Dyadic;
use super::length::{LongArea, Volume};
use super::wide::Wide;
use super::window::{has_one_root, linear_sign_at, quadratic_sign_at};

/// A quadratic q₀ (1−t)² + q₁ (1−t) t + q₂ t².
pub(super) type Quadratic = [LongArea; 3];

/// The quadratics that decide contact and are not zero: at most one for each of three axes and a scalar
/// product, for four sides.
pub(super) type Quadratics = ArrayVec<Quadratic, 16>;

/// An integer of 1792 bits.
///
/// [Areas](super::length::Length) are below 2²⁵¹ and volumes below 2³⁷⁸. So coefficients of [`reduced`]
/// cubics are below 2⁶³⁰, their minors with areas below 2⁸⁸², and a resultant below 2¹⁷⁶⁵.
type Integer = Wide<28>;

/// Returns true if a quadratic certainly vanishes at the root of another one in a bracket.
pub(super) fn vanishes_at_quadratic_root(
    quadratic: &Quadratic,
    other: &Quadratic,
    bracket: [Dyadic; 2],
) -> bool {
    has_one_root(&raised(other), bracket) && have_common_root(quadratic, &other.map(Wide::widened), bracket)
}

/// Returns true if a quadratic certainly vanishes at the root of a cubic in a bracket.
pub(super) fn vanishes_at_cubic_root(
    quadratic: &Quadratic,
    cubic: &[Volume; 4],
    bracket: [Dyadic; 2],
) -> bool {
    has_one_root(cubic, bracket)
        && reduced(cubic, quadratic).is_some_and(|other| have_common_root(quadratic, &other, bracket))
}

/// Returns true if two quadratics q and r certainly have a common root strictly inside a bracket.
///
/// They have a common root exactly if their resultant (q₀ r₂ − q₂ r₀)² − (q₀ r₁ − q₁ r₀) (q₁ r₂ − q₂ r₁) is
/// zero. If they are no multiples of each other, they have one common root: the zero of (q₀ r − r₀ q) / t,
/// which is (q₀ r₁ − q₁ r₀) (1−t) + (q₀ r₂ − q₂ r₀) t. Otherwise, a root of q is one of r.
fn have_common_root(quadratic: &Quadratic, other: &[Integer; 3], bracket: [Dyadic; 2]) -> bool {
    let [q0, q1, q2] = quadratic.map(Wide::widened);
    let &[r0, r1, r2] = other;
    let minors @ [first, outer, last] = [q0 * r1 - q1 * r0, q0 * r2 - q2 * r0, q1 * r2 - q2 * r1];
    let signs = if minors.iter().all(Wide::is_zero) {
        bracket.map(|time| quadratic_sign_at(*quadratic, time.into()))
    } else if (outer * outer - first * last).is_zero() {
        bracket.map(|time| linear_sign_at(&[first, outer], time.into()))
    } else {
        return false;
    };
    let [low, high] = signs;
    low.is_ne() && low.reverse() == high
}

/// A quadratic that has the common roots of a cubic and a quadratic in common with the latter, and no others
/// inside the step: (q₂ c − c₃ t q) / (1−t), or (q₀ c − c₀ (1−t) q) / t if q₂ is zero.
fn reduced([c0, c1, c2, c3]: &[Volume; 4], quadratic: &Quadratic) -> Option<[Integer; 3]> {
    let [c0, c1, c2, c3] = [c0, c1, c2, c3].map(|c| c.widened());
    let [q0, q1, q2] = quadratic.map(Wide::widened);
    if !q2.is_zero() {
        Some([q2 * c0, q2 * c1 - c3 * q0, q2 * c2 - c3 * q1])
    } else if !q0.is_zero() {
        Some([q0 * c1 - c0 * q1, q0 * c2 - c0 * q2, q0 * c3])
    } else {
        None
    }
}

/// The quadratic, times (1−t) + t.
pub(super) fn raised([q0, q1, q2]: &Quadratic) -> [Volume; 4] {
    let [q0, q1, q2] = [q0, q1, q2].map(|q| q.widened());
    [q0, q0 + q1, q1 + q2, q2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear function by its values at the ends of the step.
    type Linear = [i128; 2];

    fn quadratic([a, b]: Linear, [c, d]: Linear) -> Quadratic {
        [a * c, a * d + b * c, b * d].map(Wide::from)
    }

    fn cubic(first: Linear, second: Linear, [e, f]: Linear) -> [Volume; 4] {
        let [q0, q1, q2] = quadratic(first, second).map(Wide::widened::<6>);
        let [e, f] = [e, f].map(Volume::from);
        [q0 * e, q1 * e + q0 * f, q2 * e + q1 * f, q2 * f]
    }

    /// The times k / 64 before and after the zero of a linear function that is not such a time.
    fn bracket([a, b]: Linear) -> Option<[Dyadic; 2]> {
        let [start, end] = if a < 0 { [-a, b] } else { [a, -b] };
        let parts = 64 * start;
        let is_inside = start > 0 && end > 0 && parts % (start + end) != 0;
        let low = (parts as f64 / (start + end) as f64).floor();
        let [low, high] = [low, low + 1.0].map(|k| Dyadic::new(k / 64.0));
        is_inside.then_some([low?, high?])
    }

    #[test]
    fn a_quadratic_vanishes_at_the_roots_that_it_has_in_common() {
        let mut random = fastrand::Rng::with_seed(1);
        let (mut common, mut other) = (0, 0);
        while common < 2000 || other < 2000 {
            let [l, m, n, k] = [(); 4].map(|()| [random.i128(-30..30), random.i128(-30..30)]);
            let (Some(at_l), Some(at_m)) = (bracket(l), bracket(m)) else {
                continue;
            };
            // The only root of each function in its bracket, and no common root of others.
            let is_alone = |at: [Dyadic; 2], others: &[Linear]| {
                others.iter().all(|&other| {
                    let signs = at.map(|time| linear_sign_at(&other.map(Integer::from), time.into()));
                    signs[0].is_ne() && signs[0] == signs[1]
                })
            };
            if !is_alone(at_l, &[m, n, k]) || !is_alone(at_m, &[l, n, k]) {
                continue;
            }
            let q = quadratic(l, n);
            assert!(
                vanishes_at_quadratic_root(&q, &quadratic(l, m), at_l),
                "{l:?} {m:?} {n:?}"
            );
            assert!(
                vanishes_at_cubic_root(&q, &cubic(l, m, k), at_l),
                "{l:?} {m:?} {n:?} {k:?}"
            );
            common += 1;
            assert!(
                !vanishes_at_quadratic_root(&q, &quadratic(l, m), at_m),
                "{l:?} {m:?} {n:?}"
            );
            assert!(
                !vanishes_at_cubic_root(&q, &cubic(l, m, k), at_m),
                "{l:?} {m:?} {n:?} {k:?}"
            );
            assert!(
                !vanishes_at_quadratic_root(&quadratic(k, n), &quadratic(l, m), at_l),
                "{l:?} {k:?} {n:?}"
            );
            other += 1;
        }
    }

    #[test]
    fn a_bracket_of_two_roots_decides_nothing() {
        let mut random = fastrand::Rng::with_seed(2);
        let mut found = 0;
        while found < 500 {
            let [l, m, n, k] = [(); 4].map(|()| [random.i128(-300..300), random.i128(-300..300)]);
            let (Some(at), Some(at_m)) = (bracket(l), bracket(m)) else {
                continue;
            };
            if at != at_m || bracket(n) == Some(at) || bracket(k) == Some(at) {
                continue;
            }
            // The moment is the root of m, where l n does not vanish unless both roots are the same.
            assert!(
                !vanishes_at_cubic_root(&quadratic(l, n), &cubic(l, m, k), at),
                "{l:?} {m:?}"
            );
            assert!(
                !vanishes_at_quadratic_root(&quadratic(l, n), &quadratic(l, m), at),
                "{l:?} {m:?}"
            );
            found += 1;
        }
    }

    #[test]
    fn a_root_at_an_end_of_a_bracket_decides_nothing() {
        // The cubic vanishes at 1/4, an end of the bracket, and at 1/4 + 1/256.
        let (at_end, inside, after) = ([-1, 3], [-65, 191], [-3, 1]);
        let at = [16.0, 17.0].map(|k| Dyadic::new(k / 64.0).expect("a multiple of the unit"));
        let cubic = cubic(at_end, inside, after);
        assert!(!vanishes_at_cubic_root(&quadratic(inside, [3, 5]), &cubic, at));
    }

    #[test]
    fn multiples_have_all_roots_in_common() {
        for (l, m) in [
            ([-3, 8], [-5, 2]),
            ([-1, 6], [7, 9]),
            ([4, -7], [0, 5]),
            ([-3, 4], [2, 0]),
        ] {
            let at = bracket(l).expect("a zero inside the step");
            let q = quadratic(l, m);
            assert!(vanishes_at_quadratic_root(&q, &q.map(|x| x + x), at));
            assert!(vanishes_at_cubic_root(&q, &cubic(l, m, [1, 3]), at));
        }
    }
}

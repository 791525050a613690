//! The side of a plane, exactly.

use exact_ccd::{Point, Separation, environment};

use super::first_contact::Height;

/// Returns true if n · (x − p) > d |n| for a distance d, exactly. False if a coordinate is not finite.
pub(super) fn is_beyond(normal: Point, point: Point, x: Point, d: Separation) -> bool {
    let numbers = [normal, point, x];
    if !numbers.as_flattened().iter().all(|number| number.is_finite()) {
        return false;
    }
    in_floating_point(normal, point, x, d).unwrap_or_else(|| in_integers(normal, point, x, d))
}

/// The filter, which needs the default [`environment`]. With the unit roundoff u, each of the three
/// products nᵢ (xᵢ − pᵢ) has two rounding errors and takes part in two sums, so that the error of their
/// sum s is at most γ₄ S, where S is the sum of the absolute values of the exact products and γ₄ = 4u /
/// (1 − 4u) (N. Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, section 3.1). The
/// computed S is at least (1 − u)⁴ S. The squares of |n| have one rounding error each and two sums, of
/// positive terms, underflow adds at most 3u to their normal sum, the square root halves these 6u and
/// adds one error, and the product by d adds another: less than 6u in all, relative to the result r. The
/// difference s − r has another error, of u |s − r|. So the sign of s − r is right if |s − r| > 8u (S +
/// r), up to underflow of the four other products, which adds at most 2⁻¹⁰⁷⁵ each: `MIN_POSITIVE` =
/// 2⁻¹⁰²² covers that. Overflow gives an infinite bound or NaN, which prove nothing.
fn in_floating_point(normal: Point, point: Point, x: Point, d: Separation) -> Option<bool> {
    let product = |axis: usize| normal[axis] * (x[axis] - point[axis]);
    let products = [product(0), product(1), product(2)];
    let sum = products[0] + products[1] + products[2];
    let size = products[0].abs() + products[1].abs() + products[2].abs();
    let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    let least = d.get() * squared.sqrt();
    let bound = 4.0 * f64::EPSILON * (size + least) + f64::MIN_POSITIVE;
    let excess = sum - least;
    // Comparisons with NaN and with an infinite bound are false.
    (environment::is_default() && squared.is_normal() && excess.abs() > bound).then_some(excess > 0.0)
}

/// The definition: the [`Height`] of a vertex at rest.
fn in_integers(normal: Point, point: Point, x: Point, d: Separation) -> bool {
    Height::new([normal, point], [x, x], d)
        .above_distance(0.0)
        .is_gt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The filter and the definition agree on numbers of any magnitude, near the plane too.
    #[test]
    fn the_filter_agrees_with_the_definition() {
        let mut random = fastrand::Rng::with_seed(18);
        let (mut decided, mut left) = (0, 0);
        for case in 0..20_000 {
            let mut number = || {
                let exponent = match case % 4 {
                    0 => random.i32(-1074..1023),
                    1 => random.i32(-530..-500),
                    _ => random.i32(-3..3),
                };
                (2.0 * random.f64() - 1.0) * 2.0_f64.powi(exponent)
            };
            // Normals of any length: sums and products of their components differ.
            let scale = [1.0, 2.0_f64.powi(-200), 2.0_f64.powi(200)][case / 4 % 3];
            let normal = [number(), number(), number()].map(|x| scale * x);
            let point = [number(), number(), number()];
            let mut x = [number(), number(), number()];
            let mut d = if case % 3 == 0 { number().abs() } else { 0.0 };
            if case % 4 > 1 {
                // Near the boundary: the last coordinate solves the equation, up to some units of rounding.
                let length = (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]).sqrt();
                let rest = (0..2)
                    .map(|axis| normal[axis] * (x[axis] - point[axis]))
                    .sum::<f64>();
                x[2] = point[2] + (d * length - rest) / normal[2];
                (0..random.u32(0..40)).for_each(|_| x[2] = x[2].next_up());
                d = if d > 0.0 { d.next_up() } else { 0.0 };
            }
            if normal
                .iter()
                .chain(&point)
                .chain(&x)
                .all(|number| number.is_finite())
            {
                let d = Separation::new(d).expect("a magnitude is not negative");
                let exact = in_integers(normal, point, x, d);
                match in_floating_point(normal, point, x, d) {
                    Some(found) => {
                        decided += 1;
                        assert_eq!(found, exact, "{normal:?} {point:?} {x:?} {d}");
                    }
                    None => left += 1,
                }
            }
        }
        assert!(decided > 9000 && left > 3000, "{decided} {left}");
    }

    /// A point of the boundary is not beyond it, the next number is.
    #[test]
    fn the_boundary_is_exact() {
        let is_beyond = |normal, point, x, d| {
            let d = Separation::new(d).expect("the distances here are not negative");
            is_beyond(normal, point, x, d)
        };
        let ground = |height: f64, d| is_beyond([0.0, 3.0, 0.0], [7.0, 0.1, 0.0], [1e9, height, 0.3], d);
        assert!(!ground(0.1, 0.0) && ground(0.1_f64.next_up(), 0.0) && !ground(f64::NAN, 0.0));
        // 0.1 + 0.25 is not an f64: its neighbours are on different sides.
        let sum: f64 = 0.1 + 0.25;
        let sides = [sum.next_down(), sum, sum.next_up()].map(|height| ground(height, 0.25));
        assert!(!sides[0] && sides[2], "{sides:?}");
        // The square of the smallest positive number is not a number, and still counts.
        let tiny = f64::from_bits(1);
        assert!(is_beyond([tiny, 0.0, 0.0], [0.0; 3], [tiny, 0.0, 0.0], 0.0));
        assert!(!is_beyond([tiny, 0.0, 0.0], [0.0; 3], [tiny, 0.0, 0.0], tiny));
        assert!(is_beyond([1e300, 1e300, 0.0], [-1e308; 3], [1e308; 3], 1e308));
    }

    /// Sums of products that cancel, whose roundings have the other sign; products and squares that
    /// underflow; and heights that are nearly the distance.
    #[test]
    fn roundings_decide_nothing() {
        let assert_exact = |normal: Point, x: Point, d: f64| {
            let d = Separation::new(d).expect("the distances here are not negative");
            let exact = in_integers(normal, [0.0; 3], x, d);
            let found = in_floating_point(normal, [0.0; 3], x, d);
            assert!(
                found.is_none_or(|found| found == exact),
                "{normal:?} {x:?} {d} {exact}"
            );
        };
        let power = |exponent: i32| 2.0_f64.powi(exponent);
        let a = 1.0 + power(-52);
        for scale in [1.0, power(40)] {
            // The square of a is 1 + 2 / 2^52 + 1 / 2^104. Rounding loses the last term.
            let normal = [a, 1.0, 1.0].map(|n| scale * n);
            assert_exact(normal, [a, -(1.0 + power(-51)), -power(-105)], 0.0);
        }
        assert_exact([power(-500), 0.0, 0.0], [power(-600), 0.0, 0.0], 0.0);
        assert_exact([power(-540), 0.0, 0.0], [1.0, 0.0, 0.0], 2.0);
        let mut random = fastrand::Rng::with_seed(19);
        for _ in 0..2000 {
            let mut number = || 0.5 + random.f64();
            let (x, normal) = (number(), [number(), number(), number()]);
            // The last coordinate cancels the others.
            let rest = normal[0] * x + normal[1] * power(-53);
            let last = -rest / normal[2];
            // All products are positive, and d is about the height above the plane.
            let distance = x * 3.0_f64.sqrt();
            for [last, distance] in [
                [last.next_down(), distance.next_down()],
                [last, distance],
                [last.next_up(), distance.next_up()],
            ] {
                assert_exact(normal, [x, power(-53), last], 0.0);
                assert_exact([1.0; 3], [x; 3], distance);
            }
        }
    }
}

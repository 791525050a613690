//! Squared distances of primitives at rest.
//!
//! C. Ericson, *Real-Time Collision Detection*, Morgan Kaufmann, 2005, sections 5.1.5 and 5.1.9.

use exact_ccd::Point;

use crate::vector::{dot, minus};

/// a + s d
fn along(a: Point, s: f64, d: Point) -> Point {
    std::array::from_fn(|axis| a[axis] + s * d[axis])
}

fn squared(a: Point) -> f64 {
    dot(&a, &a)
}

/// The squared distance of a point from a triangle, by the region of its plane over which the point lies.
pub(super) fn point_triangle([p, a, b, c]: [Point; 4]) -> f64 {
    let (ab, ac) = (minus(&b, &a), minus(&c, &a));
    let [(d1, d2), (d3, d4), (d5, d6)] = [a, b, c].map(|corner| {
        let from_corner = minus(&p, &corner);
        (dot(&ab, &from_corner), dot(&ac, &from_corner))
    });
    // The closest corner.
    if d1 <= 0.0 && d2 <= 0.0 {
        return squared(minus(&p, &a));
    }
    if d3 >= 0.0 && d4 <= d3 {
        return squared(minus(&p, &b));
    }
    if d6 >= 0.0 && d5 <= d6 {
        return squared(minus(&p, &c));
    }
    // The closest edge.
    let [of_a, of_b, of_c] = [d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2];
    if of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return squared(minus(&p, &along(a, d1 / (d1 - d3), ab)));
    }
    if of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return squared(minus(&p, &along(a, d2 / (d2 - d6), ac)));
    }
    let (to_c, to_b) = (d4 - d3, d5 - d6);
    if of_a <= 0.0 && to_c >= 0.0 && to_b >= 0.0 {
        return squared(minus(&p, &along(b, to_c / (to_c + to_b), minus(&c, &b))));
    }
    let sum = of_a + of_b + of_c;
    squared(minus(&p, &along(along(a, of_b / sum, ab), of_c / sum, ac)))
}

/// The squared length up to which a segment counts as a point, in the units of the input.
const POINT: f64 = 1e-8;

/// The squared distance of two segments, by the closest points of their lines, moved into the
/// segments one after the other.
pub(super) fn segment_segment([a0, a1, b0, b1]: [Point; 4]) -> f64 {
    let (d1, d2, r) = (minus(&a1, &a0), minus(&b1, &b0), minus(&a0, &b0));
    let (a, e) = (squared(d1), squared(d2));
    let (b, c, f) = (dot(&d1, &d2), dot(&d1, &r), dot(&d2, &r));
    let unit = |x: f64| x.clamp(0.0, 1.0);
    let (s, t) = if a <= POINT && e <= POINT {
        (0.0, 0.0)
    } else if a <= POINT {
        (0.0, unit(f / e))
    } else if e <= POINT {
        (unit(-c / a), 0.0)
    } else {
        let denominator = a * e - b * b;
        let s = if denominator == 0.0 {
            0.0
        } else {
            unit((b * f - c * e) / denominator)
        };
        let t = (b * s + f) / e;
        if t < 0.0 {
            (unit(-c / a), 0.0)
        } else if t > 1.0 {
            (unit((b - c) / a), 1.0)
        } else {
            (s, t)
        }
    };
    squared(minus(&along(a0, s, d1), &along(b0, t, d2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Point; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

    #[test]
    fn each_region_of_the_triangle() {
        let [a, b, c] = TRIANGLE;
        for (p, expected) in [
            ([-1.0, -1.0, 1.0], 3.0),
            ([6.0, 0.0, 1.0], 5.0),
            ([-1.0, 6.0, 0.0], 5.0),
            ([1.0, -2.0, 0.0], 4.0),
            ([-2.0, 1.0, 1.0], 5.0),
            ([3.0, 3.0, 0.0], 2.0),
            ([1.0, 1.0, 3.0], 9.0),
        ] {
            assert!((point_triangle([p, a, b, c]) - expected).abs() < 1e-12, "{p:?}");
        }
    }

    #[test]
    fn segments_that_cross_pass_or_are_points() {
        let x = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        for (b, expected) in [
            ([[1.0, -1.0, 1.0], [1.0, 1.0, 1.0]], 1.0),
            ([[1.0, 1.0, 0.0], [1.0, 3.0, 0.0]], 1.0),
            ([[3.0, 1.0, 0.0], [3.0, 2.0, 0.0]], 2.0),
            ([[1.0, 2.0, 0.0], [2.0, 2.0, 0.0]], 4.0),
            ([[-3.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], 1.0),
            ([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]], 1.0),
        ] {
            assert!(
                (segment_segment([x[0], x[1], b[0], b[1]]) - expected).abs() < 1e-12,
                "{b:?}"
            );
            assert!(
                (segment_segment([b[0], b[1], x[0], x[1]]) - expected).abs() < 1e-12,
                "{b:?}"
            );
        }
    }
}

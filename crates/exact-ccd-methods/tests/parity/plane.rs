//! An edge that moves in a plane and a point of the plane, the origin, in integers.

use std::cmp::Ordering;

/// A point of the plane.
pub(crate) type Flat = [i64; 2];

fn cross(a: Flat, b: Flat) -> i64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: Flat, b: Flat) -> i64 {
    a[0] * b[0] + a[1] * b[1]
}

fn minus(a: Flat, b: Flat) -> Flat {
    [a[0] - b[0], a[1] - b[1]]
}

/// Twice the area of a triangle, negative if it is clockwise.
pub(crate) fn area([a, b, c]: [Flat; 3]) -> i64 {
    cross(minus(b, a), minus(c, a))
}

/// Returns true if the origin is on a segment.
pub(crate) fn is_on_segment(a: Flat, b: Flat) -> bool {
    cross(a, b) == 0 && dot(a, b) <= 0
}

/// Returns true if the origin is inside of a triangle.
pub(crate) fn is_in_triangle([a, b, c]: [Flat; 3]) -> bool {
    let sides = [cross(a, b), cross(b, c), cross(c, a)].map(i64::signum);
    sides == [1; 3] || sides == [-1; 3]
}

/// The number of times, with multiplicity, that the inside of an edge passes the origin in a step
/// in which it moves from q₀ q₃ to q₁ q₂. The edge must not contain the origin at an end of the
/// step, and neither of its ends may pass the origin.
///
/// The edge from P(s) to Q(s) passes the origin where P × Q = 0 and P · Q < 0.
pub(crate) fn passages([q0, q1, q2, q3]: [Flat; 4]) -> usize {
    let (p, q) = ([q0, minus(q1, q0)], [q3, minus(q2, q3)]);
    let product =
        |of: fn(Flat, Flat) -> i64| [of(p[0], q[0]), of(p[0], q[1]) + of(p[1], q[0]), of(p[1], q[1])];
    let along = product(dot);
    let passes = |s: &Surd| s.sign([0, 1, 0]).is_gt() && s.sign([1, -1, 0]).is_gt() && s.sign(along).is_lt();
    Surd::roots(product(cross)).iter().filter(|s| passes(s)).count()
}

/// c₀ + c₁ s + c₂ s².
type Quadratic = [i64; 3];

/// (a + b √d) / c, d ≥ 0, c ≠ 0.
struct Surd {
    a: i64,
    b: i64,
    c: i64,
    d: i64,
}

impl Surd {
    /// The roots, a double one twice; none of the zero polynomial.
    fn roots([c0, c1, c2]: Quadratic) -> Vec<Self> {
        let d = c1 * c1 - 4 * c0 * c2;
        let root = |a, b, c| Self { a, b, c, d };
        match (c2, c1) {
            (0, 0) => vec![],
            (0, _) => vec![root(-c0, 0, c1)],
            _ if d < 0 => vec![],
            _ => vec![root(-c1, 1, 2 * c2), root(-c1, -1, 2 * c2)],
        }
    }

    /// The sign of a polynomial at this number.
    fn sign(&self, [c0, c1, c2]: Quadratic) -> Ordering {
        let &Self { a, b, c, d } = self;
        // c² times the value is m + n √d.
        let m = c0 * c * c + c1 * a * c + c2 * (a * a + b * b * d);
        let n = c1 * b * c + 2 * c2 * a * b;
        // The part with the larger magnitude decides the sign.
        let (of_m, of_n) = (m.cmp(&0), n.cmp(&0));
        match (m * m).cmp(&(n * n * d)) {
            Ordering::Less => of_n,
            Ordering::Equal if of_m != of_n => Ordering::Equal,
            _ => of_m,
        }
    }
}

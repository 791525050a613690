//! A bilinear patch in one plane with the origin, exactly.

use std::cmp::Ordering;

use dashu_int::IBig;

use crate::vector::{Vector, dot, turn};

/// The coefficients of a quadratic, from the constant one.
type Coefficients = [IBig; 3];

/// A line from s = 0 to s = 1: its constant and its linear part.
type Line = [Vector<IBig>; 2];

/// Returns true if a patch with four corners, all in one plane with the origin, contains the origin.
///
/// It is swept by a segment, from P(s) on the side ab to Q(s) on the side dc. The origin is on the
/// segment if P × Q = 0 and P · Q ≤ 0: the sign of one quadratic at the roots in [0, 1] of another,
/// or, if that vanishes for all s, wherever it is least. The hull of the corners can be larger than
/// the patch, and the patch can fold over and cover more than its outline winds around.
pub(super) fn contains_origin([a, b, c, d]: [&Vector<IBig>; 4]) -> bool {
    let (p, q) = (line(a, b), line(d, c));
    let along = product(dot, &p, &q);
    // The normal of the plane times one quadratic.
    let across = [0, 1, 2]
        .map(|axis| product(|p, q| turn(axis, p, q), &p, &q))
        .into_iter()
        .find(|quadratic| quadratic.iter().any(|coefficient| sign(coefficient).is_ne()));
    let Some(across) = across else {
        return falls_to_zero(&along);
    };
    let from_start = [0, 1, 0].map(IBig::from);
    let to_end = [1, -1, 0].map(IBig::from);
    roots(&across)
        .iter()
        .any(|root| root.sign(&from_start).is_ge() && root.sign(&to_end).is_ge() && root.sign(&along).is_le())
}

fn line(a: &Vector<IBig>, b: &Vector<IBig>) -> Line {
    [a.clone(), [0, 1, 2].map(|axis: usize| &b[axis] - &a[axis])]
}

fn product(
    multiply: impl Fn(&Vector<IBig>, &Vector<IBig>) -> IBig,
    [p0, p1]: &Line,
    [q0, q1]: &Line,
) -> Coefficients {
    [
        multiply(p0, q0),
        multiply(p0, q1) + multiply(p1, q0),
        multiply(p1, q1),
    ]
}

fn sign(number: &IBig) -> Ordering {
    number.cmp(&IBig::ZERO)
}

/// b² − 4ac.
fn discriminant([c, b, a]: &Coefficients) -> IBig {
    b * b - IBig::from(4) * a * c
}

/// Returns true if a quadratic is zero or less somewhere in [0, 1]: at an end, or at a minimum in between,
/// which there is if it falls at the start and rises at the end.
fn falls_to_zero(quadratic: &Coefficients) -> bool {
    let [c, b, a] = quadratic;
    let has_minimum = sign(b).is_lt() && sign(&(b + a + a)).is_gt();
    sign(c).is_le() || sign(&(c + b + a)).is_le() || (has_minimum && sign(&discriminant(quadratic)).is_ge())
}

/// The number (x + y √Δ) / w.
struct Root {
    x: IBig,
    y: IBig,
    w: IBig,
    radicand: IBig,
}

/// The real roots of a quadratic that is not zero everywhere.
fn roots(quadratic: &Coefficients) -> Vec<Root> {
    let [c, b, a] = quadratic;
    let radicand = discriminant(quadratic);
    let root = |x: &IBig, y: i8, w: IBig| Root {
        x: -x,
        y: IBig::from(y),
        w,
        radicand: radicand.clone(),
    };
    if sign(&radicand).is_lt() {
        vec![]
    } else if sign(a).is_ne() {
        vec![root(b, 1, a + a), root(b, -1, a + a)]
    } else if sign(b).is_ne() {
        vec![root(c, 0, b.clone())]
    } else {
        vec![]
    }
}

impl Root {
    /// The sign of a quadratic at the root. It is the sign of w² times the value, which is X + Y √Δ.
    fn sign(&self, [c, b, a]: &Coefficients) -> Ordering {
        let Self { x, y, w, radicand } = self;
        let integer = c * w * w + b * w * x + a * (x * x + y * y * radicand);
        let factor = b * w * y + (a + a) * x * y;
        // Δ is not negative.
        let (of_integer, of_root) = (sign(&integer), sign(&(&factor * radicand)));
        if of_integer != of_root.reverse() {
            return of_integer.then(of_root);
        }
        match sign(&(&integer * &integer - &factor * &factor * radicand)) {
            Ordering::Less => of_root,
            Ordering::Equal => Ordering::Equal,
            Ordering::Greater => of_integer,
        }
    }
}

//! The definition of a common point, as a system of linear equations and inequalities over the
//! rational numbers: a + s (b − a) = v₁ + u (v₂ − v₁) + v (v₃ − v₁) with 0 ≤ s ≤ 1, 0 ≤ u, 0 ≤ v
//! and u + v ≤ 1.
//!
//! Equations eliminate unknowns; the method of Fourier and Motzkin eliminates the remaining ones.
//! There are no special cases.

use std::cmp::Ordering;

use dashu_ratio::RBig;
use exact_ccd::Point;

/// The coefficients of s, u and v, and the constant.
type Row = [RBig; 4];

/// A finite number.
pub fn exactly(x: f64) -> RBig {
    RBig::try_from(x).unwrap()
}

fn minus(p: Point, q: Point) -> [RBig; 3] {
    [0, 1, 2].map(|axis: usize| exactly(p[axis]) - exactly(q[axis]))
}

fn row(coefficients: [i8; 4]) -> Row {
    coefficients.map(|x| exactly(x.into()))
}

/// Returns true if an edge and a face have a common point.
pub fn intersect([a, b]: [Point; 2], [v1, v2, v3]: [Point; 3]) -> bool {
    let (edge, e1, e2, w) = (minus(b, a), minus(v1, v2), minus(v1, v3), minus(a, v1));
    let equation = |axis: usize| [&edge, &e1, &e2, &w].map(|vector| vector[axis].clone());
    let equations: Vec<Row> = [0, 1, 2].map(equation).to_vec();
    let at_least_zero = [
        [1, 0, 0, 0],
        [-1, 0, 0, 1],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, -1, -1, 1],
    ];
    let at_least_zero: Vec<Row> = at_least_zero.map(row).to_vec();

    let (equations, at_least_zero) = (0..3).fold((equations, at_least_zero), eliminate);
    equations.iter().all(|row| row[3] == RBig::ZERO) && at_least_zero.iter().all(|row| row[3] >= RBig::ZERO)
}

/// The system that the other unknowns fulfil if and only if there is a value for this one.
fn eliminate((mut equations, rows): (Vec<Row>, Vec<Row>), unknown: usize) -> (Vec<Row>, Vec<Row>) {
    if let Some(pivot) = equations.iter().position(|row| row[unknown] != RBig::ZERO) {
        let pivot = equations.swap_remove(pivot);
        let substitute = |row: Row| {
            let factor = &row[unknown] / &pivot[unknown];
            combine(&row, &exactly(1.0), &pivot, &-factor)
        };
        return (
            equations.into_iter().map(substitute).collect(),
            rows.into_iter().map(substitute).collect(),
        );
    }
    let sign = |row: &&Row| row[unknown].cmp(&RBig::ZERO);
    let with = |wanted: Ordering| rows.iter().filter(move |row| sign(row) == wanted);
    let mut left: Vec<Row> = with(Ordering::Equal).cloned().collect();
    for lower in with(Ordering::Greater) {
        for upper in with(Ordering::Less) {
            left.push(combine(lower, &-upper[unknown].clone(), upper, &lower[unknown]));
        }
    }
    (equations, left)
}

fn combine(a: &Row, m: &RBig, b: &Row, n: &RBig) -> Row {
    [0, 1, 2, 3].map(|k: usize| &a[k] * m + &b[k] * n)
}

/// The sign of (a − d) · ((b − d) × (c − d)).
pub fn orientation([a, b, c, d]: [Point; 4]) -> Ordering {
    let (u, v, w) = (minus(a, d), minus(b, d), minus(c, d));
    let minor = |i: usize, j: usize| &v[i] * &w[j] - &v[j] * &w[i];
    let volume = &u[0] * minor(1, 2) + &u[1] * minor(2, 0) + &u[2] * minor(0, 1);
    volume.cmp(&RBig::ZERO)
}

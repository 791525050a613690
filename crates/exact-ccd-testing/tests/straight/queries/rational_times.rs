//! Contact at a simple fraction of the step is a system of three linear equations in u and v.

use exact_ccd::{CONTACT, EdgeEdge, VertexFace};
use proptest::prelude::*;

use crate::queries::rational::Rational;
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::primitives::{Points, Primitives, combine};
use exact_ccd_testing::runner::for_all;

/// One component of n F(m / n, u, v) = c + a u + b v. The coefficients are integers if the
/// coordinates are.
#[derive(Clone, Copy)]
struct Equation {
    c: f64,
    a: f64,
    b: f64,
}

impl Equation {
    fn value(self, [u, v]: [f64; 2]) -> f64 {
        self.c + self.a * u + self.b * v
    }

    /// Returns true if another equation with parallel (a, b) is a multiple of this one, whose (a,
    /// b) is not zero.
    fn implies(self, other: Self) -> bool {
        self.a * other.c == other.a * self.c && self.b * other.c == other.b * self.c
    }
}

fn equations<K: Primitives>(points: &Points, time: Rational) -> [Equation; 3] {
    let (m, n) = time.parts();
    let scaled = [0, 1, 2, 3].map(|i: usize| combine([n - m, m], [points[0][i], points[1][i]]));
    let at = |u, v| combine(K::weights(u, v), scaled);
    let (c, a, b) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
    [0, 1, 2].map(|axis: usize| Equation {
        c: c[axis],
        a: a[axis] - c[axis],
        b: b[axis] - c[axis],
    })
}

/// Returns true if the equations have a common solution in the domain, by the rank of the
/// coefficients of u and v.
fn have_solution<K: Primitives>(equations: &[Equation; 3]) -> bool {
    for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let [e, f, g] = [i, j, k].map(|i: usize| equations[i]);
        let determinant = e.a * f.b - f.a * e.b;
        if determinant != 0.0 {
            // Cramer's rule, with a positive denominator.
            let sign = determinant.signum();
            let one = determinant.abs();
            let u = sign * (f.c * e.b - e.c * f.b);
            let v = sign * (e.c * f.a - f.c * e.a);
            return K::contains([u, v], one) && g.c * one + g.a * u + g.b * v == 0.0;
        }
    }
    match equations.iter().find(|e| e.a != 0.0 || e.b != 0.0) {
        Some(line) => {
            // A line meets a convex domain unless all corners are strictly on one side.
            let values = || K::DOMAIN.iter().map(|&corner| line.value(corner));
            equations.iter().all(|e| line.implies(*e))
                && values().any(|value| value <= 0.0)
                && values().any(|value| value >= 0.0)
        }
        None => equations.iter().all(|e| e.c == 0.0),
    }
}

fn touch_at_reported_times_only<K: Primitives>() {
    let points = prop_oneof![
        3 => small_integers(2),
        2 => small_integers(8),
        3 => degenerate(small_integers(2)),
        1 => exact_contacts::<K>(small_integers(8)),
        1 => exact_grazes::<K>(small_integers(8)),
    ];
    for_all(8_000, points, |points| {
        let times = query::<K>(&points).intervals(CONTACT);
        for time in Rational::all_in_unit(8) {
            let touches = have_solution::<K>(&equations::<K>(&points, time));
            assert_eq!(
                touches,
                time.is_among(&times),
                "{times:?}, at {time:?}: {points:?}"
            );
        }
    });
}

#[test]
fn a_vertex_touches_a_face_at_reported_times_only() {
    touch_at_reported_times_only::<VertexFace>();
}

#[test]
fn edges_touch_at_reported_times_only() {
    touch_at_reported_times_only::<EdgeEdge>();
}

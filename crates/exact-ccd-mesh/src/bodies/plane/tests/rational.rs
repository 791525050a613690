//! The places of points of a body in rational numbers, by the definition of its motion.

use dashu_ratio::RBig;
use exact_ccd::Point;
use exact_ccd::motion::RigidMotion;

pub(super) type Rational = RBig;

pub(super) fn exactly(x: f64) -> Rational {
    RBig::try_from(x).expect("a finite number")
}

/// a · b.
pub(super) fn product(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]: [usize; 2]| &a[i] * &b[j] - &a[j] * &b[i])
}

/// (1 − t) a + t b.
fn between(a: &Rational, b: &Rational, time: &Rational) -> Rational {
    a + time * (b - a)
}

/// The place of a point of a body at a time: o + v + 2 (s r × v + r × (r × v)) / (s² + r²) for the
/// quaternion with the scalar s and the vector r.
pub(super) fn place(motion: &RigidMotion, point: Point, time: f64) -> [Rational; 3] {
    let time = exactly(time);
    let [start, end] = motion.quaternions().map(|q| q.map(exactly));
    let [s, x, y, z] = [0, 1, 2, 3].map(|i: usize| between(&start[i], &end[i], &time));
    let r = [x, y, z];
    let v = point.map(exactly);
    let across = cross(&r, &v);
    let twice = cross(&r, &across);
    let factor = Rational::from(2) / (&s * &s + product(&r, &r));
    let mut row: Vec<[Rational; 3]> = motion.places().iter().map(|p| p.map(exactly)).collect();
    while row.len() > 1 {
        let pairs = row.windows(2);
        row = pairs
            .map(|pair| [0, 1, 2].map(|axis: usize| between(&pair[0][axis], &pair[1][axis], &time)))
            .collect();
    }
    [0, 1, 2].map(|i: usize| &row[0][i] + &v[i] + &factor * (&s * &across[i] + &twice[i]))
}

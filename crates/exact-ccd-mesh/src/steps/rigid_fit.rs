//! The rotation of a body from one frame to another.

use std::f64::consts::SQRT_2;

use exact_ccd::Point;

use crate::vector::{cross, dot, minus};

/// The weight of no rotation, relative to the spread of the points. It decides where the points leave the
/// rotation open, such as the turn of a rod about its axis, and changes other fits by about this share.
const PREFERENCE: f64 = 1e-9;

/// The greatest residual of a rigid body, relative to its size.
const RIGID: f64 = 1e-3;
/// The least angle of a turn, in degrees.
const ANGLE: f64 = 10.0;
/// The least shrinkage of a turn, relative to the size of the body.
const SHRINKAGE: f64 = 1e-3;

/// The rotation and translation that bring points nearest to others, in the mean square: B. K. P. Horn,
/// *Closed-form solution of absolute orientation using unit quaternions*, 1987. In floating point, rounded.
///
/// Where vertices move in straight lines, a body that turns shrinks on the way: a vertex at the distance r of
/// the axis is r cos(angle / 2) away from it at t = 1/2.
///
/// ```
/// use exact_ccd_mesh::RigidFit;
///
/// // A rod, and the same rod a quarter of a turn later.
/// let start = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
/// let end = [[4.0, -1.0, 0.0], [4.0, 1.0, 0.0]];
/// let fit = RigidFit::new(&start, &end).unwrap();
/// assert!((fit.angle.to_degrees() - 90.0).abs() < 1e-6 && fit.residual < 1e-6);
/// // At t = 1/2, its ends are 0.71 away from its middle.
/// assert!((fit.shrinkage - (1.0 - 0.5_f64.sqrt())).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidFit {
    /// The angle of the rotation in radians, from 0 to π.
    pub angle: f64,
    /// The greatest distance of a moved point from its place at the end, relative to `size`: 0 of a rigid
    /// body.
    pub residual: f64,
    /// The greatest distance, relative to `size`, by which a vertex in straight motion is nearer to the axis
    /// at t = 1/2 than a rotation keeps it: r (1 − cos(angle / 2)).
    pub shrinkage: f64,
    /// The greatest distance of a point from their mean, at the start.
    pub size: f64,
}

impl RigidFit {
    /// The fit of as many points as both slices have; `None` if they are all in one place.
    #[must_use]
    pub fn new(start: &[Point], end: &[Point]) -> Option<Self> {
        let count = start.len().min(end.len());
        let all = || start[..count].iter().chain(&end[..count]);
        let unit = all().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        // At most 1 in magnitude: no sum overflows.
        let around_mean = |points: &[Point]| {
            let points: Vec<Point> = points[..count].iter().map(|p| p.map(|x| x / unit)).collect();
            let mean = [0, 1, 2].map(|axis: usize| {
                let sum: f64 = points.iter().map(|point| point[axis]).sum();
                sum / count as f64
            });
            points
                .into_iter()
                .map(|point| minus(point, mean))
                .collect::<Vec<_>>()
        };
        let [from, to] = [around_mean(start), around_mean(end)];
        let size = from.iter().map(|&p| dot(p, p).sqrt()).fold(0.0, f64::max);
        if !size.is_normal() {
            return None;
        }
        let [from, to] = [from, to].map(|points| {
            let scaled = points.into_iter().map(|point| point.map(|x| x / size));
            scaled.collect::<Vec<Point>>()
        });
        let [w, v @ ..] = rotation(&from, &to);
        let sine = dot(v, v).sqrt();
        let angle = 2.0 * sine.atan2(w.abs());
        let axis = v.map(|x| if sine > 0.0 { x / sine } else { 0.0 });
        let off = |(&a, &b): (&Point, &Point)| {
            let apart = minus(rotated([w, v[0], v[1], v[2]], a), b);
            dot(apart, apart).sqrt()
        };
        let from_axis = |&a: &Point| {
            let arm = cross(a, axis);
            dot(arm, arm).sqrt()
        };
        // 1 − cos(angle / 2), without cancellation.
        let lost = (SQRT_2 * (angle / 4.0).sin()).powi(2);
        Some(Self {
            angle,
            residual: from.iter().zip(&to).map(off).fold(0.0, f64::max),
            shrinkage: from.iter().map(from_axis).fold(0.0, f64::max) * lost,
            size: size * unit,
        })
    }

    /// Returns true if the points turn as a rigid body so far that their straight motion deserves a note: by
    /// more than 10°, with a shrinkage above 0.1 % of the size.
    #[must_use]
    pub fn is_turn(&self) -> bool {
        self.residual < RIGID && self.angle.to_degrees() > ANGLE && self.shrinkage > SHRINKAGE
    }

    /// The number of steps, in place of one, that keep the shrinkage below 0.1 % of the size.
    #[must_use]
    pub fn steps(&self) -> f64 {
        // A part of the angle loses 1 − cos(angle / (2 n)) in each of n steps.
        (self.angle / (2.0 * (1.0 - SHRINKAGE).acos())).ceil()
    }
}

/// The unit quaternion, real part first, of the rotation that brings points nearest to others: the
/// eigenvector of the greatest eigenvalue of Horn's matrix.
fn rotation(from: &[Point], to: &[Point]) -> [f64; 4] {
    let mut s = [[0.0; 3]; 3];
    for (a, b) in from.iter().zip(to) {
        for (row, x) in s.iter_mut().zip(a) {
            row.iter_mut().zip(b).for_each(|(sum, y)| *sum += x * y);
        }
    }
    // No rotation has the trace 3, the greatest one.
    let spread: f64 = from.iter().map(|&a| dot(a, a)).sum();
    (0..3).for_each(|axis| s[axis][axis] += PREFERENCE * spread);
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = s;
    greatest_eigenvector([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ])
}

/// A unit eigenvector of the greatest eigenvalue of a symmetric matrix, by Jacobi's method: each rotation of
/// two axes makes one entry zero. It converges in a few sweeps; the number of sweeps is limited for all
/// input.
fn greatest_eigenvector(mut m: [[f64; 4]; 4]) -> [f64; 4] {
    let mut vectors: [[f64; 4]; 4] =
        [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| f64::from(row == column)));
    for _ in 0..20 {
        for (p, q) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
            // The smaller of the two angles with tan(2 angle) = 2 m_pq / (m_qq − m_pp).
            let difference = m[q][q] - m[p][p];
            let sign = if difference < 0.0 { -1.0 } else { 1.0 };
            let angle = 0.5 * (2.0 * sign * m[p][q]).atan2(difference.abs());
            let (sine, cosine) = angle.sin_cos();
            let turn = |row: &mut [f64; 4]| {
                let [a, b] = [row[p], row[q]];
                (row[p], row[q]) = (cosine * a - sine * b, sine * a + cosine * b);
            };
            m.iter_mut().for_each(turn);
            vectors.iter_mut().for_each(turn);
            let (row_p, row_q) = (m[p], m[q]);
            m[p] = [0, 1, 2, 3].map(|k: usize| cosine * row_p[k] - sine * row_q[k]);
            m[q] = [0, 1, 2, 3].map(|k: usize| sine * row_p[k] + cosine * row_q[k]);
        }
    }
    let greatest = (1..4).fold(0, |best, i| if m[i][i] > m[best][best] { i } else { best });
    vectors.map(|row| row[greatest])
}

/// The point turned by a unit quaternion: p + 2 w (v × p) + 2 v × (v × p).
fn rotated([w, x, y, z]: [f64; 4], point: Point) -> Point {
    let once = cross([x, y, z], point);
    let twice = cross([x, y, z], once);
    [0, 1, 2].map(|axis| point[axis] + 2.0 * (w * once[axis] + twice[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::unit;

    fn random_point(random: &mut fastrand::Rng) -> Point {
        [0; 3].map(|_| 2.0 * random.f64() - 1.0)
    }

    /// Bodies of all dimensions, turned about random axes and moved, of any size.
    #[test]
    fn angles_of_rotations_are_found() {
        let mut random = fastrand::Rng::with_seed(7);
        for round in 0..300 {
            let dimension = 1 + round % 3;
            let scale = [1e-300, 1.0, 1e300][random.usize(0..3)];
            let frame = [0; 3].map(|_| random_point(&mut random));
            let point = |random: &mut fastrand::Rng| {
                let weights = random_point(random);
                [0, 1, 2].map(|axis| (0..dimension).map(|k| weights[k] * frame[k][axis]).sum::<f64>())
            };
            let points: Vec<Point> = (0..12).map(|_| point(&mut random)).collect();
            let angle = random.f64() * 3.1;
            let axis = unit(random_point(&mut random)).expect("it is not zero");
            // A rod turns about itself without an effect: its axis is perpendicular to it.
            let axis = match dimension {
                1 => unit(cross(axis, frame[0])).expect("they are not parallel"),
                _ => axis,
            };
            let (sine, cosine) = (angle / 2.0).sin_cos();
            let quaternion = [cosine, sine * axis[0], sine * axis[1], sine * axis[2]];
            let shift = random_point(&mut random);
            let start: Vec<Point> = points.iter().map(|p| p.map(|x| x * scale)).collect();
            let end = points.iter().map(|&p| {
                let p = rotated(quaternion, p);
                [0, 1, 2].map(|k| (p[k] + shift[k]) * scale)
            });
            let end: Vec<Point> = end.collect();
            let fit = RigidFit::new(&start, &end).expect("the points are apart");
            assert!((fit.angle - angle).abs() < 1e-4, "{dimension}: {fit:?} {angle}");
            assert!(fit.residual < 1e-4, "{dimension}: {fit:?}");
            // The shrinkage equals the shrinkage of the straight motion at t = 1/2.
            let middle = |k: usize| [0, 1, 2].map(|i| (start[k][i] / 2.0 + end[k][i] / 2.0) / scale);
            let mean = |at: &dyn Fn(usize) -> Point| {
                [0, 1, 2].map(|i| (0..12).map(|k| at(k)[i]).sum::<f64>() / 12.0)
            };
            let radius = |at: &dyn Fn(usize) -> Point, k: usize| {
                let arm = cross(minus(at(k), mean(at)), axis);
                dot(arm, arm).sqrt()
            };
            let at_start = |k: usize| points[k];
            let lost = (0..12).map(|k| radius(&at_start, k) - radius(&middle, k));
            let expected = lost.fold(0.0, f64::max) / (fit.size / scale);
            assert!((fit.shrinkage - expected).abs() < 1e-3, "{fit:?} {expected}");
            let is_turn = angle.to_degrees() > 10.0 && fit.shrinkage > 1e-3;
            assert!(
                fit.is_turn() == is_turn || (angle.to_degrees() - 10.0).abs() < 0.01,
                "{fit:?} {angle}"
            );
            // The shrinkage of a part of the turn.
            let lost = |steps: f64| 1.0 - (fit.angle / (2.0 * steps)).cos();
            let steps = fit.steps();
            assert!(lost(steps) <= 1e-3 * (1.0 + 1e-9), "{fit:?}");
            assert!(steps < 2.0 || lost(steps - 1.0) > 1e-3, "{fit:?}");
        }
    }

    /// A reflection is no rotation, unless the body is flat.
    #[test]
    fn reflections_are_not_rigid() {
        let mut random = fastrand::Rng::with_seed(8);
        let points: Vec<Point> = (0..9).map(|_| random_point(&mut random)).collect();
        let reflected: Vec<Point> = points.iter().map(|[x, y, z]| [*x, *y, -z]).collect();
        assert!(RigidFit::new(&points, &reflected).is_some_and(|fit| fit.residual > 0.1));
        let flat: Vec<Point> = points.iter().map(|[x, _, z]| [*x, 0.0, *z]).collect();
        let reflected: Vec<Point> = flat.iter().map(|[x, y, z]| [*x, *y, -z]).collect();
        let fit = RigidFit::new(&flat, &reflected).expect("the points are apart");
        assert!(
            fit.residual < 1e-6 && (fit.angle.to_degrees() - 180.0).abs() < 1e-6,
            "{fit:?}"
        );
    }

    #[test]
    fn degenerate_points_have_no_turn() {
        assert_eq!(RigidFit::new(&[], &[]), None);
        assert_eq!(RigidFit::new(&[[1.0; 3]; 4], &[[2.0; 3]; 4]), None);
        let rod = [[0.0; 3], [f64::MAX, 0.0, 0.0]];
        let fit = RigidFit::new(&rod, &rod).expect("the ends are apart");
        assert!(fit.angle < 1e-9 && fit.residual < 1e-9, "{fit:?}");
    }
}

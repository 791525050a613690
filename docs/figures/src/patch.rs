//! Bilinear patches.

use exact_ccd::Point;

use crate::vectors::{between, cross, dot};

/// The patch with four corners, in cyclic order.
#[derive(Clone, Copy)]
pub(crate) struct Patch(pub(crate) [Point; 4]);

impl Patch {
    /// The point with parameters s, along q₀ q₁, and r, along q₀ q₃.
    pub(crate) fn at(&self, s: f64, r: f64) -> Point {
        let [q0, q1, q2, q3] = self.0;
        between(between(q0, q1, s), between(q3, q2, s), r)
    }

    /// The patch cut into n × n.
    pub(crate) fn cells(&self, n: u32) -> Vec<[Point; 4]> {
        let part = |i: u32| f64::from(i) / f64::from(n);
        let cell = |i, j| {
            let [s, next_s, r, next_r] = [i, i + 1, j, j + 1].map(part);
            [
                self.at(s, r),
                self.at(next_s, r),
                self.at(next_s, next_r),
                self.at(s, next_r),
            ]
        };
        (0..n).flat_map(|i| (0..n).map(move |j| cell(i, j))).collect()
    }

    /// The crossings of the positive x axis with the patch: the roots of y = a + b s + c r + d s r and z =
    /// …, after r is eliminated.
    pub(crate) fn crossings(&self) -> Vec<f64> {
        let [q0, q1, q2, q3] = self.0;
        let coefficients = |axis: usize| {
            [
                q0[axis],
                q1[axis] - q0[axis],
                q3[axis] - q0[axis],
                q0[axis] - q1[axis] + q2[axis] - q3[axis],
            ]
        };
        let ([a, b, c, d], [e, f, g, h]) = (coefficients(1), coefficients(2));
        let is_in = |x: &f64| (0.0..=1.0).contains(x);
        let crossing = |s: f64| {
            let r = if (c + d * s).abs() > (g + h * s).abs() {
                -(a + b * s) / (c + d * s)
            } else {
                -(e + f * s) / (g + h * s)
            };
            let [x, ..] = self.at(s, r);
            (is_in(&s) && is_in(&r) && x > 0.0).then_some(x)
        };
        zeros([e * c - g * a, e * d + f * c - g * b - h * a, f * d - h * b])
            .into_iter()
            .filter_map(crossing)
            .collect()
    }

    /// The determinants V₀ … V₃ of the corners but one, as seen from the origin.
    pub(crate) fn volumes(&self) -> [f64; 4] {
        let [q0, q1, q2, q3] = self.0;
        [[q1, q2, q3], [q0, q2, q3], [q0, q1, q3], [q0, q1, q2]].map(|[a, b, c]| dot(a, cross(b, c)))
    }

    /// The signs of V₀, −V₁, V₂, −V₃.
    pub(crate) fn signs(&self) -> String {
        let [v0, v1, v2, v3] = self.volumes();
        let sign = |weight: f64| match weight {
            0.0 => "0",
            _ if weight > 0.0 => "+",
            _ => "−",
        };
        [v0, -v1, v2, -v3].map(sign).join(" ")
    }
}

/// The zeros of a + b x + c x².
fn zeros([a, b, c]: [f64; 3]) -> Vec<f64> {
    if c == 0.0 {
        return vec![-a / b];
    }
    let root = (b * b - 4.0 * a * c).sqrt();
    vec![(-b - root) / (2.0 * c), (-b + root) / (2.0 * c)]
}

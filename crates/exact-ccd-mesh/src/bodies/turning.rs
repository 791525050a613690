//! Rotations by linear quaternions: at a time, and how fast they turn.

use exact_ccd::Point;

use super::part::Part;

type Quaternion = [f64; 4];

/// A rotation at a time.
pub(super) struct Rotation {
    pub(super) matrix: [Point; 3],
    /// A bound of the distance of `matrix` v from the rotated v, for |v| = 1.
    pub(super) error: f64,
}

/// The quaternions q₀ and q₁ of a motion, scaled by a power of two so that the largest component is near 1.
pub(super) struct Turning([Quaternion; 2]);

impl Turning {
    pub(super) fn new(quaternions: [Quaternion; 2]) -> Self {
        let components = quaternions.as_flattened().iter();
        let largest = components.fold(0.0, |most: f64, x| most.max(x.abs()));
        // 2⁻ᵉ for the exponent e of the largest, as far as it is a normal number.
        let factor = f64::from_bits((2046 - (largest.to_bits() >> 52)).max(1) << 52);
        Self(quaternions.map(|q| q.map(|x| x * factor)))
    }

    /// q at a time, and κ = ((1 − t) |q₀| + t |q₁|) / |q|: the error of q is below 2⁻⁵⁰ κ |q|, by a product
    /// and a sum for each of two terms, and by what underflows.
    fn at(&self, time: f64) -> (Quaternion, f64) {
        let [s, t] = [1.0 - time, time];
        let [first, second] = &self.0;
        let q = [0, 1, 2, 3].map(|i: usize| s * first[i] + t * second[i]);
        (q, (s * norm(first) + t * norm(second)) / norm(&q))
    }

    /// The rotation at a time.
    ///
    /// Quaternions at a distance of δ |q| are rotations that differ by an angle of at most 4 δ, for δ below
    /// 1/2: by 2⁻⁴⁸ κ. An entry of the matrix has at most 10 roundings of terms that sum up to 2 at most,
    /// and a matrix with entries below x has a norm below 3 x: 60 · 2⁻⁵² < 2⁻⁴⁶. If κ is large, as where q
    /// almost vanishes, the result is the identity, which no rotation differs from by more than 2.
    pub(super) fn rotation(&self, time: f64) -> Rotation {
        let ([a, b, c, d], condition) = self.at(time);
        if !is_well_conditioned(condition) {
            return Rotation {
                matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                error: 2.0,
            };
        }
        let two = 2.0 / (a * a + b * b + c * c + d * d);
        let [bb, cc, dd] = [b * b, c * c, d * d].map(|x| two * x);
        let [bc, ad, bd, ac, cd, ab] = [b * c, a * d, b * d, a * c, c * d, a * b].map(|x| two * x);
        Rotation {
            matrix: [
                [1.0 - (cc + dd), bc - ad, bd + ac],
                [bc + ad, 1.0 - (bb + dd), cd - ab],
                [bd - ac, cd + ab, 1.0 - (bb + cc)],
            ],
            error: TWO_TO_MINUS_45 * condition,
        }
    }

    /// Bounds of the angular velocity and acceleration in a part of the step, whose length is the unit of
    /// time; `None` if q almost vanishes there.
    ///
    /// The axis is fixed, and half the angle is the angle of q in the plane of q₀ and q₁. With g = q′, which
    /// is constant, and the area A = |q| |g⊥|, g⊥ across q, which is constant too, half the angle has the
    /// derivatives A / |q|² and −2 A (q · g) / |q|⁴. In the part, q · g is linear, and |q| is at least the
    /// component of q along the bisector of both ends, which is linear too.
    ///
    /// Relative errors are below 2⁻⁴⁰ κ ≤ 2⁻²⁰, of |g| or |q| where terms cancel; the factor 1.001 covers
    /// them together.
    pub(super) fn speeds(&self, part: Part) -> Option<[f64; 2]> {
        let [(start, first), (end, second)] = [part.start, part.end].map(|time| self.at(time));
        let condition = first.max(second);
        if !(is_well_conditioned(first) && is_well_conditioned(second)) {
            return None;
        }
        let error = TWO_TO_MINUS_40 * condition;
        let lengths = [norm(&start), norm(&end)];
        let most = lengths[0].max(lengths[1]);
        let bisector = [0, 1, 2, 3].map(|i: usize| start[i] / lengths[0] + end[i] / lengths[1]);
        let along = dot(&start, &bisector).min(dot(&end, &bisector)) / norm(&bisector);
        let least = along - error * most;
        // Also if it is not a number.
        if least.is_nan() || least <= 0.0 {
            return None;
        }
        let change = [0, 1, 2, 3].map(|i: usize| part.length() * (self.0[1][i] - self.0[0][i]));
        let size = norm(&change);
        let [of_start, of_end] = [&start, &end].map(|q| dot(q, &change));
        let ratio = of_start / (lengths[0] * lengths[0]);
        let across = [0, 1, 2, 3].map(|i: usize| change[i] - ratio * start[i]);
        let area = lengths[0] * (norm(&across) + error * size);
        let inward = of_start.abs().max(of_end.abs()) + error * size * most;
        let square = least * least;
        let speed = 2.0 * area / square;
        let acceleration = 4.0 * area * inward / (square * square);
        Some([speed, acceleration].map(|x| 1.001 * x + f64::MIN_POSITIVE))
    }
}

const TWO_TO_MINUS_40: f64 = f64::from_bits((1023 - 40) << 52);
const TWO_TO_MINUS_45: f64 = f64::from_bits((1023 - 45) << 52);

/// Returns true if κ is below 2²⁰. It is not if it is not a number.
fn is_well_conditioned(condition: f64) -> bool {
    condition < 1_048_576.0
}

fn dot(a: &Quaternion, b: &Quaternion) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}

fn norm(q: &Quaternion) -> f64 {
    dot(q, q).sqrt()
}

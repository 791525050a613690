//! The boxes of the path of a vertex.

use exact_ccd::Point;

use crate::broad_phase::Aabb;

/// A place near (1 − t) x₀ + t x₁, between x₀ and x₁.
#[inline(always)]
pub(super) fn between(time: f64, x0: Point, x1: Point) -> Point {
    core::array::from_fn(|axis| {
        let (a, b) = (x0[axis], x1[axis]);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        ((1.0 - time) * a + time * b).clamp(lower, upper)
    })
}

/// The boxes of a vertex at t = 0 and at `time`, between which a box moves.
///
/// (1 − t) x₀ + t x₁ is computed with at most three roundings of each summand, and with products
/// that may underflow; no value between x₀ and x₁ overflows. Rounded in any direction, each by at most ε, it
/// is off by at most 3 ε (1 + 2 ε) s for s = |x₀| + |x₁|; clamping brings it no farther from a place
/// between x₀ and x₁. The bound e is at least 8 ε s (1 − 2 ε), after two sums. The side, `near` ± e, is
/// rounded once more, by at most ε (|near| + e) ≤ ε s (1 + 9 ε), as |near| ≤ s. So 8 ε s covers 4 ε s and
/// all terms with ε². Where subnormal numbers are flushed to zero, each of the six operands and results is
/// off by less than 2⁻¹⁰²².
///
/// The box at t = 0 is as much larger than the point. So at all times, the place on the path is more than
/// 3 ε s inside of the box: of the 8 ε s, at most 3 ε s are for the place at `time`, and one for the side.
/// Hence a straight motion from x₀ to a place that is at most 3 ε s off the path, at `time` or before, is
/// in the box too.
#[inline(always)]
pub(super) fn until(time: f64, x0: Point, x1: Point) -> [Aabb; 2] {
    let (mut start, mut end) = (Aabb::EMPTY, Aabb::EMPTY);
    let place = between(time, x0, x1);
    for axis in 0..3 {
        let (a, b, near) = (x0[axis], x1[axis], place[axis]);
        let error = 8.0 * f64::EPSILON * a.abs() + 8.0 * f64::EPSILON * b.abs() + 8.0 * f64::MIN_POSITIVE;
        start.lower[axis] = a - error;
        start.upper[axis] = a + error;
        end.lower[axis] = near - error;
        end.upper[axis] = near + error;
    }
    [start, end]
}

#[cfg(test)]
mod tests {
    use exact_ccd::Point;
    use fastrand::Rng;

    use super::until;
    use crate::mesh::TriangleMesh;
    use crate::steps::Step;

    /// Points of any size. Some move by a few units in the last place, others far.
    fn points(rng: &mut Rng) -> Vec<[Point; 2]> {
        let coordinates = |rng: &mut Rng| {
            let size = 10_f64.powi(rng.i32(-12..1));
            let scale = [-1030.0, -20.0, 0.0, 500.0].map(f64::exp2)[rng.usize(..4)];
            let start = [0, 1, 2].map(|_| 2.0 * rng.f64() - 1.0);
            let end = start.map(|x| x + size * (2.0 * rng.f64() - 1.0));
            [start, end].map(|point| point.map(|x| scale * x))
        };
        (0..64).map(|_| coordinates(rng)).collect()
    }

    /// The sides at both ends leave room for roundings in any direction, twice as large as those to nearest.
    #[test]
    fn sides_are_off_the_ends_by_eight_roundings_of_both() {
        let mut rng = Rng::with_seed(0);
        for _ in 0..1000 {
            let size = |rng: &mut Rng| f64::exp2(rng.f64() * 100.0 - 50.0) * (2.0 * rng.f64() - 1.0);
            let [x0, x1] = [(); 2].map(|()| [0, 1, 2].map(|_| size(&mut rng)));
            let [start, end] = until(1.0, x0, x1);
            for axis in 0..3 {
                let room = 8.0 * f64::EPSILON * (x0[axis].abs() + x1[axis].abs());
                for (place, x) in [(start, x0[axis]), (end, x1[axis])] {
                    for side in [x - place.lower[axis], place.upper[axis] - x] {
                        // A side is rounded to nearest.
                        let off = (side - room).abs();
                        assert!(off <= f64::EPSILON * (x.abs() + room), "{x0:?} {x1:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn boxes_contain_motions_to_rounded_positions_before_their_time() {
        let mut rng = Rng::with_seed(0);
        let mesh = TriangleMesh::new(64, Vec::new()).expect("there are no faces");
        for _ in 0..1000 {
            let (x0, x1): (Vec<_>, Vec<_>) = points(&mut rng).into_iter().map(|[a, b]| (a, b)).unzip();
            let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            let time = rng.f64();
            let size = time * [1.0, rng.f64(), 1e-9][rng.usize(..3)];
            let along = |(a, b): (&Point, &Point)| [0, 1, 2].map(|k: usize| a[k] + size * (b[k] - a[k]));
            let advanced = x0.iter().zip(&x1).map(along).collect();
            for ends in [step.at(size), advanced] {
                for (vertex, end) in ends.into_iter().enumerate() {
                    let moving = until(time, x0[vertex], x1[vertex]);
                    let part = size / time;
                    for axis in 0..3 {
                        let at = |[start, end]: [f64; 2]| start + part * (end - start);
                        let lower = at(moving.each_ref().map(|place| place.lower[axis]));
                        let upper = at(moving.each_ref().map(|place| place.upper[axis]));
                        let x = end[axis];
                        assert!(lower < x && x < upper, "{x0:?} {x1:?} {time} {size}");
                    }
                }
            }
        }
    }

    /// Each of six operands and results may be off by the least normal number.
    #[test]
    fn sides_at_zero_have_room_for_what_is_flushed() {
        for time in [0.0, 0.5, 1.0] {
            for place in until(time, [0.0; 3], [0.0; 3]) {
                let mut sides = place.lower.map(|x| -x).into_iter().chain(place.upper);
                assert!(sides.all(|side| side >= 6.0 * f64::MIN_POSITIVE));
            }
        }
    }
}

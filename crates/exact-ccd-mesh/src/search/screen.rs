//! The screen: pairs that certainly stay apart until a time, on the path and beside it, go no further.

use exact_ccd::batch::Trajectories;
use exact_ccd::{Separation, Separations, Thickness};

use super::chunks::for_each_chunk;
use crate::broad_phase::sum_above;
use crate::mesh::TriangleMesh;
use crate::pairs::{CanCollide, MinDistance, PairKind};
use crate::steps::Step;

/// A screen between the broad phase and the narrow phase. A pair that it holds back stays beyond its minimum
/// distance in the step until a time T, and so it does in each motion from the start of the step, straight to
/// the positions of [`Step::at`] or [`advance`](crate::advance) at a time until T.
///
/// Let M be the largest absolute value of a coordinate. The screen examines the straight motion q to the
/// positions of [`Step::at`] at T. Each coordinate of a vertex in q is off the path by at most 3 ε M, and in
/// a straight motion r to one of the other positions by at most 3 ε (|x₀| + |x₁|) ≤ 6 ε M; both bounds are
/// twice as large in another direction of rounding than to nearest. A point of a primitive is a mean of
/// vertices: at the same time of the step, the point in r is off the point in q by at most 18 ε M along each
/// axis; so the vector between two points is off by at most √3 · 36 ε M < 63 ε M. A product or a result that
/// underflows, or is flushed to zero, adds less than 2⁻¹⁰²² each. If two primitives stay beyond the minimum
/// distance and 64 ε M in q, they stay beyond the minimum distance in r. With thicknesses, the margin counts
/// twice, and the sum is rounded up to a multiple of at most 4 ε M, or exceeds 4 M, which is more than any
/// distance. The path itself is one of the motions r that are not rounded.
#[derive(Clone, Debug, Default)]
pub(super) struct Screen {
    trajectories: Trajectories,
    /// The minimum distance and the margin; none, if their sum is too large.
    thickened: Option<MinDistance>,
}

impl Screen {
    /// Takes a step until a time, and the distance at which primitives touch in it.
    pub(super) fn place(&mut self, step: &Step<'_>, time: f64, min_distance: &MinDistance) {
        let [x0, _] = step.positions();
        self.trajectories
            .set(x0, &step.at(time))
            .expect("a step has as many positions at both ends, and all are finite");
        let margin = 64.0 * f64::EPSILON * step.largest_coordinate() + 64.0 * f64::MIN_POSITIVE;
        self.thickened = thickened(min_distance.separations(), margin);
    }

    /// The pairs that may come within their minimum distance, apart from those that cannot collide.
    pub(super) fn passing<K: PairKind>(
        &self,
        mesh: &TriangleMesh,
        can_collide: &CanCollide,
        pairs: &[[u32; 2]],
    ) -> Vec<[u32; 2]> {
        let can_collide = |vertices: &K::Vertices| can_collide.allows_pair::<K>(vertices);
        let mut passing = Vec::new();
        for_each_chunk::<K>(mesh, pairs, can_collide, |ids, queries| {
            let Some(thickened) = &self.thickened else {
                passing.extend_from_slice(ids);
                return;
            };
            self.trajectories
                .may_collide::<K>(queries, thickened.separations(), |index| passing.push(ids[index]))
                .expect("a mesh has the vertices of its primitives, and each has a thickness");
        });
        passing
    }
}

/// Separations that are larger by a margin, unless one is too large.
fn thickened(separations: Separations<'_>, margin: f64) -> Option<MinDistance> {
    match separations {
        Separations::Uniform(d) => {
            let d = Separation::new(sum_above(d.get(), margin)).ok()?;
            Some(MinDistance::uniform(d))
        }
        Separations::Thickness(thickness) => {
            let vertices = 0..thickness.vertex_count() as u32;
            let thicker = |vertex| sum_above(thickness.of(&[vertex]).get(), margin);
            let values: Vec<f64> = vertices.map(thicker).collect();
            Thickness::new(&values).ok().map(MinDistance::thickness)
        }
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, Options, Point, Separation, VertexFace, VertexVertex};
    use fastrand::Rng;

    use super::Screen;
    use crate::line_search::advance;
    use crate::mesh::TriangleMesh;
    use crate::pairs::{CanCollide, MinDistance, PairKind};
    use crate::steps::Step;

    /// Points whose distances, and displacements, are a few units in the last place; and the displacements.
    /// The coordinates are one to two scales.
    fn near(rng: &mut Rng, scale: f64) -> [Vec<Point>; 2] {
        let unit = scale * f64::EPSILON * [1.0, 16.0, 256.0][rng.usize(..3)];
        let corner = [0, 1, 2].map(|_| scale * (1.0 + rng.f64()));
        let x0: Vec<Point> = (0..4)
            .map(|_| {
                let size = [unit, unit, 0.1 * scale][rng.usize(..3)];
                corner.map(|x| x + size * (4.0 * rng.f64() - 2.0))
            })
            .collect();
        let direction = x0
            .iter()
            .map(|_| [0, 1, 2].map(|_| unit * (4.0 * rng.f64() - 2.0)))
            .collect();
        [x0, direction]
    }

    /// Counts the pairs that are held back.
    fn held_back<K: PairKind>(mesh: &TriangleMesh, ids: [u32; 2], scale: f64) -> usize {
        let mut rng = Rng::with_seed(7);
        let mut screen = Screen::default();
        let mut count = 0;
        for _ in 0..10_000 {
            let [x0, direction] = near(&mut rng, scale);
            let x1 = advance(&x0, &direction, 1.0);
            let step = Step::new(mesh, &x0, &x1).expect("all positions are finite");
            let d = scale * [0.0, 4.0 * f64::EPSILON, 0.01][rng.usize(..3)];
            let d = Separation::new(d).expect("not negative");
            let until = [1.0, rng.f64()][rng.usize(..2)];
            screen.place(&step, until, &MinDistance::from(d));
            if !screen.passing::<K>(mesh, &CanCollide::all(), &[ids]).is_empty() {
                continue;
            }
            count += 1;
            let path = step.query::<K>(ids).expect("the mesh has the pair");
            assert!(
                !path.collides(Options::within(d).until(until)),
                "{x0:?} {x1:?} {d} {until}"
            );
            let size = [until, rng.f64() * until][rng.usize(..2)];
            for end in [step.at(size), advance(&x0, &direction, size)] {
                let part = Step::new(mesh, &x0, &end).expect("all positions are finite");
                let part = part.query::<K>(ids).expect("the mesh has the pair");
                assert!(!part.collides(d), "{x0:?} {x1:?} {d} {until} {size}");
            }
        }
        count
    }

    #[test]
    fn pairs_that_are_held_back_stay_apart_in_rounded_motions() {
        let face = TriangleMesh::new(4, vec![[1, 2, 3]]).expect("the indices are in range");
        let edges = TriangleMesh::with_edges(4, Vec::new(), &[[0, 1], [2, 3]]).expect("so are these");
        let points = TriangleMesh::new(4, Vec::new()).expect("there are no faces");
        for scale in [-1000.0, -40.0, 0.0, 40.0].map(f64::exp2) {
            for count in [
                held_back::<VertexFace>(&face, [0, 0], scale),
                held_back::<EdgeEdge>(&edges, [0, 1], scale),
                held_back::<VertexVertex>(&points, [0, 1], scale),
            ] {
                assert!((50..9_500).contains(&count), "{count} at {scale}");
            }
        }
    }

    #[test]
    fn a_distance_without_room_for_a_margin_holds_no_pair_back() {
        let face = TriangleMesh::new(4, vec![[1, 2, 3]]).expect("the indices are in range");
        let x = [[0.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let step = Step::new(&face, &x, &x).expect("all positions are finite");
        let d = Separation::new(f64::MAX).expect("not negative");
        let mut screen = Screen::default();
        screen.place(&step, 1.0, &MinDistance::from(d));
        assert_eq!(
            screen.passing::<VertexFace>(&face, &CanCollide::all(), &[[0, 0]]),
            [[0, 0]]
        );
    }
}

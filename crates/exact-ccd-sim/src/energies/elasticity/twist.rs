//! Twist of rods between edges that are held.

use exact_ccd_mesh::Point;
use nalgebra::{DVector, Matrix3, SMatrix, SVector, Vector3};

use super::chain::Chain;
use super::rod_bend::ends;
use crate::energies::term::{Block, Energy, Projection, write_blocks};

/// The energy ½ (G J / L) φ² of the twist φ of a chain in one time step. The first and the last edge are
/// held, and their cross sections with them. The twist is uniform along the chain: the cross sections of an
/// isotropic rod turn to the least energy at once, because waves of twist are much faster than waves of
/// bending (M. Bergou, M. Wardetzky, S. Robinson, B. Audoly, E. Grinspun, *Discrete elastic rods*, 2008,
/// section 5).
///
/// φ is the angle between the frames of both ends, after one frame is transported along the chain without
/// twist. From the start of the time step on, it changes by the holonomy of the quadrilaterals on the sphere
/// of directions whose corners are two successive edges then and now. The arcs between them, from then to
/// now, cancel in the sum over the vertices, except for the first and the last edge, which are held. So the
/// derivatives of φ are as in M. Bergou, B. Audoly, E. Vouga, M. Wardetzky, E. Grinspun, *Discrete viscous
/// threads*, 2010, section 4: ∂φ/∂e = κb / (2 |e|) for both edges of each vertex, with its curvature
/// binormal κb = 2 s × t / (1 + s · t) between the directions s and t.
#[derive(Debug)]
pub(crate) struct Twist {
    chain: Chain,
    /// The directions of the edges at the start of the time step.
    before: Vec<Vector3<f64>>,
    /// φ for these directions, after the ends have turned.
    angle: f64,
}

impl Twist {
    /// The twist of a chain, from the positions at the start of the time step and φ there, after the ends
    /// have turned.
    pub(crate) fn new(chain: &Chain, points: &[Point], angle: f64) -> Self {
        Self {
            before: directions(&chain.edges(points)),
            chain: chain.clone(),
            angle,
        }
    }

    /// φ at other positions of this time step.
    pub(crate) fn angle(&self, points: &[Point]) -> f64 {
        let now = directions(&self.chain.edges(points));
        let pairs = self.before.windows(2).zip(now.windows(2));
        let turns = pairs.map(|(before, now)| holonomy([before[0], before[1]], [now[0], now[1]]));
        self.angle + turns.sum::<f64>()
    }

    /// The gradient of φ by the vertices of the chain.
    fn slope(&self, points: &[Point]) -> DVector<f64> {
        let edges = self.chain.edges(points);
        let mut slope = DVector::zeros(3 * self.chain.vertices().len());
        for (place, pair) in edges.windows(2).enumerate() {
            let by_edges = Corner::new([pair[0], pair[1]]).slope();
            let mut rows = slope.fixed_rows_mut::<9>(3 * place);
            rows += ends().tr_mul(&by_edges);
        }
        slope
    }
}

impl Energy for Twist {
    fn vertices(&self) -> &[u32] {
        self.chain.vertices()
    }

    fn value(&self, points: &[Point]) -> f64 {
        0.5 * self.chain.stiffness() * self.angle(points).powi(2)
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let forces = self.slope(points) * (self.chain.stiffness() * self.angle(points));
        gradient.copy_from_slice(forces.as_slice());
    }

    /// The first part is semi-definite. The second one is projected at each vertex.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let slope = self.slope(points);
        let moment = self.chain.stiffness() * self.angle(points);
        let mut sum = &slope * slope.transpose() * self.chain.stiffness();
        let edges = self.chain.edges(points);
        let ends = ends();
        for (place, pair) in edges.windows(2).enumerate() {
            let by_edges = Corner::new([pair[0], pair[1]]).curvature() * moment;
            let mut block = sum.fixed_view_mut::<9, 9>(3 * place, 3 * place);
            block += ends.tr_mul(&(projection.of(by_edges) * ends));
        }
        write_blocks(&sum, self.chain.vertices().len(), hessian);
    }
}

/// Two successive edges.
struct Corner {
    directions: [Vector3<f64>; 2],
    lengths: [f64; 2],
    /// 1 + s · t for the directions s and t.
    chi: f64,
    binormal: Vector3<f64>,
}

impl Corner {
    fn new(edges: [Vector3<f64>; 2]) -> Self {
        let directions = edges.map(|edge| edge.normalize());
        let [s, t] = directions;
        let chi = 1.0 + s.dot(&t);
        Self {
            directions,
            lengths: edges.map(|edge| edge.norm()),
            chi,
            binormal: s.cross(&t) * (2.0 / chi),
        }
    }

    /// The gradient of φ by both edges.
    fn slope(&self) -> SVector<f64, 6> {
        let mut slope = SVector::<f64, 6>::zeros();
        for (edge, length) in self.lengths.iter().enumerate() {
            let by_edge = self.binormal * (0.5 / length);
            slope.fixed_rows_mut::<3>(3 * edge).copy_from(&by_edge);
        }
        slope
    }

    /// The Hessian of φ by both edges.
    fn curvature(&self) -> SMatrix<f64, 6, 6> {
        let [s, t] = self.directions;
        let [a, b] = self.lengths;
        let mean = (s + t) / self.chi;
        let own = |direction: Vector3<f64>, length: f64| {
            let mixed = self.binormal * (direction + mean).transpose();
            (mixed + mixed.transpose()) * (-0.25 / (length * length))
        };
        let crossed: Matrix3<f64> =
            (s.cross_matrix() * (2.0 / self.chi) - self.binormal * mean.transpose()) * (0.5 / (a * b));
        let mut curvature = SMatrix::<f64, 6, 6>::zeros();
        curvature.fixed_view_mut::<3, 3>(0, 0).copy_from(&own(s, a));
        curvature.fixed_view_mut::<3, 3>(3, 3).copy_from(&own(t, b));
        curvature.fixed_view_mut::<3, 3>(0, 3).copy_from(&crossed);
        curvature
            .fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&crossed.transpose());
        curvature
    }
}

/// The angle about the direction `now[1]` from a vector that is transported from `before[0]` over `now[0]`,
/// to one that is transported over `before[1]`.
fn holonomy(before: [Vector3<f64>; 2], now: [Vector3<f64>; 2]) -> f64 {
    let [s, t] = before;
    let across = s.cross(&Vector3::ith(s.iamin(), 1.0));
    let over_now = transported(&transported(&across, &s, &now[0]), &now[0], &now[1]);
    let over_before = transported(&transported(&across, &s, &t), &t, &now[1]);
    angle_about(&now[1], &over_now, &over_before)
}

/// The angle about an axis from one vector to another, counterclockwise for a viewer at whom the axis points,
/// from −π to π.
pub(crate) fn angle_about(axis: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    from.cross(to).dot(axis).atan2(from.dot(to))
}

/// A vector across the direction `from`, turned with it to the direction `to` by the least rotation: for the
/// vector v with v · s = 0, it is v − (v · t) (s + t) / (1 + s · t). Between opposite directions, all half
/// turns are as small: that about v is taken.
pub(crate) fn transported(vector: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> Vector3<f64> {
    let chi = 1.0 + from.dot(to);
    if chi < OPPOSITE {
        return *vector;
    }
    vector - (from + to) * (vector.dot(to) / chi)
}

/// Directions s and t count as opposite if 1 + s · t is below this.
const OPPOSITE: f64 = 1e-12;

fn directions(edges: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    edges.iter().map(Vector3::normalize).collect()
}

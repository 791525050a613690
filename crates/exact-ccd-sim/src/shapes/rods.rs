//! Generated rods and particles.

use core::f64::consts::PI;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::body::{Body, BodyKind, ParticleProperties, RodProperties};

/// Rope-like: 1000 kg/m³, E = 1 MPa, a radius of 1 cm.
pub const ROPE: RodProperties = RodProperties {
    density: 1000.0,
    young: 1e6,
    radius: 0.01,
    shear: None,
};

/// Bead-like: 1000 kg/m³, a radius of 1 cm.
pub const BEAD: ParticleProperties = ParticleProperties {
    density: 1000.0,
    radius: 0.01,
};

/// A straight rod of [`ROPE`] along x, with one end at the origin. It has `edges` edges, at least one.
#[must_use]
pub fn line(edges: u16, length: f64) -> Body {
    rope(edges, &[Vector3::zeros(), Vector3::x() * length])
}

/// A rod of [`ROPE`] with a loose overhand knot, about as high and wide as a fifth of its length. It has
/// `edges` edges of nearly the same length, at least one. Both ends hang down along −y.
///
/// The knot is the trefoil (sin t + 2 sin 2t, cos t − 2 cos 2t, −0.8 sin 3t), which is cut open at the bottom
/// of a lobe and continued by straight ends.
#[must_use]
pub fn knot(edges: u16, length: f64) -> Body {
    /// The number of points of the trefoil from which the rod is interpolated.
    const POINTS: u16 = 1024;
    /// The length of a straight end.
    const END: f64 = 4.0;
    // At both sides of the cut, which are at t = π ± this angle, the curve is vertical.
    let cut = ((1.0 + 129.0_f64.sqrt()) / 16.0).acos();
    let trefoil = |place: u16| {
        let t = PI + cut + 2.0 * (PI - cut) * f64::from(place) / f64::from(POINTS);
        Vector3::new(
            t.sin() + 2.0 * (2.0 * t).sin(),
            t.cos() - 2.0 * (2.0 * t).cos(),
            -0.8 * (3.0 * t).sin(),
        )
    };
    let below = |point: Vector3<f64>| point - Vector3::y() * END;
    let mut curve = vec![below(trefoil(0))];
    curve.extend((0..=POINTS).map(trefoil));
    curve.push(below(trefoil(POINTS)));
    let whole: f64 = curve.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum();
    let curve: Vec<Vector3<f64>> = curve.iter().map(|point| point * (length / whole)).collect();
    rope(edges, &curve)
}

/// A lattice of particles of [`BEAD`] with a corner at the origin. It has `counts` particles along the axes,
/// at least one each, which fill the sides of lengths `size`.
#[must_use]
pub fn particles(counts: [u8; 3], size: Point) -> Body {
    let counts = counts.map(|count| count.max(1));
    let at = |axis: usize, place: u8| {
        let last = counts[axis] - 1;
        size[axis] * f64::from(place) / f64::from(last.max(1))
    };
    let mut points = Vec::new();
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            points.extend((0..counts[0]).map(|i| [at(0, i), at(1, j), at(2, k)]));
        }
    }
    Body::new(points, BodyKind::Particles { material: BEAD })
}

/// The rod along a curve, whose vertices are at equal distances along the curve.
fn rope(edges: u16, curve: &[Vector3<f64>]) -> Body {
    let count = edges.max(1);
    let mut ends = vec![0.0];
    for pair in curve.windows(2) {
        ends.push(ends[ends.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let length = ends[ends.len() - 1];
    let at = |place: u16| {
        let along = length * f64::from(place) / f64::from(count);
        let next = ends.partition_point(|&end| end < along).clamp(1, curve.len() - 1);
        let share = (along - ends[next - 1]) / (ends[next] - ends[next - 1]);
        (curve[next - 1] + (curve[next] - curve[next - 1]) * share).into()
    };
    let points = (0..=count).map(at).collect();
    let edges = (0..u32::from(count)).map(|edge| [edge, edge + 1]).collect();
    let material = ROPE;
    Body::new(points, BodyKind::Rod { edges, material })
}

//! The size of a system, which does not depend on the axes.

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;

use super::System;

impl System {
    /// The greatest distance of two vertices of bodies with mass at the start, in m: the unit of relative
    /// lengths. It does not depend on the axes. For a box it is the diagonal, and for bodies in a box along
    /// the axes at most its diagonal, the unit of *Incremental Potential Contact*. If it is 0, or no body
    /// has mass, the unit is [`System::extent`].
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The greatest distance of two vertices at the start, obstacles included, in m. 1 m for a single point.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// The system with its size and its extent. The nodes of affine bodies do not count: their places depend
    /// on the axes.
    pub(super) fn measured(self, is_obstacle: &[bool]) -> Self {
        let vertices = self.mesh_vertices();
        let of = |is_counted: &dyn Fn(u32) -> bool| {
            let counted = vertices.iter().filter(|&&vertex| is_counted(vertex));
            diameter(counted.map(|&vertex| self.start[vertex as usize]))
        };
        let positive = |length: f64, other: f64| if length > 0.0 { length } else { other };
        let extent = positive(of(&|_| true), 1.0);
        let size = positive(of(&|vertex| !is_obstacle[vertex as usize]), extent);
        Self { size, extent, ..self }
    }
}

/// The greatest distance of two points, which does not depend on the axes. 0 without points.
///
/// Points are compared in the order of their distances from the center of their box, the farthest first: two
/// points are not farther apart than the sum of both distances, so that few pairs are left.
pub(super) fn diameter(points: impl Iterator<Item = Point>) -> f64 {
    let points: Vec<Vector3<f64>> = points.map(Vector3::from).collect();
    let bounds: Aabb = points.iter().map(|&point| point.into()).collect();
    let center = Vector3::from(bounds.center());
    let mut points: Vec<(f64, Vector3<f64>)> = points
        .into_iter()
        .map(|point| ((point - center).norm(), point))
        .collect();
    points.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut diameter = 0.0_f64;
    for (place, (radius, point)) in points.iter().enumerate() {
        for (other_radius, other) in &points[place + 1..] {
            if radius + other_radius <= diameter {
                break;
            }
            diameter = diameter.max((point - other).norm());
        }
    }
    diameter
}

//! Small displacements by which primitives that touch exactly come apart.

use exact_ccd_mesh::vector::{cross, minus, unit};
use exact_ccd_mesh::{Point, TriangleMesh};

use crate::system::Unknowns;

/// Displacements of length 1 to 2 against the normals, of another length for each component: closed surfaces
/// that touch from outside come apart, and so do surfaces that coincide, whatever their orientations. A small
/// part is another direction for each vertex, for surfaces that touch themselves.
pub(crate) fn offsets(mesh: &TriangleMesh, unknowns: &Unknowns, x: &[Point]) -> Vec<Point> {
    let mut normals = vec![[0.0; 3]; x.len()];
    for &[a, b, c] in mesh.faces() {
        let at = |vertex: u32| x[vertex as usize];
        let Some(normal) = unit(cross(minus(at(b), at(a)), minus(at(c), at(a)))) else {
            continue;
        };
        for vertex in [a, b, c] {
            let sum = &mut normals[vertex as usize];
            *sum = [0, 1, 2].map(|axis: usize| sum[axis] + normal[axis]);
        }
    }
    let components = mesh.components();
    let offset = |(vertex, normal): (usize, Point)| {
        if unknowns.is_pinned(vertex) {
            return [0.0; 3];
        }
        // Multiples of the golden section are spread evenly over [0, 1].
        let length = 1.0 + (f64::from(components[vertex]) * 0.618_033_988_749_894_9).fract();
        let other = direction(vertex);
        let normal = unit(normal).unwrap_or(other);
        [0, 1, 2].map(|axis: usize| 0.1 * other[axis] - length * normal[axis])
    };
    normals.into_iter().enumerate().map(offset).collect()
}

/// A unit vector for each index, spread evenly over the sphere: multiples of the powers of the plastic number
/// (Roberts 2018) as height and angle.
fn direction(index: usize) -> Point {
    let index = index as f64;
    let [height, turn] =
        [0.754_877_666_246_692_8, 0.569_840_290_998_053_3].map(|step| (index * step).fract());
    let z = 2.0 * height - 1.0;
    let (sine, cosine) = (turn * std::f64::consts::TAU).sin_cos();
    let radius = (1.0 - z * z).sqrt();
    [radius * cosine, radius * sine, z]
}

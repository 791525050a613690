//! Small deflections of plates with the bending energy of hinges alone.

use nalgebra::{DMatrix, DVector, Vector3};

use super::mesh::Mesh;
use crate::energies::elasticity::Hinge;
use crate::energies::term::{Energy, Projection};

/// The deflections of the vertices for a flexural rigidity of 1 and a load by area of 1, with some of them
/// clamped.
pub(super) fn deflections(mesh: &Mesh, is_clamped: impl Fn(u32) -> bool) -> Vec<f64> {
    let count = mesh.points.len();
    let at = |vertex: u32| Vector3::from(mesh.points[vertex as usize]);
    let mut stiffness = DMatrix::zeros(count, count);
    for corners in interior(&mesh.faces) {
        let hinge = Hinge::new(corners, &mesh.points, 1.0).unwrap();
        let hessian = hinge.hessian(&mesh.points, Projection::None);
        for (row, &a) in corners.iter().enumerate() {
            for (column, &b) in corners.iter().enumerate() {
                // The plate is in the plane y = 0.
                stiffness[(a as usize, b as usize)] += hessian[(3 * row + 1, 3 * column + 1)];
            }
        }
    }
    let mut load = DVector::zeros(count);
    for face in &mesh.faces {
        let [a, b, c] = face.map(at);
        let share = (b - a).cross(&(c - a)).norm() / 6.0;
        face.iter().for_each(|&corner| load[corner as usize] += share);
    }
    for clamped in (0..count).filter(|&vertex| is_clamped(vertex as u32)) {
        stiffness.row_mut(clamped).fill(0.0);
        stiffness.column_mut(clamped).fill(0.0);
        stiffness[(clamped, clamped)] = 1.0;
        load[clamped] = 0.0;
    }
    let solved = stiffness.cholesky().unwrap().solve(&load);
    solved.iter().copied().collect()
}

/// The edges between two faces, each with the opposite corners of both.
fn interior(faces: &[[u32; 3]]) -> Vec<[u32; 4]> {
    let mut sides: Vec<([u32; 2], [u32; 3])> = Vec::new();
    for &[a, b, c] in faces {
        for [p, q, opposite] in [[a, b, c], [b, c, a], [c, a, b]] {
            sides.push(([p.min(q), p.max(q)], [p, q, opposite]));
        }
    }
    sides.sort_unstable();
    let pairs = sides.chunk_by(|a, b| a.0 == b.0).filter(|chunk| chunk.len() == 2);
    pairs
        .map(|chunk| [chunk[0].1[0], chunk[0].1[1], chunk[0].1[2], chunk[1].1[2]])
        .collect()
}

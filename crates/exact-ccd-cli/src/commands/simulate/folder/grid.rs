//! The cells of a system for ParaView: tetrahedra of solids, triangles of shells and obstacles, lines of
//! rods, and particles.

use std::io;

use exact_ccd_files::{UnstructuredGrid, write_vtu};
use exact_ccd_mesh::Point;
use exact_ccd_sim::{State, System};

/// The cells of a system. Their vertices are numbered without the nodes of affine bodies.
pub(crate) struct Grid {
    /// The vertices of all meshes, by their numbers in the system.
    vertices: Vec<u32>,
    tetrahedra: Vec<[u32; 4]>,
    /// The triangles of shells and obstacles.
    triangles: Vec<[u32; 3]>,
    /// The edges of rods.
    lines: Vec<[u32; 2]>,
    particles: Vec<u32>,
    /// The body of each vertex.
    bodies: Vec<u32>,
}

impl Grid {
    pub(crate) fn new(system: &System) -> Self {
        let vertices = system.mesh_vertices();
        let place = |vertex: u32| vertices.partition_point(|&other| other < vertex) as u32;
        let mut is_solid = vec![false; system.start().len()];
        for &corner in system.tetrahedra().as_flattened() {
            is_solid[corner as usize] = true;
        }
        // All corners of a face belong to one body.
        let faces = system.surface().faces().iter();
        let triangles = faces.filter(|face| !is_solid[face[0] as usize]);
        Self {
            tetrahedra: system
                .tetrahedra()
                .iter()
                .map(|corners| corners.map(place))
                .collect(),
            triangles: triangles.map(|corners| corners.map(place)).collect(),
            lines: system
                .surface()
                .loose_edges()
                .iter()
                .map(|ends| ends.map(place))
                .collect(),
            particles: system.particles().iter().copied().map(place).collect(),
            bodies: vertices
                .iter()
                .map(|&vertex| system.body_of(vertex) as u32)
                .collect(),
            vertices,
        }
    }

    /// Writes the cells at the positions of a state, with the velocities and the bodies of their vertices.
    pub(crate) fn write(&self, state: &State, writer: impl io::Write) -> io::Result<()> {
        let kept = |points: &[Point]| -> Vec<Point> {
            self.vertices
                .iter()
                .map(|&vertex| points[vertex as usize])
                .collect()
        };
        let grid = UnstructuredGrid {
            positions: &kept(&state.positions),
            tetrahedra: &self.tetrahedra,
            triangles: &self.triangles,
            lines: &self.lines,
            points: &self.particles,
            ids: None,
            velocities: Some(&kept(&state.velocities)),
            bodies: Some(&self.bodies),
        };
        write_vtu(writer, grid)
    }
}

//! The cells of a system for ParaView: tetrahedra of solids, triangles of shells and obstacles, lines of
//! rods, and particles.

use std::io;

use exact_ccd_files::{UnstructuredGrid, write_vtu};
use exact_ccd_sim::{State, System};

/// The cells of a system.
pub(super) struct Grid {
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
    pub(super) fn new(system: &System) -> Self {
        let tetrahedra = system.tetrahedra().to_vec();
        let mut is_solid = vec![false; system.start().len()];
        for &corner in tetrahedra.as_flattened() {
            is_solid[corner as usize] = true;
        }
        // All corners of a face belong to one body.
        let faces = system.surface().faces().iter();
        let triangles = faces
            .filter(|face| !is_solid[face[0] as usize])
            .copied()
            .collect();
        Self {
            tetrahedra,
            triangles,
            lines: system.surface().loose_edges().to_vec(),
            particles: system.particles().to_vec(),
            bodies: (0..system.start().len() as u32)
                .map(|vertex| system.body_of(vertex) as u32)
                .collect(),
        }
    }

    /// Writes the cells at the positions of a state, with the velocities and the bodies of their vertices.
    pub(super) fn write(&self, state: &State, writer: impl io::Write) -> io::Result<()> {
        let grid = UnstructuredGrid {
            positions: &state.positions,
            tetrahedra: &self.tetrahedra,
            triangles: &self.triangles,
            lines: &self.lines,
            points: &self.particles,
            ids: None,
            velocities: Some(&state.velocities),
            bodies: Some(&self.bodies),
        };
        write_vtu(writer, grid)
    }
}

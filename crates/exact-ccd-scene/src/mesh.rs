//! Meshes from files and from shapes.

use std::path::Path;

use exact_ccd_files::{Format, Group, MeshFile, Polygons, read_tet_mesh};
use exact_ccd_mesh::{Point, TetMesh};

use super::description::Shape;
use exact_ccd_sim::{Body, BodyKind, shapes};

/// A mesh with its faces and, if it has any, its loose edges and its tetrahedra.
#[derive(Default)]
pub struct Mesh {
    /// The positions of the vertices, in m.
    pub points: Vec<Point>,
    /// The corners of the faces, which are the surface of the tetrahedra if there are any.
    pub faces: Vec<[u32; 3]>,
    /// The ends of the edges of no face.
    pub edges: Vec<[u32; 2]>,
    /// The corners of the tetrahedra.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The groups of the file.
    pub groups: Vec<Group>,
    /// The facts about the file that could change an answer.
    pub notes: Vec<String>,
}

impl Mesh {
    /// Reads the mesh in a file.
    pub fn read(path: &Path) -> Result<Self, String> {
        if Format::of_path(path) == Some(Format::Msh) {
            let (mesh, groups) = read_tet_mesh(path).map_err(|error| error.to_string())?;
            return Ok(Self {
                points: mesh.positions().to_vec(),
                faces: mesh.surface().to_vec(),
                tetrahedra: mesh.tetrahedra().to_vec(),
                groups,
                ..Self::default()
            });
        }
        let file = MeshFile::read(path, Polygons::Triangulate);
        let MeshFile {
            frame, groups, notes, ..
        } = file.map_err(|error| error.to_string())?;
        let note = |note| format!("{}: {note}", path.display());
        Ok(Self {
            faces: frame.mesh.faces().to_vec(),
            edges: frame.mesh.loose_edges().to_vec(),
            points: frame.positions,
            notes: notes.iter().map(note).collect(),
            groups,
            ..Self::default()
        })
    }

    /// Generates the mesh of a shape.
    pub(super) fn generate(shape: Shape) -> Result<Self, String> {
        let product = |counts: &[u64]| counts.iter().product();
        let (count, what, lengths): (u64, _, &[f64]) = match &shape {
            Shape::Torus {
                segments,
                radius,
                tube,
            } => (product(&segments.map(u64::from)), "segments", &[*radius, *tube]),
            Shape::Box { cells, size } => (product(&cells.map(u64::from)), "cells", size),
            Shape::Grid { cells, size } => (product(&cells.map(u64::from)), "cells", size),
            Shape::Sphere { radius, .. } => (1, "cells", std::slice::from_ref(radius)),
            Shape::Line { edges, length } | Shape::Knot { edges, length } => {
                (u64::from(*edges), "edges", std::slice::from_ref(length))
            }
            Shape::Points { counts, size } => (product(&counts.map(u64::from)), "points", size),
        };
        if !(1..=shapes::MAX_CELLS).contains(&count) {
            let max = shapes::MAX_CELLS;
            return Err(format!("the shape has {count} {what}, expected 1 to {max}"));
        }
        // The sides of a lattice of points may have no length.
        let (least, expected) = match what {
            "points" => (0.0, "a finite number not below 0"),
            _ => (f64::from_bits(1), "a finite positive number"),
        };
        if let Some(length) = lengths
            .iter()
            .find(|length| !(least..=f64::MAX).contains(*length))
        {
            return Err(format!(
                "the shape has a length of {length} m, expected {expected}"
            ));
        }
        let Body { points, kind, .. } = match shape {
            Shape::Box { cells, size } => shapes::solid_box(cells, size),
            Shape::Grid { cells, size } => shapes::cloth(cells, size),
            Shape::Sphere { subdivisions, .. } if subdivisions > shapes::MAX_SUBDIVISIONS => {
                let max = shapes::MAX_SUBDIVISIONS;
                return Err(format!(
                    "the sphere has {subdivisions} subdivisions, expected at most {max}"
                ));
            }
            Shape::Sphere { subdivisions, radius } => shapes::sphere(subdivisions, radius),
            Shape::Torus {
                segments,
                radius,
                tube,
            } => {
                if segments.iter().any(|&count| count < 3) {
                    return Err(format!(
                        "the torus has {segments:?} segments, expected at least 3 each"
                    ));
                }
                if tube >= radius {
                    return Err(format!(
                        "the tube of the torus has a radius of {tube} m, expected less than the radius {radius} m"
                    ));
                }
                shapes::torus(segments, radius, tube)
            }
            Shape::Line { edges, length } => shapes::line(edges, length),
            Shape::Knot { edges, length } => shapes::knot(edges, length),
            Shape::Points { counts, size } => shapes::particles(counts, size),
        };
        let mut mesh = Self {
            points,
            ..Self::default()
        };
        match kind {
            BodyKind::Shell { faces, .. } | BodyKind::Affine { faces, .. } | BodyKind::Obstacle { faces } => {
                mesh.faces = faces;
            }
            BodyKind::Solid { tetrahedra, .. } => {
                let solid = TetMesh::new(mesh.points.clone(), tetrahedra);
                let solid = solid.map_err(|error| error.to_string())?;
                mesh.faces = solid.surface().to_vec();
                mesh.tetrahedra = solid.tetrahedra().to_vec();
            }
            BodyKind::Rod { edges, .. } => mesh.edges = edges,
            BodyKind::Particles { .. } => {}
        }
        Ok(mesh)
    }
}

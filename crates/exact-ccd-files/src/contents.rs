//! The contents of a mesh file in numbers.

use std::fmt;

use exact_ccd_mesh::Frame;
use serde::Serialize;

/// The contents of a mesh file in numbers. Its text is one line for the top of a report.
///
/// ```
/// use exact_ccd_files::{Format, MeshFile, Polygons};
///
/// let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\nf 1 2 3 4\n";
/// let file = MeshFile::parse(obj, Format::Obj, Polygons::Triangulate)?;
/// assert_eq!(
///     file.contents.to_string(),
///     "5 vertices, 5 edges, 2 faces, 1 point, 2 components; \
///      1 polygon triangulated as a fan from its lowest vertex"
/// );
/// # Ok::<(), exact_ccd_files::ParseError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Contents {
    /// All vertices of the frame.
    pub vertices: usize,
    /// All edges, of faces and loose ones.
    pub edges: usize,
    /// Triangles.
    pub faces: usize,
    /// Rods: edges of no face.
    pub loose_edges: usize,
    /// Points: vertices without an edge.
    pub loose_vertices: usize,
    /// Connected components: vertices that faces and edges connect, and every point.
    pub components: usize,
    /// Faces with more than three corners, which were triangulated.
    pub polygons: usize,
    /// Tetrahedra, hexahedra, wedges and pyramids. The frame has their surface.
    pub solids: usize,
}

impl Contents {
    /// The numbers of a frame.
    #[must_use]
    pub fn of(frame: &Frame) -> Self {
        let mesh = &frame.mesh;
        Self {
            vertices: mesh.vertex_count(),
            edges: mesh.edges().len(),
            faces: mesh.faces().len(),
            loose_edges: mesh.loose_edges().len(),
            loose_vertices: mesh.loose_vertices().count(),
            components: mesh.component_count(),
            polygons: 0,
            solids: 0,
        }
    }
}

impl fmt::Display for Contents {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, ", count(self.vertices, "vertex", "vertices"))?;
        write!(f, "{}, ", count(self.edges, "edge", "edges"))?;
        write!(f, "{}, ", count(self.faces, "face", "faces"))?;
        if self.loose_edges > 0 {
            write!(f, "{}, ", count(self.loose_edges, "loose edge", "loose edges"))?;
        }
        if self.loose_vertices > 0 {
            write!(f, "{}, ", count(self.loose_vertices, "point", "points"))?;
        }
        write!(f, "{}", count(self.components, "component", "components"))?;
        if self.solids > 0 {
            let cells = count(self.solids, "cell with volume", "cells with volume");
            write!(f, "; the surface of {cells}")?;
        }
        match self.polygons {
            0 => Ok(()),
            1 => f.write_str("; 1 polygon triangulated as a fan from its lowest vertex"),
            polygons => write!(
                f,
                "; {polygons} polygons triangulated, each as a fan from its lowest vertex"
            ),
        }
    }
}

fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

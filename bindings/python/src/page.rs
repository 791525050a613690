//! Pages that show motions and their contacts in a browser.

use std::mem;

use exact_ccd_mesh::{Aabb, Contact, Intersection, TriangleMesh};
use exact_ccd_view::Body;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error::refused;
use crate::mesh::Mesh;
use crate::positions::points;

/// A page under construction.
#[pyclass(module = "exact_ccd._native")]
pub(crate) struct Page(exact_ccd_view::Page);

impl Page {
    /// Adds intersections in the last frame.
    pub(crate) fn add_intersections(&mut self, found: &[Intersection]) -> PyResult<()> {
        let mut found = found.iter();
        found.try_for_each(|&intersection| self.0.add_intersection(intersection).map_err(refused))
    }

    /// Adds contacts of the step between the last two frames.
    pub(crate) fn add_contacts(&mut self, contacts: &[Contact]) -> PyResult<()> {
        let mut contacts = contacts.iter();
        contacts.try_for_each(|contact| self.0.add_contact(contact).map_err(refused))
    }
}

#[pymethods]
impl Page {
    /// A page without frames; the positions are in the middle of the picture. Bodies have a name, a first
    /// vertex, and an end; the ids in them are of each vertex and of each face, negative for none.
    #[new]
    #[pyo3(signature = (title, mesh, positions, bodies, ids))]
    fn new(
        title: String,
        mesh: &Mesh,
        positions: PyReadonlyArray2<'_, f64>,
        bodies: Vec<(String, u32, u32)>,
        ids: Option<(Vec<i64>, Vec<i64>)>,
    ) -> PyResult<Self> {
        let bounds: Aabb = points(&positions)?.iter().copied().collect();
        let mesh = TriangleMesh::clone(mesh.mesh());
        let bodies = bodies
            .into_iter()
            .map(|(name, start, end)| Body::new(name, "", start..end));
        let page = exact_ccd_view::Page::new(title, mesh, &bounds).with_bodies(bodies);
        let Some((vertices, faces)) = ids else {
            return Ok(Self(page));
        };
        let id = |id: i64| u32::try_from(id).ok();
        let vertices = vertices.into_iter().filter_map(id).collect();
        Ok(Self(page.with_ids(vertices, faces.into_iter().map(id).collect())))
    }

    /// Adds the next frame.
    fn add_frame(
        &mut self,
        py: Python<'_>,
        label: String,
        positions: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<()> {
        let positions = points(&positions)?;
        py.detach(|| self.0.add_frame(label, positions)).map_err(refused)
    }

    /// The file, with lines about the answer under its title. It ends the page.
    fn html<'py>(&mut self, py: Python<'py>, summary: Vec<String>) -> PyResult<Bound<'py, PyBytes>> {
        let empty = exact_ccd_view::Page::new("", TriangleMesh::default(), &[].into_iter().collect());
        let page = mem::replace(&mut self.0, empty);
        let mut file = Vec::new();
        py.detach(|| page.with_summary(summary).write(&mut file))?;
        Ok(PyBytes::new(py, &file))
    }
}

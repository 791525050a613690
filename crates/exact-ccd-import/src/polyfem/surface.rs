//! The faces of bodies by their ids.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::entry::Entry;
use super::region::Regions;
use crate::fault::Fault;

/// The faces of a body with their ids.
pub(super) struct Surface<'a> {
    pub(super) faces: &'a [[u32; 3]],
    ids: Vec<Option<i64>>,
}

impl<'a> Surface<'a> {
    /// The faces of a placed body with these points.
    pub(super) fn new(points: &[Point], faces: &'a [[u32; 3]], regions: Option<&Regions>) -> Self {
        let id = |face: &[u32; 3]| {
            let corners = face.map(|vertex| Vector3::from(points[vertex as usize]));
            regions?.id(&(corners.iter().sum::<Vector3<f64>>() / 3.0))
        };
        let ids = faces.iter().map(id).collect();
        Self { faces, ids }
    }

    /// The id of all faces.
    pub(super) fn single_id(&self) -> Option<i64> {
        let first = self.ids.first().copied().flatten()?;
        self.ids.iter().all(|id| *id == Some(first)).then_some(first)
    }

    /// The vertices of the faces with one of these ids, in increasing order.
    pub(super) fn vertices(&self, ids: &Ids) -> Vec<u32> {
        let mut vertices: Vec<u32> = self.selected(ids).flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The faces with one of these ids.
    pub(super) fn selected(&self, ids: &Ids) -> impl Iterator<Item = &[u32; 3]> {
        let faces = self.faces.iter().zip(&self.ids);
        faces.filter(|(_, id)| ids.contain(**id)).map(|(face, _)| face)
    }
}

/// Ids of faces or of bodies; `None` for all.
pub(super) struct Ids(pub(super) Option<Vec<i64>>);

impl Ids {
    /// One id, a list of ids, or `"all"`.
    pub(super) fn parse(entry: &Entry<'_>) -> Result<Self, Fault> {
        if entry.value.as_str() == Some("all") {
            return Ok(Self(None));
        }
        let ids: Result<Vec<i64>, Fault> = entry.list().iter().map(Entry::integer).collect();
        Ok(Self(Some(ids?)))
    }

    pub(super) fn contain(&self, id: Option<i64>) -> bool {
        let Self(ids) = self;
        ids.as_ref()
            .is_none_or(|ids| id.is_some_and(|id| ids.contains(&id)))
    }
}

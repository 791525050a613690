//! The contents of a page before its first frame.

use exact_ccd_mesh::{Aabb, HalfSpace, Point, TriangleMesh};
use exact_ccd_view::{Body, Page};

use crate::assembly::Assembly;

/// All that a page has beside its frames and contacts.
#[derive(Default)]
pub(super) struct Setup {
    /// The ids of vertices and faces in the files of their parts, if the frames are from files.
    pub(super) ids: Option<(Vec<u32>, Vec<Option<u32>>)>,
    pub(super) bodies: Vec<Body>,
    pub(super) half_spaces: Vec<HalfSpace>,
    /// The radii of rods and particles.
    pub(super) radii: Vec<f64>,
    pub(super) up: Option<Point>,
}

impl Setup {
    /// The setup of meshes from files.
    pub(super) fn of_scene(scene: &Assembly, half_spaces: Vec<HalfSpace>) -> Self {
        Self {
            ids: Some(scene.ids_in_parts()),
            bodies: scene.bodies(),
            half_spaces,
            ..Self::default()
        }
    }

    /// The same setup with a direction upwards, if there is one.
    pub(super) fn with_up(self, up: Option<Point>) -> Self {
        Self { up, ..self }
    }

    /// A page with these contents, for frames of a mesh in a box.
    pub(super) fn page(self, title: &str, mesh: TriangleMesh, bounds: &Aabb) -> Page {
        let page = Page::new(title, mesh, bounds);
        let mut page = page.with_bodies(self.bodies).with_radii(&self.radii);
        for HalfSpace { name, point, normal } in self.half_spaces {
            page = page.with_half_space(name, point, normal);
        }
        if let Some(up) = self.up {
            page = page.with_up(up);
        }
        match self.ids {
            Some((vertices, faces)) => page.with_ids(vertices, faces),
            None => page,
        }
    }
}

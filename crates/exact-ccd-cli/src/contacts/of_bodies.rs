//! Contacts of rigid bodies.

use exact_ccd_mesh::BodyContact;

use super::record::{Bounds, ContactRecord, RecordKind, unsigned_zero};

/// A primitive of a part: its id and its vertices in the mesh of the scene.
pub(crate) struct PartPrimitive {
    pub(crate) id: Option<u32>,
    pub(crate) vertices: Vec<u32>,
}

impl ContactRecord {
    /// A contact in the step that begins at a frame. The normal is in the coordinates of the world, in which
    /// the place is not computed.
    pub(crate) fn of_bodies(
        frame: usize,
        primitives: [PartPrimitive; 2],
        contact: &BodyContact,
        min_distance: f64,
    ) -> Self {
        let time = contact.impact.time;
        // At the start, bodies can be nearer than the minimum distance.
        let nearest = if time.lower() == 0.0 { 0.0 } else { min_distance };
        Self {
            kind: RecordKind::Pair(contact.kind),
            time: Bounds {
                lower: time.lower(),
                upper: time.upper(),
            },
            normal: contact.impact.normal.map(|normal| normal.map(unsigned_zero)),
            parameters: Some(contact.impact.parameters.map(unsigned_zero)),
            distance: Bounds {
                lower: nearest,
                upper: min_distance,
            },
            ..Self::of_bodies_that_cross(frame, primitives)
        }
    }

    /// An edge of a body that passes through a face of another one, in a frame.
    pub(crate) fn of_bodies_that_cross(frame: usize, primitives: [PartPrimitive; 2]) -> Self {
        Self {
            frame,
            kind: RecordKind::EdgeFace,
            ids: primitives.each_ref().map(|primitive| primitive.id),
            vertices: primitives.each_ref().map(|primitive| primitive.vertices.clone()),
            mesh_vertices: primitives.map(|primitive| primitive.vertices),
            ..Self::default()
        }
    }
}

//! Contacts, as the page has them.

use exact_ccd::Impact;
use exact_ccd_mesh::vector::{cross, dot, minus};
use exact_ccd_mesh::{Contact, Intersection, Point, TriangleMesh, contact_points};
use serde::Serialize;

use crate::half_space::ShownHalfSpace;

/// Two primitives that touch, in the shape of the JSON object.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ShownContact {
    /// The number of the frame at which the step of the contact begins.
    pub(crate) frame: usize,
    time: f64,
    primitives: [Primitive; 2],
    /// The points of both primitives that touch or are closest: the same, up to rounding, if they touch.
    closest: [Point; 2],
    /// The distance of the primitives at the time, rounded down.
    distance: f64,
    normal: Option<Point>,
    parameters: Option<[f64; 2]>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Primitive {
    kind: &'static str,
    /// The id in the file; none for a face that has none there.
    id: Option<u32>,
    /// The vertices in the mesh of the page, for the picture.
    vertices: Vec<u32>,
    /// Their ids in the file, for the texts.
    labels: Vec<u32>,
}

/// The ids in a file of the vertices and faces of a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Labels {
    pub(crate) vertices: Vec<u32>,
    pub(crate) faces: Vec<Option<u32>>,
}

impl Primitive {
    /// The primitive of these vertices: one for a vertex, two for an edge, three for a face.
    pub(crate) fn new(id: Option<u32>, vertices: &[u32]) -> Self {
        let kind = match vertices.len() {
            1 => "vertex",
            2 => "edge",
            _ => "face",
        };
        let (vertices, labels) = (vertices.to_vec(), vertices.to_vec());
        Self {
            kind,
            id,
            vertices,
            labels,
        }
    }

    /// The half space of this number, which has no vertices.
    fn half_space(number: u32) -> Self {
        Self {
            kind: "half-space",
            id: Some(number),
            vertices: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// The same primitive with the ids of a file. Edges have no ids in files: theirs is that in the mesh.
    fn label(&mut self, labels: &Labels) {
        let vertex = |&vertex: &u32| labels.vertices.get(vertex as usize).copied().unwrap_or(vertex);
        self.labels = self.vertices.iter().map(vertex).collect();
        self.id = match self.kind {
            "vertex" => self.labels.first().copied(),
            "face" => self
                .id
                .and_then(|face| labels.faces.get(face as usize).copied().flatten()),
            _ => self.id,
        };
    }
}

impl ShownContact {
    /// Replaces the ids of the mesh by the ids of a file.
    pub(crate) fn label(&mut self, labels: &Labels) {
        self.primitives
            .iter_mut()
            .for_each(|primitive| primitive.label(labels));
    }

    /// A contact of a mesh in the step from the frame with this number to the next one; `None` if the mesh
    /// does not have its primitives.
    pub(crate) fn of_pair(
        mesh: &TriangleMesh,
        frame: usize,
        positions: [&[Point]; 2],
        contact: &Contact,
    ) -> Option<Self> {
        let vertices = contact.pair.vertices(mesh)?;
        let ids = contact.pair.ids();
        let (first, second) = vertices.split_at(contact.pair.kind().sizes()[0]);
        let primitives = [
            Primitive::new(Some(ids[0]), first),
            Primitive::new(Some(ids[1]), second),
        ];
        let distance = contact.distance.lower;
        Self::new(primitives, frame, positions, &contact.impact, distance)
    }

    /// The contact of two primitives in the step from the frame with this number to the next one; `None` if a
    /// vertex has no position.
    pub(crate) fn new(
        primitives: [Primitive; 2],
        frame: usize,
        positions: [&[Point]; 2],
        impact: &Impact,
        distance: f64,
    ) -> Option<Self> {
        let [first, second] = [&primitives[0], &primitives[1]].map(|primitive| &primitive.vertices[..]);
        let closest = contact_points([first, second], positions, impact)?;
        Some(Self {
            frame,
            time: impact.time.lower(),
            primitives,
            closest,
            distance,
            normal: impact.normal,
            parameters: Some(impact.parameters),
        })
    }

    /// An edge that meets a face in the frame with this number; `None` if they are not of the mesh.
    pub(crate) fn at_rest(
        mesh: &TriangleMesh,
        frame: usize,
        positions: &[Point],
        intersection: Intersection,
    ) -> Option<Self> {
        let edge = mesh.edges().get(intersection.edge as usize)?;
        let face = mesh.faces().get(intersection.face as usize)?;
        let at = |&vertex: &u32| positions[vertex as usize];
        let [start, end] = [at(&edge[0]), at(&edge[1])];
        let [a, b, c] = [at(&face[0]), at(&face[1]), at(&face[2])];
        let normal = cross(minus(b, a), minus(c, a));
        // The place on the edge, for the eye: its middle, if the edge lies in the plane of the face.
        let [from, to] = [start, end].map(|end| dot(minus(end, a), normal));
        let place = from / (from - to);
        let place = if place.is_finite() {
            place.clamp(0.0, 1.0)
        } else {
            0.5
        };
        let length = dot(normal, normal).sqrt();
        Some(Self {
            frame,
            time: 0.0,
            primitives: [
                Primitive::new(Some(intersection.edge), edge),
                Primitive::new(Some(intersection.face), face),
            ],
            closest: [mix(start, end, place); 2],
            distance: 0.0,
            normal: (length.is_normal()).then(|| normal.map(|x| x / length)),
            parameters: None,
        })
    }

    /// A vertex that is not apart from the half space of this number, at a time of the step from the
    /// frame with this number; `None` if the vertex has no position.
    pub(crate) fn in_half_space(
        (frame, time): (usize, f64),
        positions: [&[Point]; 2],
        vertex: u32,
        number: u32,
        half_space: &ShownHalfSpace,
    ) -> Option<Self> {
        let [start, end] = positions.map(|positions| positions.get(vertex as usize).copied());
        let position = mix(start?, end?, time);
        Some(Self {
            frame,
            time,
            primitives: [
                Primitive::new(Some(vertex), &[vertex]),
                Primitive::half_space(number),
            ],
            closest: [position, half_space.foot(position)],
            distance: 0.0,
            normal: Some(half_space.normal),
            parameters: None,
        })
    }
}

/// (1 − t) a + t b, for the eye. It is finite for t in [0, 1].
pub(crate) fn mix(a: Point, b: Point, t: f64) -> Point {
    [0, 1, 2].map(|axis| (1.0 - t) * a[axis] + t * b[axis])
}

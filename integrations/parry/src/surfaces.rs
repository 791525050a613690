//! Two surfaces as one mesh. Only pairs between the two surfaces can collide.

use std::error::Error;

use exact_ccd::{CONTACT, Impact, Options, Point, Query, Separation, with_kind};
use exact_ccd_mesh::{
    Bvh, CanCollide, Detector, IntersectionOptions, Meeting, Pair, PairKind, TriangleMesh, contact_points,
    intersections,
};

/// Any reason why a query has no answer: positions that are not finite, indices that do not exist.
pub(crate) type Failure = Box<dyn Error>;

/// A surface: triangles, or segments of a line.
pub(crate) struct Surface {
    pub(crate) points: Vec<Point>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) edges: Vec<[u32; 2]>,
}

/// The place where two surfaces meet. All pairs have the first surface first.
pub(crate) struct Place {
    /// The indices of the triangles or segments.
    pub(crate) parts: [u32; 2],
    /// The points, in the frame of the first surface.
    pub(crate) points: [Point; 2],
    /// The unit normal from the first surface to the second, if there is one.
    pub(crate) normal: Option<Point>,
}

/// Two surfaces.
pub(crate) struct Surfaces {
    pub(crate) mesh: TriangleMesh,
    pub(crate) positions: Vec<Point>,
    /// The number of vertices of the first surface.
    pub(crate) first_len: usize,
    /// The triangles, or the segments, of both.
    parts: [Vec<Vec<u32>>; 2],
}

impl Surfaces {
    pub(crate) fn new(first: Surface, second: Surface) -> Result<Self, Failure> {
        let first_len = first.points.len();
        let offset = u32::try_from(first_len)?;
        let (mut faces, mut edges) = (first.faces, first.edges);
        let parts_of = |faces: &[[u32; 3]], edges: &[[u32; 2]]| -> Vec<Vec<u32>> {
            let faces = faces.iter().map(|face| face.to_vec());
            faces.chain(edges.iter().map(|edge| edge.to_vec())).collect()
        };
        let shift = |index: u32| index.checked_add(offset).ok_or("more than 2^32 vertices");
        let (own_faces, own_edges) = (faces.len(), edges.len());
        for [a, b, c] in second.faces {
            faces.push([shift(a)?, shift(b)?, shift(c)?]);
        }
        for [a, b] in second.edges {
            edges.push([shift(a)?, shift(b)?]);
        }
        let parts = [
            parts_of(&faces[..own_faces], &edges[..own_edges]),
            parts_of(&faces[own_faces..], &edges[own_edges..]),
        ];
        let positions = [first.points, second.points].concat();
        let mesh = TriangleMesh::with_edges(positions.len(), faces, &edges)?;
        Ok(Self {
            mesh,
            positions,
            first_len,
            parts,
        })
    }

    /// The pairs between the two surfaces.
    pub(crate) fn between(&self) -> CanCollide {
        let groups = (0..self.positions.len()).map(|vertex| u32::from(vertex >= self.first_len));
        CanCollide::different_groups(groups.collect())
    }

    pub(crate) fn detector(&self) -> Detector {
        Detector::new(self.mesh.clone()).with_can_collide(self.between())
    }

    /// The parts that meet at the start, if any do.
    pub(crate) fn meet(&self) -> Result<Option<[u32; 2]>, Failure> {
        let x = &self.positions;
        if let Some(contact) = self.detector().collision(x, x, CONTACT)? {
            return Ok(Some(self.place(contact.pair, [x, x], &contact.impact)?.parts));
        }
        Ok(self.crossing()?.map(|place| place.parts))
    }

    /// The place where an edge passes through a face at the start, if one does.
    pub(crate) fn crossing(&self) -> Result<Option<Place>, Failure> {
        let options = IntersectionOptions::default()
            .with_meeting(Meeting::Crossing)
            .with_can_collide(self.between());
        let crossings = intersections(&self.mesh, &self.positions, &Bvh, &options)?;
        let Some(crossing) = crossings.first() else {
            return Ok(None);
        };
        let face = self.mesh.faces()[crossing.face as usize];
        let edge = self.mesh.edges()[crossing.edge as usize];
        let corner = self.positions[edge[0] as usize];
        let sides = [&edge[..], &face[..]];
        let is_first = (edge[0] as usize) < self.first_len;
        let [a, b] = if is_first { sides } else { [sides[1], sides[0]] };
        Ok(Some(Place {
            parts: [self.part(0, a), self.part(1, b)],
            points: [corner; 2],
            normal: None,
        }))
    }

    /// The place of an impact of a pair between these positions at the start and at the end.
    pub(crate) fn place(&self, pair: Pair, ends: [&[Point]; 2], impact: &Impact) -> Result<Place, Failure> {
        let vertices = pair.vertices(&self.mesh).ok_or("a pair of another mesh")?;
        let (a, b) = vertices.split_at(pair.kind().sizes()[0]);
        let points = contact_points([a, b], ends, impact).ok_or("a vertex without position")?;
        // The normal of the impact leads from its second primitive to its first.
        let is_in_order = (a[0] as usize) < self.first_len;
        let [p, q] = points;
        Ok(if is_in_order {
            Place {
                parts: [self.part(0, a), self.part(1, b)],
                points: [p, q],
                normal: impact.normal.map(|normal| normal.map(|x| -x)),
            }
        } else {
            Place {
                parts: [self.part(0, b), self.part(1, a)],
                points: [q, p],
                normal: impact.normal,
            }
        })
    }

    /// The closest points of a pair at rest.
    pub(crate) fn closest(&self, pair: Pair, positions: &[Point]) -> Result<Place, Failure> {
        let impact = with_kind!(pair.kind(), K => self.impact::<K>(pair, positions));
        self.place(pair, [positions; 2], &impact?)
    }

    /// The impact at the start within any distance has the closest points.
    fn impact<K: PairKind>(&self, pair: Pair, positions: &[Point]) -> Result<Impact, Failure> {
        let vertices = K::vertices(&self.mesh, pair.ids()).ok_or("a pair of another mesh")?;
        let mut points = K::Points::default();
        for (point, &vertex) in points.as_mut().iter_mut().zip(vertices.as_ref()) {
            *point = positions[vertex as usize];
        }
        let any = Options::within(Separation::new(f64::MAX)?);
        let impact = Query::<K>::new(points, points)?.impact(any);
        Ok(impact.ok_or("a pair farther apart than the largest f64")?)
    }

    /// The first part of a surface that has all these vertices.
    fn part(&self, surface: usize, vertices: &[u32]) -> u32 {
        let contains = |part: &Vec<u32>| vertices.iter().all(|vertex| part.contains(vertex));
        // Each vertex in contact belongs to a part; parts are fewer than 2³².
        self.parts[surface].iter().position(contains).unwrap_or(0) as u32
    }
}

//! Contacts as C structures.

use exact_ccd::Point;
use exact_ccd_mesh::{TriangleMesh, contact_points};

use crate::kind::Kind;
use crate::pair::{EXACT_CCD_NONE, Pair};

/// The first time at which two primitives touch or come within a distance, and the place.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Impact {
    /// The time, from 0 to 1, rounded down to `double`.
    pub time: f64,
    /// True if `time` is the exact time, false if the exact time lies above it.
    pub time_is_exact: bool,
    /// True if there is a normal.
    pub has_normal: bool,
    /// u and v, from 0 to 1: the points (1 - u - v) v1 + u v2 + v v3 of a face, or (1 - u) a0 + u a1
    /// and (1 - v) b0 + v b1 of two edges. A vertex is an edge of length zero there: against an edge, the
    /// point is (1 - v) b0 + v b1. With a face, u + v may be larger than 1 by rounding.
    pub parameters: [f64; 2],
    /// The unit normal, from the second primitive towards the first; zero if there is none.
    pub normal: [f64; 3],
    /// x, y and z of the points of the first and of the second primitive that touch or are closest at that
    /// time. They are rounded: at contact, both are the same up to a few units in the last place of the
    /// largest coordinate, and up to 2^-32 of the size of the primitives.
    pub points: [[f64; 3]; 2],
}

impl Impact {
    /// The impact of two primitives, given by their vertices, whose positions at both ends of the step are
    /// `positions`.
    fn new(impact: &exact_ccd::Impact, primitives: [&[u32]; 2], positions: [&[Point]; 2]) -> Self {
        Self {
            time: impact.time.lower(),
            time_is_exact: impact.time.is_exact(),
            has_normal: impact.normal.is_some(),
            parameters: impact.parameters,
            normal: impact.normal.unwrap_or_default(),
            // All vertices have positions.
            points: contact_points(primitives, positions, impact).unwrap_or_default(),
        }
    }

    /// The impact of a query of kind `K` with these points at both ends of the step.
    pub(crate) fn of_query<K: exact_ccd::Kind>(
        impact: &exact_ccd::Impact,
        t0: &K::Points,
        t1: &K::Points,
    ) -> Self {
        let (t0, t1) = (t0.as_ref(), t1.as_ref());
        let (first, second) = [0, 1, 2, 3][..t0.len()].split_at(K::FIRST);
        Self::new(impact, [first, second], [t0, t1])
    }
}

/// A closed interval of times, whose ends are rounded down to `double`. The end is rounded down as
/// well: an interval that ends at 1 has `end` = 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The first time.
    pub start: f64,
    /// The last time; equal to `start` for a single moment.
    pub end: f64,
}

impl From<&exact_ccd::Interval> for Interval {
    fn from(interval: &exact_ccd::Interval) -> Self {
        Self {
            start: interval.start.lower(),
            end: interval.end.lower(),
        }
    }
}

/// Two primitives of a mesh that touch in a step, or come within the distance of the detector.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// The kind of the pair, of `exact_ccd_kind_t`; `EXACT_CCD_KIND_EDGE_FACE` for an intersection at rest.
    pub kind: u32,
    /// The index of the first primitive: the vertex, or the edge of the smaller index.
    pub first: u32,
    /// The index of the second: the face, the edge or the vertex.
    pub second: u32,
    /// The vertices, in the order of the kind; `EXACT_CCD_NONE` in the places that the kind does not use.
    pub vertices: [u32; 4],
    /// Bounds of the distance at that time: 0 for a minimum distance of 0.
    pub distance: [f64; 2],
    /// The time and the place.
    pub impact: Impact,
}

impl Contact {
    /// A contact in the step between two arrays of positions.
    pub(crate) fn of(
        mesh: &TriangleMesh,
        positions: [&[Point]; 2],
        contact: &exact_ccd_mesh::Contact,
    ) -> Self {
        let Pair {
            kind,
            first,
            second,
            vertices,
        } = Pair::of(mesh, contact.pair);
        let used = vertices
            .iter()
            .take_while(|&&vertex| vertex != EXACT_CCD_NONE)
            .count();
        let (a, b) = vertices[..used].split_at(contact.pair.kind().sizes()[0].min(used));
        Self {
            kind,
            first,
            second,
            vertices,
            distance: [contact.distance.lower, contact.distance.upper],
            impact: Impact::new(&contact.impact, [a, b], positions),
        }
    }

    /// An edge that meets a face at rest: only the indices have a meaning.
    pub(crate) fn of_intersection(edge: u32, face: u32) -> Self {
        Self {
            kind: Kind::EdgeFace as u32,
            first: edge,
            second: face,
            vertices: [EXACT_CCD_NONE; 4],
            distance: [0.0; 2],
            impact: Impact::default(),
        }
    }
}

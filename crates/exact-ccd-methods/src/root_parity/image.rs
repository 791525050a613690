//! The image of the domain under F, and its predicates.

use std::cmp::Ordering;

use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexFace};

use super::number::{Number, Vector, dot, turn, volume};

/// The domain of (t, u, v): its corners, and the faces as cycles of four of them.
pub(super) struct Domain {
    /// F at the corners at t = 0, and at t = 1 in the same order: `(i, j)` stands for xᵢ − xⱼ. A
    /// triangle has its last corner twice.
    corners: [(usize, usize); 4],
    pub(super) faces: &'static [[usize; 4]],
}

/// A kind of query with its domain.
pub(super) trait Solid: Kind {
    const DOMAIN: Domain;
}

/// The domain is a prism.
impl Solid for VertexFace {
    const DOMAIN: Domain = Domain {
        corners: [(0, 1), (0, 2), (0, 3), (0, 3)],
        faces: &[
            [0, 1, 2, 2],
            [4, 5, 6, 6],
            [0, 1, 5, 4],
            [1, 2, 6, 5],
            [2, 0, 4, 6],
        ],
    };
}

/// The domain is a cube.
impl Solid for EdgeEdge {
    const DOMAIN: Domain = Domain {
        corners: [(0, 2), (0, 3), (1, 3), (1, 2)],
        faces: &[
            [0, 1, 2, 3],
            [4, 5, 6, 7],
            [0, 1, 5, 4],
            [1, 2, 6, 5],
            [2, 3, 7, 6],
            [3, 0, 4, 7],
        ],
    };
}

impl Domain {
    /// The faces that are triangles.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.faces
            .iter()
            .filter(|[.., c, d]| c == d)
            .map(|&[a, b, c, _]| [a, b, c])
    }
}

/// The vectors from the origin to the eight corners, and the direction of a ray.
pub(super) type Vectors<N> = [Vector<N>; 9];

/// The index of the direction of the ray among the vectors.
pub(super) const RAY: usize = 8;

/// The vectors as differences of two points, before anything is computed or rounded.
pub(super) type Differences = [[Point; 2]; 9];

pub(super) fn differences<K: Solid>(query: &Query<K>, ray: Point) -> Differences {
    let mut differences = [[ray, [0.0; 3]]; 9];
    for (time, points) in query.points().iter().enumerate() {
        for (corner, &(i, j)) in K::DOMAIN.corners.iter().enumerate() {
            differences[4 * time + corner] = [points[i], points[j]];
        }
    }
    differences
}

pub(super) fn vectors<N: Number>(differences: &Differences) -> Vectors<N> {
    differences.map(|[minuend, subtrahend]| {
        [0, 1, 2].map(|axis| N::exactly(minuend[axis]) - N::exactly(subtrahend[axis]))
    })
}

/// A polynomial in vectors, which are given by their indices. Its sign is the predicate.
#[derive(Clone, Copy)]
pub(super) enum Predicate {
    /// a · (b × c).
    Volume([usize; 3]),
    /// The component of a × b along an axis.
    Turn(usize, [usize; 2]),
    /// a · b.
    Dot([usize; 2]),
    /// For the origin and a patch with four corners, V₀ V₂ − V₁ V₃, where Vᵢ is the volume of the
    /// corners but the i-th. It is the function of the paper that vanishes on the patch.
    Phi([usize; 4]),
}

impl Predicate {
    /// True if this is a determinant of vectors of which two are the same, as for a triangle that
    /// has a corner twice. Then it is zero, but in intervals it is not.
    pub(super) fn vanishes(self) -> bool {
        match self {
            Self::Volume([a, b, c]) => a == b || b == c || c == a,
            Self::Turn(_, [a, b]) => a == b,
            Self::Dot(_) | Self::Phi(_) => false,
        }
    }

    pub(super) fn value<N: Number>(self, vectors: &Vectors<N>) -> N {
        let volume = |a: usize, b: usize, c: usize| volume(&vectors[a], &vectors[b], &vectors[c]);
        match self {
            Self::Volume([a, b, c]) => volume(a, b, c),
            Self::Turn(axis, [a, b]) => turn(axis, &vectors[a], &vectors[b]),
            Self::Dot([a, b]) => dot(&vectors[a], &vectors[b]),
            Self::Phi([a, b, c, d]) => volume(b, c, d) * volume(a, b, d) - volume(a, c, d) * volume(a, b, c),
        }
    }
}

/// An image of the domain, with a ray.
pub(super) trait Image {
    /// The sign of a predicate.
    fn sign(&self, predicate: Predicate) -> Ordering;

    /// True if a patch contains the origin, which is in the plane of its four corners.
    fn flat_patch_contains_origin(&self, patch: [usize; 4]) -> bool;
}

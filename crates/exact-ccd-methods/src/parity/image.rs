//! The image of the domain under F, and its predicates.

use std::cmp::Ordering;

use dashu_int::IBig;
use exact_ccd::{Kind, Point, Query};

use crate::integers::to_integers;
use crate::ring::Ring;
use crate::vector::{Vector, cross, dot, turn};

/// The domain of (t, u, v): its corners, and the faces as cycles of four of them.
pub(super) struct Domain {
    /// F at the corners at t = 0, and at t = 1 in the same order: `(i, j)` stands for xᵢ − xⱼ. A
    /// triangle has its last corner twice.
    pub(super) corners: [(usize, usize); 4],
    pub(super) faces: &'static [[usize; 4]],
}

/// The domain for a vertex and a face.
const PRISM: Domain = Domain {
    corners: [(0, 1), (0, 2), (0, 3), (0, 3)],
    faces: &[
        [0, 1, 2, 2],
        [4, 5, 6, 6],
        [0, 1, 5, 4],
        [1, 2, 6, 5],
        [2, 0, 4, 6],
    ],
};

/// The domain for two edges.
const HEXAHEDRON: Domain = Domain {
    corners: [(0, 2), (0, 3), (1, 2), (1, 3)],
    faces: &[
        [0, 1, 3, 2],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [1, 3, 7, 5],
        [3, 2, 6, 7],
        [2, 0, 4, 6],
    ],
};

impl Domain {
    /// The domain of a kind of query, whose first primitive is a vertex or an edge.
    #[inline]
    pub(super) fn of<K: Kind<Points = [Point; 4]>>() -> &'static Self {
        if K::FIRST == 1 { &PRISM } else { &HEXAHEDRON }
    }

    /// The faces that are triangles.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.faces
            .iter()
            .filter(|[.., c, d]| c == d)
            .map(|&[a, b, c, _]| [a, b, c])
    }

    /// The pairs of points whose differences are F at the corners.
    #[inline]
    pub(super) fn pairs<K: Kind<Points = [Point; 4]>>(&self, query: &Query<K>) -> [[Point; 2]; 8] {
        let mut pairs = [[[0.0; 3]; 2]; 8];
        for (pairs, points) in pairs.as_chunks_mut::<4>().0.iter_mut().zip(query.points()) {
            for (pair, (i, j)) in pairs.iter_mut().zip(self.corners) {
                *pair = [points[i], points[j]];
            }
        }
        pairs
    }
}

/// The vectors from the origin to the eight corners, and the direction of a ray.
pub(super) type Vectors<N> = [Vector<N>; 9];

/// The index of the direction of the ray among the vectors.
pub(super) const RAY: usize = 8;

/// The vectors as differences of two points, before anything is computed or rounded.
pub(super) type Differences = [[Point; 2]; 9];

/// The corners as differences, and a ray.
#[inline]
pub(super) fn with_ray(pairs: &[[Point; 2]; 8], ray: Point) -> Differences {
    let mut differences = [[ray, [0.0; 3]]; 9];
    differences[..RAY].copy_from_slice(pairs);
    differences
}

#[inline]
pub(super) fn vectors<N: Ring + From<f64>>(differences: &Differences) -> Vectors<N> {
    differences.map(|[minuend, subtrahend]| {
        [0, 1, 2].map(|axis: usize| N::from(minuend[axis]) - N::from(subtrahend[axis]))
    })
}

/// All vectors, divided by the same power of two.
pub(super) fn integers<const N: usize>(differences: &[[Point; 2]; N]) -> [Vector<IBig>; N] {
    to_integers(differences).map(|[minuend, subtrahend]| {
        let [x, y, z] = minuend;
        let [a, b, c] = subtrahend;
        [x - a, y - b, z - c]
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
    /// Returns true if two vectors of this determinant are the same, as for a triangle that has a corner
    /// twice, and for a point at rest. It is zero then, but no rounded arithmetic proves it.
    pub(super) fn vanishes<V: PartialEq>(self, vectors: &[V; 9]) -> bool {
        let same = |i: usize, j: usize| vectors[i] == vectors[j];
        match self {
            Self::Volume([a, b, c]) => same(a, b) || same(b, c) || same(c, a),
            Self::Turn(_, [a, b]) => same(a, b),
            Self::Dot(_) | Self::Phi(_) => false,
        }
    }

    /// The sign of integers.
    pub(super) fn sign(self, vectors: &[Vector<IBig>]) -> Ordering {
        self.value(vectors).cmp(&IBig::ZERO)
    }

    #[inline(always)]
    pub(super) fn value<N: Ring>(self, vectors: &[Vector<N>]) -> N {
        match self {
            Self::Volume(corners) => volume(vectors, corners),
            Self::Turn(axis, [a, b]) => turn(axis, &vectors[a], &vectors[b]),
            Self::Dot([a, b]) => dot(&vectors[a], &vectors[b]),
            Self::Phi([a, b, c, d]) => {
                let [v0, v1, v2, v3] =
                    [[b, c, d], [a, c, d], [a, b, d], [a, b, c]].map(|corners| volume(vectors, corners));
                v0 * v2 - v1 * v3
            }
        }
    }
}

/// a · (b × c).
#[inline(always)]
fn volume<N: Ring>(vectors: &[Vector<N>], [a, b, c]: [usize; 3]) -> N {
    dot(&vectors[a], &cross(&vectors[b], &vectors[c]))
}

/// An image of the domain, with a ray.
pub(super) trait Image {
    /// The sign of a predicate.
    fn sign(&self, predicate: Predicate) -> Ordering;
}

impl Image for Vectors<IBig> {
    fn sign(&self, predicate: Predicate) -> Ordering {
        predicate.sign(self)
    }
}

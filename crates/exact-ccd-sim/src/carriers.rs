//! The linear map from the unknowns of a system to its vertices.
//!
//! A vertex is an unknown itself, or four nodes carry it: x = Σ wₖ qₖ with constant weights of sum 1. An
//! affine body is such a set of vertices (L. Lan, D. Kaufman, M. Li, C. Jiang, Y. Yang, *Affine Body
//! Dynamics*, ACM Transactions on Graphics 41(4), 2022): its nodes are four of the vertices of the system,
//! whose twelve coordinates determine an affine map. All energies are functions of vertices. Derivatives by
//! the nodes follow from derivatives by vertices, with the transposed map. In a step in which nodes move in
//! straight lines, so do the vertices that they carry.

use std::borrow::Cow;
use std::ops::Range;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, Matrix3, Vector3};

/// The nodes that carry a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Carrier {
    /// The first of four consecutive nodes.
    pub(crate) first: u32,
    /// Their weights, of sum 1.
    pub(crate) weights: [f64; 4],
}

/// The carried vertices of a system.
#[derive(Clone, Debug, Default)]
pub(crate) struct Carriers {
    /// The carrier of each vertex. Vertices without an entry are not carried.
    carriers: Vec<Option<Carrier>>,
    /// The carried vertices of each affine body. Its four nodes follow them.
    bodies: Vec<Range<u32>>,
}

impl Carrier {
    fn nodes(&self) -> [u32; 4] {
        [0, 1, 2, 3].map(|node| self.first + node)
    }

    /// The nodes with their weights.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (u32, f64)> {
        self.nodes().into_iter().zip(self.weights)
    }

    /// Σ wₖ qₖ, as q₀ + Σ wₖ (qₖ − q₀): rounding errors grow with the size of the body, not with its distance
    /// from the origin.
    fn combine<T: Copy + Into<Vector3<f64>>>(&self, values: &[T]) -> Vector3<f64> {
        let [q0, rest @ ..] = self.nodes().map(|node| values[node as usize].into());
        let [_, weights @ ..] = self.weights;
        rest.iter()
            .zip(weights)
            .fold(q0, |sum, (q, weight)| sum + (q - q0) * weight)
    }
}

impl Carriers {
    /// Adds an affine body, with the carriers of its consecutive vertices, which its nodes follow.
    pub(crate) fn add(&mut self, first: u32, carriers: impl IntoIterator<Item = Carrier>) {
        self.carriers.resize(first as usize, None);
        self.carriers.extend(carriers.into_iter().map(Some));
        self.bodies.push(first..self.carriers.len() as u32);
    }

    /// Returns true if no vertex is carried.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The carried vertices of each affine body. Its four nodes follow them.
    pub(crate) fn bodies(&self) -> &[Range<u32>] {
        &self.bodies
    }

    /// The nodes of the affine body of these carried vertices.
    pub(crate) fn nodes(&self, carried: &Range<u32>) -> [u32; 4] {
        [0, 1, 2, 3].map(|node| carried.end + node)
    }

    /// The carrier of the point at a position, in the affine body of these vertices, with the positions of
    /// all vertices. Its weights are barycentric coordinates in the tetrahedron of the nodes, which is not
    /// flat.
    pub(crate) fn carrier_at(&self, carried: &Range<u32>, points: &[Point], at: Point) -> Carrier {
        let [a, b, c, d] = self
            .nodes(carried)
            .map(|node| Vector3::from(points[node as usize]));
        let edges = Matrix3::from_columns(&[b - a, c - a, d - a]);
        let place = edges.try_inverse().unwrap_or_else(Matrix3::zeros) * (Vector3::from(at) - a);
        Carrier {
            first: carried.end,
            weights: [1.0 - place.sum(), place.x, place.y, place.z],
        }
    }

    /// The nodes that carry a vertex.
    pub(crate) fn of(&self, vertex: u32) -> Option<&Carrier> {
        self.carriers.get(vertex as usize)?.as_ref()
    }

    /// Computes the values of carried vertices, such as positions or displacements, from their nodes.
    pub(crate) fn carry<T>(&self, values: &mut [T])
    where
        T: Copy + Into<Vector3<f64>> + From<Vector3<f64>>,
    {
        for (vertex, carrier) in self.carriers.iter().enumerate() {
            if let Some(carrier) = carrier {
                values[vertex] = carrier.combine(values).into();
            }
        }
    }

    /// Moves the forces on carried vertices to their nodes.
    pub(crate) fn collect(&self, forces: &mut [Vector3<f64>]) {
        for (vertex, carrier) in self.carriers.iter().enumerate() {
            if let Some(carrier) = carrier {
                let force = std::mem::take(&mut forces[vertex]);
                for (node, weight) in carrier.parts() {
                    forces[node as usize] += force * weight;
                }
            }
        }
    }

    /// The vertices on which a term of these vertices depends, without repetition: nodes in place of carried
    /// vertices.
    pub(crate) fn unknowns<'a>(&self, vertices: &'a [u32]) -> Cow<'a, [u32]> {
        if self.is_empty() || vertices.iter().all(|&vertex| self.of(vertex).is_none()) {
            return Cow::Borrowed(vertices);
        }
        let mut unknowns = Vec::new();
        for &vertex in vertices {
            match self.of(vertex) {
                None => unknowns.push(vertex),
                Some(carrier) => unknowns.extend(carrier.nodes()),
            }
        }
        unknowns.sort_unstable();
        unknowns.dedup();
        Cow::Owned(unknowns)
    }

    /// The Hessian of a term by its [unknowns](Self::unknowns), from the Hessian by its vertices.
    pub(crate) fn pulled(&self, vertices: &[u32], hessian: DMatrix<f64>) -> DMatrix<f64> {
        let Cow::Owned(unknowns) = self.unknowns(vertices) else {
            return hessian;
        };
        let place = |vertex: u32| unknowns.partition_point(|&unknown| unknown < vertex);
        let parts: Vec<Vec<(usize, f64)>> = vertices
            .iter()
            .map(|&vertex| match self.of(vertex) {
                None => vec![(place(vertex), 1.0)],
                Some(carrier) => carrier
                    .parts()
                    .map(|(node, weight)| (place(node), weight))
                    .collect(),
            })
            .collect();
        let mut sum = DMatrix::zeros(3 * unknowns.len(), 3 * unknowns.len());
        for (row, rows) in parts.iter().enumerate() {
            for (column, columns) in parts.iter().enumerate() {
                let block = hessian.fixed_view::<3, 3>(3 * row, 3 * column);
                for &(a, weight) in rows {
                    for &(b, other) in columns {
                        let mut view = sum.fixed_view_mut::<3, 3>(3 * a, 3 * b);
                        view += block * (weight * other);
                    }
                }
            }
        }
        sum
    }
}

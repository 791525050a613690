//! Sparse linear systems over the vertices that can move.

use std::cell::OnceCell;

use exact_ccd_mesh::Point;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

use crate::error::RepairError;

/// The vertices that can move, numbered: the unknowns of the linear systems.
pub(crate) struct Unknowns {
    /// The vertex of each unknown.
    vertices: Vec<u32>,
    /// The unknown of each vertex, if it can move.
    of_vertex: Vec<Option<u32>>,
    /// The order of elimination. All systems have an entry for each edge, so that it serves all.
    symbolic: OnceCell<SymbolicLlt<usize>>,
}

impl Unknowns {
    pub(crate) fn new(is_pinned: &[bool]) -> Self {
        let vertices: Vec<u32> = (0..)
            .zip(is_pinned)
            .filter(|(_, is)| !**is)
            .map(|(vertex, _)| vertex)
            .collect();
        let mut of_vertex = vec![None; is_pinned.len()];
        for (unknown, &vertex) in (0..).zip(&vertices) {
            of_vertex[vertex as usize] = Some(unknown);
        }
        Self {
            vertices,
            of_vertex,
            symbolic: OnceCell::new(),
        }
    }

    /// Returns true if a vertex cannot move.
    pub(crate) fn is_pinned(&self, vertex: usize) -> bool {
        self.of_vertex[vertex].is_none()
    }

    /// The system of the quadratic form `mass` Σ |xᵢ|² + Σ k |xᵢ − xⱼ|², the second sum over all edges of the
    /// mesh and their k. Pinned vertices have the value 0, unless [`solve`](Self::solve) has another one.
    pub(crate) fn system(
        &self,
        mass: f64,
        edges: impl Iterator<Item = ([u32; 2], f64)>,
    ) -> Result<System, RepairError> {
        let count = self.vertices.len();
        let failed = || RepairError::Factorisation { vertex_count: count };
        let mut diagonal = vec![mass; count];
        let mut triplets = Vec::new();
        for ([a, b], weight) in edges {
            let [a, b] = [a, b].map(|vertex| self.of_vertex[vertex as usize].map(|unknown| unknown as usize));
            for unknown in a.into_iter().chain(b) {
                diagonal[unknown] += weight;
            }
            if let (Some(a), Some(b)) = (a, b) {
                triplets.push(Triplet::new(a.max(b), a.min(b), -weight));
            }
        }
        triplets.extend(
            diagonal
                .into_iter()
                .enumerate()
                .map(|(i, value)| Triplet::new(i, i, value)),
        );
        let matrix = SparseColMat::try_new_from_triplets(count, count, &triplets).map_err(|_| failed())?;
        let symbolic = match self.symbolic.get() {
            Some(symbolic) => symbolic.clone(),
            None => SymbolicLlt::try_new(matrix.symbolic(), Side::Lower).map_err(|_| failed())?,
        };
        let symbolic = self.symbolic.get_or_init(|| symbolic);
        let factor = Llt::try_new_with_symbolic(symbolic.clone(), matrix.as_ref(), Side::Lower);
        let factor = factor.map_err(|_| failed())?;
        Ok(System { factor })
    }

    /// Solves a system for each axis. Pinned vertices have the values of `pinned`; their values in `right`
    /// are not read.
    pub(crate) fn solve(
        &self,
        system: &System,
        right: &[Point],
        pinned: impl Fn(u32) -> Point,
    ) -> Vec<Point> {
        let mut values = Mat::from_fn(self.vertices.len(), 3, |i, axis| {
            right[self.vertices[i] as usize][axis]
        });
        system.factor.solve_in_place(&mut values);
        let value = |(vertex, unknown): (u32, &Option<u32>)| match *unknown {
            Some(unknown) => [0, 1, 2].map(|axis| values[(unknown as usize, axis)]),
            None => pinned(vertex),
        };
        (0..).zip(&self.of_vertex).map(value).collect()
    }
}

/// A factorised system.
pub(crate) struct System {
    factor: Llt<usize, f64>,
}

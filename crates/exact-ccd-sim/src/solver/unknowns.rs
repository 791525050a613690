//! The vertices that are unknowns of the linear system.

use crate::prescribed::Axes;

/// A numbering of the vertices with at least one unknown coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unknowns {
    numbers: Vec<Option<u32>>,
    vertices: Vec<u32>,
    /// The known coordinates of each numbered vertex; empty if there is none.
    known: Vec<Axes>,
}

impl Unknowns {
    /// The numbering of vertices with these known coordinates, in their order.
    pub(crate) fn new(known: &[Axes]) -> Self {
        let mut vertices = Vec::new();
        let mut number = |(vertex, known): (usize, &Axes)| {
            (*known != [true; 3]).then(|| {
                vertices.push(vertex as u32);
                vertices.len() as u32 - 1
            })
        };
        let numbers = known.iter().enumerate().map(&mut number).collect();
        let of = |&vertex: &u32| known[vertex as usize];
        let known = if vertices.iter().any(|vertex| of(vertex) != [false; 3]) {
            vertices.iter().map(of).collect()
        } else {
            Vec::new()
        };
        Self {
            numbers,
            vertices,
            known,
        }
    }

    /// The number of unknown vertices.
    pub(crate) fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The number of a vertex, if it is unknown.
    pub(crate) fn number(&self, vertex: u32) -> Option<u32> {
        self.numbers[vertex as usize]
    }

    /// The unknown vertices, in their order.
    pub(crate) fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The known coordinates of the vertex with each number. `None` if there are none.
    pub(crate) fn known(&self) -> Option<&[Axes]> {
        (!self.known.is_empty()).then_some(&self.known)
    }
}

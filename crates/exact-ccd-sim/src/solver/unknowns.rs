//! The vertices that are unknowns of the linear system.

/// A numbering of some of the vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unknowns {
    numbers: Vec<Option<u32>>,
    vertices: Vec<u32>,
}

impl Unknowns {
    /// The numbering of the vertices for which `is_unknown` is true, in their order.
    pub(crate) fn new(is_unknown: &[bool]) -> Self {
        let mut vertices = Vec::new();
        let mut number = |(vertex, &unknown): (usize, &bool)| {
            unknown.then(|| {
                vertices.push(vertex as u32);
                vertices.len() as u32 - 1
            })
        };
        let numbers = is_unknown.iter().enumerate().map(&mut number).collect();
        Self { numbers, vertices }
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
}

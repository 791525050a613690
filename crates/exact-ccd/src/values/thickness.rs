//! Separations of the pairs of a mesh: one for all, or by the thickness of its vertices.

use alloc::vec::Vec;

use super::distance::{InvalidSeparation, Separation};

/// A thickness for each vertex of a mesh: primitives are as thick as the thickest of their vertices,
/// and the separation of two primitives is the sum of theirs.
///
/// ```
/// use exact_ccd::{Separations, Thickness};
///
/// let thickness = Thickness::new(&[0.5, 0.25, 2.0])?;
/// let separations = Separations::Thickness(&thickness);
/// assert_eq!(separations.between(&[0], &[1, 2]).get(), 2.5);
/// # Ok::<(), exact_ccd::InvalidThickness>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Thickness(Vec<Separation>);

/// A thickness is negative, not a number, or so large that a sum of two may not be finite.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the thickness of vertex {vertex} is {value}, expected a number from 0 to {:e}",
    Thickness::MAX
)]
pub struct InvalidThickness {
    /// The index of the vertex.
    pub vertex: usize,
    /// Its thickness.
    pub value: f64,
}

impl Thickness {
    /// The largest thickness: half of the largest f64.
    pub const MAX: f64 = 0.5 * f64::MAX;

    /// The thickness of each vertex, in the order of the mesh, each from 0 to [`MAX`](Self::MAX).
    ///
    /// # Errors
    /// [`InvalidThickness`] names the first vertex whose thickness is out of range.
    pub fn new(values: &[f64]) -> Result<Self, InvalidThickness> {
        let checked = |(vertex, &value): (usize, &f64)| match Separation::new(value) {
            Ok(separation) if separation.get() <= Self::MAX => Ok(separation),
            Ok(_) | Err(InvalidSeparation { .. }) => Err(InvalidThickness { vertex, value }),
        };
        values
            .iter()
            .enumerate()
            .map(checked)
            .collect::<Result<_, _>>()
            .map(Self)
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.0.len()
    }

    /// The thickness of a primitive: the largest thickness among its vertices. A vertex without a thickness
    /// counts with 0.
    #[must_use]
    #[inline]
    pub fn of(&self, vertices: &[u32]) -> Separation {
        let of_vertex = |&vertex: &u32| self.0.get(vertex as usize).copied().unwrap_or_default();
        vertices.iter().map(of_vertex).max().unwrap_or_default()
    }
}

/// The separation of each pair of primitives of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Separations<'a> {
    /// One for all pairs.
    Uniform(Separation),
    /// The sum of the thicknesses of both primitives, rounded up.
    Thickness(&'a Thickness),
}

impl Separations<'_> {
    /// The separation of two primitives, given by their vertices.
    #[must_use]
    #[inline]
    pub fn between(self, a: &[u32], b: &[u32]) -> Separation {
        match self {
            Self::Uniform(separation) => separation,
            Self::Thickness(thickness) => thickness.of(a).plus(thickness.of(b)),
        }
    }

    /// Returns true if the separation of all pairs is 0.
    #[inline]
    pub(crate) fn is_contact(self) -> bool {
        matches!(self, Self::Uniform(separation) if separation.is_zero())
    }
}

impl Default for Separations<'_> {
    fn default() -> Self {
        Self::Uniform(Separation::ZERO)
    }
}

impl From<Separation> for Separations<'_> {
    fn from(separation: Separation) -> Self {
        Self::Uniform(separation)
    }
}

impl<'a> From<&'a Thickness> for Separations<'a> {
    fn from(thickness: &'a Thickness) -> Self {
        Self::Thickness(thickness)
    }
}

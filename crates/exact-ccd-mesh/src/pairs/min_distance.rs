//! The distance that the primitives of a mesh keep.

use std::sync::Arc;

use exact_ccd::{Separation, Separations, Thickness};

use super::kind::PairKind;
use crate::mesh::TriangleMesh;

/// The distance that the primitives of a mesh keep from each other: one for all pairs, or by the
/// thickness of the vertices. The default is 0, which is contact.
///
/// Two primitives *touch* if their distance is at most the minimum distance of the pair, and all that
/// is said about contact holds for this. The distance is taken exactly. With
/// [thicknesses](Self::thickness), the minimum distance of a pair is the sum of both thicknesses, rounded up.
/// Primitives that share a vertex do not form a pair, and a vertex and an edge that another edge connects
/// touch at distance 0 only, whatever the minimum distance: see [`Pair`](crate::Pair). The minimum distance
/// should be smaller than the edges of the mesh: primitives that are two edges apart along the surface come
/// near each other too.
///
/// ```
/// use exact_ccd::{Options, Separation};
/// use exact_ccd_mesh::{Detector, MinDistance, TriangleMesh};
///
/// // A point falls on a triangle.
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let at = |z: f64| [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [1.0, 1.0, z]];
///
/// let d = Options::within(Separation::new(0.5)?);
/// let mut detector = Detector::new(mesh);
/// let contact = detector.collision(&at(2.5), &at(-1.5), d)?.expect("the point gets through");
/// assert_eq!((contact.impact.time.lower(), contact.distance.upper), (0.5, 0.5));
/// // It starts within 0.5, but stays 0.25 away.
/// assert!(detector.collides(&at(0.5), &at(0.375), d)?);
/// let inner = MinDistance::from(d.separation).with_inner(Separation::new(0.25)?);
/// assert!(!detector.collides(&at(0.5), &at(0.375), Options::within(inner.clone()))?);
/// assert!(detector.collides(&at(0.5), &at(0.125), Options::within(inner))?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MinDistance {
    outer: Outer,
    inner: Option<Separation>,
}

#[derive(Clone, Debug, PartialEq)]
enum Outer {
    Uniform(Separation),
    Thickness(Arc<Thickness>),
}

impl Default for Outer {
    fn default() -> Self {
        Self::Uniform(Separation::default())
    }
}

impl From<Separation> for MinDistance {
    fn from(d: Separation) -> Self {
        Self::uniform(d)
    }
}

/// The number of thicknesses is not the number of vertices of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{count} thicknesses, expected one for each of the {vertex_count} vertices")]
pub struct ThicknessCount {
    /// The number of thicknesses.
    pub count: usize,
    /// The number of vertices of the mesh.
    pub vertex_count: usize,
}

impl MinDistance {
    /// The same distance for all pairs.
    #[must_use]
    pub fn uniform(d: Separation) -> Self {
        Self {
            outer: Outer::Uniform(d),
            inner: None,
        }
    }

    /// The sum of the thicknesses of both primitives. A primitive is as thick as its thickest vertex.
    #[must_use]
    pub fn thickness(thickness: impl Into<Arc<Thickness>>) -> Self {
        Self {
            outer: Outer::Thickness(thickness.into()),
            inner: None,
        }
    }

    /// The same distance for pairs that start beyond it, and a smaller one for pairs that start within it:
    /// for a line search that has to move on from there.
    ///
    /// A pair that starts within its distance d touches if it comes within the lesser of d and
    /// `inner`. It may leave and return; all others touch within d.
    #[must_use]
    pub fn with_inner(self, inner: Separation) -> Self {
        Self {
            inner: Some(inner),
            ..self
        }
    }

    /// The same distance without an inner one.
    pub(crate) fn without_inner(self) -> Self {
        Self { inner: None, ..self }
    }

    /// The distances for pairs that start beyond them. Connected pairs are an exception:
    /// [`between`](Self::between) is 0 for them.
    #[must_use]
    pub fn separations(&self) -> Separations<'_> {
        match &self.outer {
            Outer::Uniform(d) => Separations::Uniform(*d),
            Outer::Thickness(thickness) => Separations::Thickness(thickness),
        }
    }

    /// The distance of a pair that starts beyond it, given by its vertices: 0 for a vertex and an edge that
    /// another edge of the mesh [connects](PairKind::are_connected).
    #[must_use]
    pub fn between<K: PairKind>(&self, mesh: &TriangleMesh, vertices: &K::Vertices) -> Separation {
        if K::are_connected(mesh, vertices) {
            return Separation::default();
        }
        let (a, b) = vertices.as_ref().split_at(K::FIRST);
        self.separations().between(a, b)
    }

    /// The inner distance, if there is one.
    #[must_use]
    pub fn inner(&self) -> Option<Separation> {
        self.inner
    }

    /// The same distance in a mesh that may have more vertices, which have the thickness 0.
    pub(crate) fn extended_to(self, mesh: &TriangleMesh) -> Self {
        match &self.outer {
            Outer::Thickness(thickness) if thickness.vertex_count() < mesh.vertex_count() => {
                let vertices = 0..mesh.vertex_count() as u32;
                let values: Vec<f64> = vertices.map(|vertex| thickness.of(&[vertex]).get()).collect();
                let thickness = Thickness::new(&values).expect("each is in range");
                Self {
                    outer: Outer::Thickness(thickness.into()),
                    ..self
                }
            }
            _ => self,
        }
    }

    /// Checks that each vertex of a mesh has a thickness, if there are any.
    ///
    /// # Errors
    /// [`ThicknessCount`] has both numbers.
    pub fn check(&self, mesh: &TriangleMesh) -> Result<(), ThicknessCount> {
        match &self.outer {
            Outer::Thickness(thickness) if thickness.vertex_count() != mesh.vertex_count() => {
                Err(ThicknessCount {
                    count: thickness.vertex_count(),
                    vertex_count: mesh.vertex_count(),
                })
            }
            Outer::Uniform(_) | Outer::Thickness(_) => Ok(()),
        }
    }
}

//! The pairs of primitives for which contact counts.

use std::fmt;
use std::sync::Arc;

use super::PairKind;
use super::group_matrix::{GroupError, GroupMatrix};

/// A predicate on pairs of primitives: only pairs that can collide are examined.
///
/// Primitives that share a vertex are never examined, whatever the predicate. Clones share the
/// predicate. A panic of the caller's own closure is passed on to the caller.
///
/// ```
/// use exact_ccd::CONTACT;
/// use exact_ccd_mesh::{CanCollide, Detector, TriangleMesh};
///
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let at = |height: f64| {
///     let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
///     let falling = [[1.0, 1.0, height], [1.0, 2.0, height + 4.0], [2.0, 1.0, height + 4.0]];
///     [floor, falling].concat()
/// };
///
/// let is_obstacle = vec![true; 6];
/// let mut detector = Detector::new(mesh).with_can_collide(CanCollide::not_two_obstacles(is_obstacle));
/// assert!(!detector.collides(&at(1.0), &at(-1.0), CONTACT)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Default)]
pub struct CanCollide {
    /// All pairs, if there is none.
    predicate: Option<Arc<Predicate>>,
    /// All vertices, if there is none.
    takes_part: Option<Arc<[bool]>>,
}

type Predicate = dyn Fn(&[u32], &[u32]) -> bool + Send + Sync;

impl CanCollide {
    /// All pairs can collide. This is the default.
    #[must_use]
    pub fn all() -> Self {
        Self::default()
    }

    /// A pair can collide if the predicate returns true for the vertices of its two primitives.
    ///
    /// The primitives are those of a [`Pair`](crate::Pair): slices of length 1 and 3, 2 and 2, 1 and 2, or
    /// 1 and 1. The predicate is called from many threads at once. If it allows two primitives, it should
    /// allow those that contain them: the edges of faces are compared by their faces, and the ends of edges
    /// by their edges, so that contact between parts is found between the whole; [`Pair`](crate::Pair) has
    /// the list.
    #[must_use]
    pub fn new(predicate: impl Fn(&[u32], &[u32]) -> bool + Send + Sync + 'static) -> Self {
        Self {
            predicate: Some(Arc::new(predicate)),
            takes_part: None,
        }
    }

    /// A pair can collide if the predicate holds for any vertex of the first primitive and any
    /// vertex of the second: the rule of the IPC Toolkit.
    #[must_use]
    pub fn any_vertices(predicate: impl Fn(u32, u32) -> bool + Send + Sync + 'static) -> Self {
        Self::new(move |a, b| a.iter().any(|&v| b.iter().any(|&w| predicate(v, w))))
    }

    /// A pair can collide unless all of its vertices belong to obstacles.
    ///
    /// `is_obstacle` has a flag for each vertex. Vertices without a flag do not belong to
    /// obstacles.
    #[must_use]
    pub fn not_two_obstacles(is_obstacle: Vec<bool>) -> Self {
        let flag = move |vertex: &u32| is_obstacle.get(*vertex as usize).copied().unwrap_or(false);
        Self::new(move |a, b| !a.iter().chain(b).all(&flag))
    }

    /// A pair can collide unless all of its vertices belong to the same group.
    ///
    /// `groups` has a number for each vertex. A vertex without a number is a group of its own.
    #[must_use]
    pub fn different_groups(groups: Vec<u32>) -> Self {
        Self::any_vertices(
            move |v, w| match (groups.get(v as usize), groups.get(w as usize)) {
                (Some(a), Some(b)) => a != b,
                _ => v != w,
            },
        )
    }

    /// A pair can collide if the matrix allows the groups of any vertex of the first primitive and of any
    /// vertex of the second.
    ///
    /// `groups` has a number for each vertex. A vertex without a number can collide with every other. The
    /// diagonal of the matrix is the pairs of a group with itself.
    ///
    /// # Errors
    /// [`GroupError::NoSuchGroup`] if the matrix lacks the group of a vertex.
    pub fn by_groups(groups: Vec<u32>, matrix: GroupMatrix) -> Result<Self, GroupError> {
        matrix.check(&groups)?;
        Ok(Self::any_vertices(move |v, w| {
            match (groups.get(v as usize), groups.get(w as usize)) {
                (Some(&a), Some(&b)) => matrix.allows(a, b),
                _ => true,
            }
        }))
    }

    /// The same predicate, and only primitives all of whose vertices take part can collide.
    ///
    /// `takes_part` has a flag for each vertex. Vertices without a flag take part. The broad phase
    /// leaves out all other primitives, such as the vertices inside a solid. A second call replaces
    /// the flags of the first.
    #[must_use]
    pub fn among(self, takes_part: Vec<bool>) -> Self {
        Self {
            takes_part: Some(takes_part.into()),
            ..self
        }
    }

    /// Returns true if two primitives, given by their vertices, can collide.
    #[must_use]
    pub fn allows(&self, a: &[u32], b: &[u32]) -> bool {
        self.takes_part(a) && self.takes_part(b) && self.predicate.as_ref().is_none_or(|rule| rule(a, b))
    }

    /// Returns true if the primitives of a pair have no common vertex, and can collide.
    #[inline]
    pub(crate) fn allows_pair<K: PairKind>(&self, vertices: &K::Vertices) -> bool {
        let (a, b) = vertices.as_ref().split_at(K::FIRST);
        K::are_apart(vertices) && (self.is_all() || self.allows(a, b))
    }

    /// Returns true if all pairs can collide.
    #[inline]
    #[must_use]
    pub fn is_all(&self) -> bool {
        self.predicate.is_none() && self.takes_part.is_none()
    }

    /// Returns true if a predicate restricts the pairs of the primitives that take part.
    pub(crate) fn has_predicate(&self) -> bool {
        self.predicate.is_some()
    }

    /// Returns true if a primitive, given by its vertices, can collide with any other.
    pub(crate) fn takes_part(&self, vertices: &[u32]) -> bool {
        self.takes_part.as_deref().is_none_or(|flags| {
            let flag = |vertex: &u32| flags.get(*vertex as usize).copied().unwrap_or(true);
            vertices.iter().all(flag)
        })
    }
}

impl fmt::Debug for CanCollide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CanCollide")
            .field("has_predicate", &self.predicate.is_some())
            .field("takes_part", &self.takes_part)
            .finish()
    }
}

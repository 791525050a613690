//! Self-intersections of a mesh at rest.

use std::cmp::Ordering::{Equal, Greater, Less};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use exact_ccd::Point;
use exact_ccd::predicates::{EdgeFace, orient3d};

use crate::broad_phase::{BroadPhase, PairCollector, PairSink, TooManyPrimitives, check_primitive_count};
use crate::mesh::{PositionsError, TriangleMesh, check_positions};
use crate::overlaps::{Primitives, StepBoxes};
use crate::pairs::{CanCollide, PrimitiveSet};
use crate::steps::{Step, StepError};

/// An edge and a face that have a common point and share no vertex. Ordered by the edge, then by
/// the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Intersection {
    /// The index of the edge in [`TriangleMesh::edges`].
    pub edge: u32,
    /// The index of the face in [`TriangleMesh::faces`].
    pub face: u32,
}

impl Intersection {
    /// The ends of the edge, and the corners of the face; `None` if the mesh does not have both.
    #[must_use]
    pub fn vertices(&self, mesh: &TriangleMesh) -> Option<([u32; 2], [u32; 3])> {
        let ends = mesh.edges().get(self.edge as usize)?;
        Some((*ends, *mesh.faces().get(self.face as usize)?))
    }

    /// The error of a step that begins with this crossing; the vertices are 0 if the mesh does not have both.
    #[must_use]
    pub fn crossing(&self, mesh: &TriangleMesh) -> StepError {
        let &Self { edge, face } = self;
        let (ends, corners) = self.vertices(mesh).unwrap_or_default();
        StepError::Crossing {
            edge,
            ends,
            face,
            corners,
        }
    }
}

/// The reason why a mesh cannot be searched for intersections.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IntersectionsError {
    /// The positions do not fit the mesh.
    #[error(transparent)]
    Positions(#[from] PositionsError),
    /// The mesh is too large.
    #[error(transparent)]
    TooManyPrimitives(#[from] TooManyPrimitives),
}

/// Positions at rest are those at the start of a step.
impl From<IntersectionsError> for StepError {
    fn from(error: IntersectionsError) -> Self {
        match error {
            IntersectionsError::Positions(error) => Self::Start(error),
            IntersectionsError::TooManyPrimitives(error) => error.into(),
        }
    }
}

/// The way in which an edge and a face without a common vertex meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Meeting {
    /// They have a common point. Exact, by [`EdgeFace::intersects`]: both are closed, and touching counts.
    ///
    /// For two faces, this and the contacts at rest of a [`Step`](crate::Step) say all:
    ///
    /// - *No common vertex*: the faces meet if and only if an edge of one meets the other.
    /// - *One common vertex* v: they have a point other than v in common if and only if the side opposite
    ///   to v of one of them meets the other. From v through a common point, a ray leaves one of the
    ///   faces first, there is a common point too, and a face that contains v is left on the side opposite
    ///   to v.
    /// - *Two common vertices* p, q, and third vertices a, b: faces with an area have a point outside of
    ///   the edge p q in common if and only if the fold is closed, that is, a and b lie in one plane with p
    ///   and q, on the same side of their line. There is no pair without a common vertex then, but a
    ///   contact at rest: let the angle of the first face be the larger one at p. If it is so at q, then b
    ///   lies in the first face; otherwise the ray from p through b leaves the first face on its side q a,
    ///   before b, and the edges p b and q a cross. Without a closed fold, none of these four pairs
    ///   touches.
    ///
    /// So the mesh has no two faces with more in common than their vertices and edges, if there are neither
    /// intersections nor contacts at t = 0. [`Audit`](crate::Audit) examines both.
    #[default]
    Touching,
    /// The edge passes through the face: its ends are on different sides of the plane of the face, and it
    /// meets the plane in the interior of the face.
    ///
    /// An edge that meets a face without passing through it has an end in the face, or a point in common with
    /// a side of it: one end is in the plane, or the edge meets the plane in a side, or both ends are in the
    /// plane, or the face has no area. Then a vertex touches a face, or two edges touch, and that is a
    /// contact at t = 0 of any step that begins here. So crossings, and the contacts of a step, are all that
    /// [`Touching`](Self::Touching) and the step find, in less time: most pairs are decided by the sides
    /// alone.
    Crossing,
}

/// Options of [`intersections`]: the default is all pairs that touch.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct IntersectionOptions {
    /// The way in which the pairs meet.
    pub meeting: Meeting,
    /// The pairs that can collide: the predicate has the ends of the edge, then the corners of the face.
    pub can_collide: CanCollide,
}

impl IntersectionOptions {
    /// The same options for another way to meet.
    #[must_use]
    pub fn with_meeting(self, meeting: Meeting) -> Self {
        Self { meeting, ..self }
    }

    /// The same options with another predicate.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }
}

/// All pairs of an edge and a face that meet and share no vertex, sorted. If the broad phase ends its search
/// early, the result is incomplete.
///
/// ```
/// use exact_ccd_mesh::{Bvh, Intersection, IntersectionOptions, Meeting, TriangleMesh, intersections};
///
/// // Two sides of the second face pass through the first face, or its tip touches it.
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let above = |z: f64| [floor, [[1.0, 1.0, z], [1.0, 2.0, z + 1.0], [2.0, 1.0, z + 1.0]]].concat();
/// let touching = IntersectionOptions::default();
/// let found = intersections(&mesh, &above(-0.5), &Bvh, &touching)?;
/// assert_eq!(found, [Intersection { edge: 3, face: 0 }, Intersection { edge: 4, face: 0 }]);
/// assert_eq!((mesh.edges()[3], mesh.edges()[4]), ([3, 4], [3, 5]));
///
/// let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
/// assert_eq!(intersections(&mesh, &above(-0.5), &Bvh, &crossing)?, found);
/// assert_eq!(intersections(&mesh, &above(0.0), &Bvh, &touching)?, found);
/// assert_eq!(intersections(&mesh, &above(0.0), &Bvh, &crossing)?, []);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IntersectionsError`] names the positions that are too many, too few or not finite.
pub fn intersections(
    mesh: &TriangleMesh,
    positions: &[Point],
    broad_phase: &dyn BroadPhase,
    options: &IntersectionOptions,
) -> Result<Vec<Intersection>, IntersectionsError> {
    let (step, primitives) = at_rest(mesh, positions, options)?;
    Ok(intersections_at_start(&step, &primitives, broad_phase, options))
}

/// Returns true if a pair of [`intersections`] counts. Pairs are given to `counts` in no order, by several
/// threads, and the search ends with the first that does.
///
/// # Errors
/// As [`intersections`].
pub fn has_intersections(
    mesh: &TriangleMesh,
    positions: &[Point],
    broad_phase: &dyn BroadPhase,
    options: &IntersectionOptions,
    counts: &(dyn Fn(Intersection) -> bool + Sync),
) -> Result<bool, IntersectionsError> {
    let (step, primitives) = at_rest(mesh, positions, options)?;
    let is_found = AtomicBool::new(false);
    search(&step, &primitives, broad_phase, options, &|pairs| {
        let is_one = pairs
            .iter()
            .any(|&[edge, face]| counts(Intersection { edge, face }));
        if is_found.fetch_or(is_one, Ordering::Relaxed) || is_one {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    Ok(is_found.into_inner())
}

/// The step in which all vertices stay, and the primitives, which have begun it.
fn at_rest<'a>(
    mesh: &'a TriangleMesh,
    positions: &'a [Point],
    options: &IntersectionOptions,
) -> Result<(Step<'a>, Primitives), IntersectionsError> {
    for count in [mesh.edges().len(), mesh.faces().len()] {
        check_primitive_count(count)?;
    }
    check_positions(mesh.vertex_count(), positions)?;
    let step = Step::at_rest(mesh, positions);
    let mut primitives = Primitives::default();
    primitives.begin(&step, &options.can_collide);
    Ok((step, primitives))
}

/// The [`intersections`] at the start of a step, of primitives that have begun it.
pub(super) fn intersections_at_start(
    step: &Step<'_>,
    primitives: &Primitives,
    broad_phase: &dyn BroadPhase,
    options: &IntersectionOptions,
) -> Vec<Intersection> {
    let collector = PairCollector::default();
    search(step, primitives, broad_phase, options, &|pairs| {
        collector.add(pairs.iter().copied())
    });
    let pairs = collector.into_sorted().into_iter();
    pairs.map(|[edge, face]| Intersection { edge, face }).collect()
}

/// Gives the pairs of an edge and a face that meet and share no vertex to a sink.
fn search(
    step: &Step<'_>,
    primitives: &Primitives,
    broad_phase: &dyn BroadPhase,
    options: &IntersectionOptions,
    sink: &PairSink<'_>,
) {
    let (mesh, [positions, _]) = (step.mesh(), step.positions());
    let (edges, faces) = (mesh.edges(), mesh.faces());
    let point = |vertex: u32| positions[vertex as usize];
    let do_meet = |ends: [Point; 2], corners: [Point; 3]| match options.meeting {
        // All positions are finite.
        Meeting::Touching => EdgeFace::new(ends, corners).is_ok_and(|pair| pair.intersects()),
        Meeting::Crossing => crosses(ends, corners),
    };
    // Another broad phase may pass pairs on that are none.
    let meet = |&[edge, face]: &[u32; 2]| {
        let pair = edges.get(edge as usize).zip(faces.get(face as usize));
        pair.is_some_and(|(&ends, &corners)| {
            ends.iter().all(|end| !corners.contains(end))
                && options.can_collide.allows(&ends, &corners)
                && do_meet(ends.map(point), corners.map(point))
        })
    };
    // All on threads of the pool: entering it from outside costs a context switch each time.
    let _ = rayon::scope(|_| {
        let mut boxes = StepBoxes::<1>::default();
        let sets = [PrimitiveSet::Edges, PrimitiveSet::Faces];
        boxes.place_sets(step, primitives, 0.0, sets);
        let [of_edges, of_faces] = sets.map(|set| boxes.get(set));
        broad_phase.between(of_edges, of_faces, &|pairs| {
            let pairs: Vec<_> = pairs.iter().copied().filter(meet).collect();
            sink(&pairs)
        })
    });
}

/// Returns true if an edge passes through the interior of a face.
///
/// If its ends are on different sides, the line of the edge meets the plane in one point, between them. The
/// barycentric coordinates of that point are proportional to the volumes that the edge spans with the sides.
fn crosses([a, b]: [Point; 2], [v1, v2, v3]: [Point; 3]) -> bool {
    // All positions are finite, so that every sign is known. An unknown sign would count as in the plane.
    let side = |points| orient3d(points).unwrap_or(Equal);
    let ends_are_apart = match side([v1, v2, v3, a]) {
        Less => side([v1, v2, v3, b]) == Greater,
        Greater => side([v1, v2, v3, b]) == Less,
        Equal => false,
    };
    ends_are_apart && {
        let first = side([a, b, v1, v2]);
        first != Equal && side([a, b, v2, v3]) == first && side([a, b, v3, v1]) == first
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges through the points of a grid. An edge crosses the face if its ends are on both sides, and its
    /// point of the grid is inside.
    #[test]
    fn an_edge_crosses_inside_of_the_face_only() {
        let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let turned = [face[0], face[2], face[1]];
        for (x, y) in (-1..6).flat_map(|x| (-1..6).map(move |y| (x, y))) {
            let is_inside = x > 0 && y > 0 && x + y < 4;
            let at = |z: f64| [f64::from(x), f64::from(y), z];
            for face in [face, turned] {
                for ends in [[1.0, -1.0], [-1.0, 2.0]] {
                    assert_eq!(crosses(ends.map(at), face), is_inside, "{x} {y}");
                }
                for ends in [
                    [1.0, 2.0],
                    [-1.0, -2.0],
                    [0.0, 1.0],
                    [-1.0, 0.0],
                    [1.0, 0.0],
                    [0.0, -1.0],
                ] {
                    assert!(!crosses(ends.map(at), face), "{x} {y} {ends:?}");
                }
            }
        }
    }
}

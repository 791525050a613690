//! Self-intersections of a mesh at rest.

use std::cmp::Ordering::{Equal, Greater, Less};

use exact_ccd::Point;
use exact_ccd::predicates::{EdgeFace, orient3d};
use rayon::prelude::*;

use crate::broad_phase::{Aabb, Boxes, BroadPhase, Bvh, PairCollector, TooManyPrimitives};
use crate::mesh::{PositionsError, TriangleMesh, check_positions};
use crate::pairs::CanCollide;
use crate::steps::StepError;

/// An edge and a face that have a common point and share no vertex. Ordered by the edge, then by
/// the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Intersection {
    /// The index of the edge in [`TriangleMesh::edges`].
    pub edge: u32,
    /// The index of the face in [`TriangleMesh::faces`].
    pub face: u32,
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

/// All pairs of an edge and a face that have a common point and share no vertex, sorted.
///
/// Exact, by [`EdgeFace::intersects`]: edges and faces are closed, and touching counts. For two faces,
/// this and the contacts at rest of a [`Step`](crate::Step) say all:
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
///
/// ```
/// use exact_ccd_mesh::{Intersection, TriangleMesh, intersections};
///
/// // Two sides of the second face pass through the first face.
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let wall = |x: f64| [[x, 1.0, -1.0], [x, 1.0, 1.0], [x + 4.0, 1.0, 1.0]];
/// let found = intersections(&mesh, &[floor, wall(1.0)].concat())?;
/// assert_eq!(found, [Intersection { edge: 3, face: 0 }, Intersection { edge: 4, face: 0 }]);
/// assert_eq!((mesh.edges()[3], mesh.edges()[4]), ([3, 4], [3, 5]));
/// assert_eq!(intersections(&mesh, &[floor, wall(8.0)].concat())?, []);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IntersectionsError`] names the positions that are too many, too few or not finite.
pub fn intersections(
    mesh: &TriangleMesh,
    positions: &[Point],
) -> Result<Vec<Intersection>, IntersectionsError> {
    intersections_among(mesh, positions, &CanCollide::all())
}

/// The same, of the pairs that can collide: the predicate has the ends of the edge, then the corners of the
/// face.
///
/// # Errors
/// As [`intersections`].
pub fn intersections_among(
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
) -> Result<Vec<Intersection>, IntersectionsError> {
    intersections_by(&Bvh, mesh, positions, can_collide)
}

/// The same, among the pairs that a broad phase finds. If it ends its search early, the result is of no use.
///
/// # Errors
/// As [`intersections`].
pub fn intersections_by(
    broad_phase: &impl BroadPhase,
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
) -> Result<Vec<Intersection>, IntersectionsError> {
    search(broad_phase, mesh, positions, can_collide, |edge, face| {
        // All positions are finite.
        EdgeFace::new(edge, face).is_ok_and(|pair| pair.intersects())
    })
}

/// All pairs of an edge and a face that share no vertex and can collide, if the edge passes through the
/// face: its ends are on different sides of the plane of the face, and it meets the plane in the interior of
/// the face.
///
/// An edge that meets a face without passing through it has an end in the face, or a point in common with a
/// side of it: one end is in the plane, or the edge meets the plane in a side, or both ends are in the
/// plane, or the face has no area. Then a vertex touches a face, or two edges touch, and that is a contact
/// at t = 0 of any step that begins here. So crossings, and the contacts of a step, are all that
/// [`intersections`] and the step find, in less time: most pairs are decided by the sides alone.
///
/// ```
/// use exact_ccd_mesh::{CanCollide, Intersection, TriangleMesh, crossings};
///
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let above = |z: f64| [[1.0, 1.0, z], [1.0, 2.0, z + 1.0], [2.0, 1.0, z + 1.0]];
/// let found = crossings(&mesh, &[floor, above(-0.5)].concat(), &CanCollide::all())?;
/// assert_eq!(found, [Intersection { edge: 3, face: 0 }, Intersection { edge: 4, face: 0 }]);
/// // The tip touches the floor.
/// assert_eq!(crossings(&mesh, &[floor, above(0.0)].concat(), &CanCollide::all())?, []);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`intersections`].
pub fn crossings(
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
) -> Result<Vec<Intersection>, IntersectionsError> {
    crossings_by(&Bvh, mesh, positions, can_collide)
}

/// The same, among the pairs that a broad phase finds. If it ends its search early, the result is of no use.
///
/// # Errors
/// As [`intersections`].
pub fn crossings_by(
    broad_phase: &impl BroadPhase,
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
) -> Result<Vec<Intersection>, IntersectionsError> {
    search(broad_phase, mesh, positions, can_collide, crosses)
}

/// Returns true if an edge passes through the interior of a face.
///
/// If its ends are on different sides, the line of the edge meets the plane in one point, between them. The
/// barycentric coordinates of that point are proportional to the volumes that the edge spans with the sides.
fn crosses([a, b]: [Point; 2], [v1, v2, v3]: [Point; 3]) -> bool {
    // All positions are finite; a sign that is not known is that of no side.
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

/// The pairs that can collide and meet, sorted.
fn search(
    broad_phase: &impl BroadPhase,
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
    do_meet: impl Fn([Point; 2], [Point; 3]) -> bool + Sync,
) -> Result<Vec<Intersection>, IntersectionsError> {
    check_positions(mesh.vertex_count(), positions)?;
    let (edges, faces) = (mesh.edges(), mesh.faces());
    let point = |vertex: u32| positions[vertex as usize];
    let meet = |&[edge, face]: &[u32; 2]| {
        let (ends, corners) = (edges[edge as usize], faces[face as usize]);
        ends.iter().all(|end| !corners.contains(end))
            && can_collide.allows(&ends, &corners)
            && do_meet(ends.map(point), corners.map(point))
    };
    let around = |vertices: &[u32]| -> [Aabb; 1] { [vertices.iter().map(|&vertex| point(vertex)).collect()] };
    let edge_boxes: Vec<_> = edges.par_iter().map(|edge| around(edge)).collect();
    let face_boxes: Vec<_> = faces.par_iter().map(|face| around(face)).collect();
    let collector = PairCollector::default();
    let _ = broad_phase.between(&Boxes::new(&edge_boxes)?, &Boxes::new(&face_boxes)?, &|pairs| {
        collector.add(pairs.iter().copied().filter(meet))
    });
    let pairs = collector.into_sorted().into_iter();
    Ok(pairs.map(|[edge, face]| Intersection { edge, face }).collect())
}

//! Components inside of closed ones, which no contact reports.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::collections::BTreeMap;

use exact_ccd::Point;
use exact_ccd::predicates::orient3d;

use super::intersections::IntersectionsError;
use crate::broad_phase::{Aabb, BoxPairs, Boxes, Bvh, PairCollector};
use crate::mesh::{TriangleMesh, check_positions};
use crate::pairs::CanCollide;

/// A component inside of a closed one. Each has the least of its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Enclosed {
    /// The component inside: its least vertex lies inside.
    pub inner: u32,
    /// The closed component around it.
    pub outer: u32,
}

/// The [components](TriangleMesh::components) with an edge whose least vertex lies inside of a closed
/// component, sorted. A component is closed if each edge of its faces has an even number of faces.
///
/// Surfaces one of which is inside of the other do not touch, and a motion that is free of contact keeps them
/// so. A point is inside if a ray from it meets the faces an odd number of times, which exact predicates
/// decide. Where the vertex touches a face of the closed component, that is a contact, and the pair is left
/// out here.
///
/// ```
/// use exact_ccd_mesh::{CanCollide, Enclosed, TriangleMesh, enclosed};
///
/// // A tetrahedron in another one.
/// let faces = |v: u32| [[v, v + 2, v + 1], [v, v + 1, v + 3], [v + 1, v + 2, v + 3], [v + 2, v, v + 3]];
/// let mesh = TriangleMesh::new(8, [faces(0), faces(4)].concat())?;
/// let corners = |low: f64, high: f64| {
///     [[low, low, low], [high, low, low], [low, high, low], [low, low, high]]
/// };
/// let positions = [corners(0.0, 8.0), corners(1.0, 2.0)].concat();
/// let found = enclosed(&mesh, &positions, &CanCollide::all())?;
/// assert_eq!(found, [Enclosed { inner: 4, outer: 0 }]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IntersectionsError`] names the positions that are too many, too few or not finite.
pub fn enclosed(
    mesh: &TriangleMesh,
    positions: &[Point],
    can_collide: &CanCollide,
) -> Result<Vec<Enclosed>, IntersectionsError> {
    check_positions(mesh.vertex_count(), positions)?;
    let components = mesh.components();
    let at = |vertex: u32| positions[vertex as usize];
    // First by boxes alone: those of closed components, and the least vertices.
    let around = closed_boxes(mesh, &components, positions);
    let outer: Vec<u32> = around.keys().copied().collect();
    let mut inner: Vec<u32> = mesh
        .edges()
        .iter()
        .map(|edge| components[edge[0] as usize])
        .collect();
    inner.sort_unstable();
    inner.dedup();
    let origin = around
        .values()
        .fold(Aabb::EMPTY, |all, part| all.union(part))
        .center();
    let pairs = PairCollector::default();
    let boxes = |boxes: Vec<[Aabb; 1]>| Boxes::relative_to(&boxes, &[origin]);
    let points = boxes(inner.iter().map(|&vertex| [Aabb::of(at(vertex))]).collect())?;
    let _ = Bvh.between(
        &points,
        &boxes(around.values().map(|part| [*part]).collect())?,
        &|found| {
            let found = found
                .iter()
                .map(|&[point, part]| [inner[point as usize], outer[part as usize]]);
            pairs.add(found.filter(|[vertex, part]| vertex != part && around[part].contains(&at(*vertex))))
        },
    );
    let near = pairs.into_sorted();
    if near.is_empty() {
        return Ok(Vec::new());
    }

    // The rays in the direction of x from these vertices, and the faces of these components.
    let mut starts: Vec<u32> = near.iter().map(|&[vertex, _]| vertex).collect();
    starts.dedup();
    let mut parts: Vec<u32> = near.iter().map(|&[_, part]| part).collect();
    parts.sort_unstable();
    parts.dedup();
    let is_of_part = |face: &&[u32; 3]| parts.binary_search(&components[face[0] as usize]).is_ok();
    let faces: Vec<[u32; 3]> = mesh.faces().iter().filter(is_of_part).copied().collect();
    let end = around
        .values()
        .fold(f64::MIN, |most, part| most.max(part.upper[0]));
    let ray = |&vertex: &u32| {
        let start = at(vertex);
        [Aabb::of(start).union(&Aabb::of([end, start[1], start[2]]))]
    };
    let of_face = |face: &[u32; 3]| [face.iter().map(|&corner| at(corner)).collect::<Aabb>()];
    let (rays, of_faces) = (
        boxes(starts.iter().map(ray).collect())?,
        boxes(faces.iter().map(of_face).collect())?,
    );
    let met = PairCollector::default();
    let _ = Bvh.between(&rays, &of_faces, &|found| {
        let meets = |&[ray, face]: &[u32; 2]| {
            let corners = faces[face as usize].map(at);
            ray_meets(at(starts[ray as usize]), corners) != Meets::Not
        };
        met.add(found.iter().copied().filter(meets))
    });
    let mut found = BTreeMap::new();
    for [ray, face] in met.into_sorted() {
        let (vertex, corners) = (starts[ray as usize], faces[face as usize]);
        let pair = Enclosed {
            inner: vertex,
            outer: components[corners[0] as usize],
        };
        let (is_odd, is_apart) = found.entry(pair).or_insert((false, true));
        *is_odd ^= true;
        *is_apart &= ray_meets(at(vertex), corners.map(at)) != Meets::AtItsStart;
    }
    let counts = |(pair, (is_odd, is_apart)): (Enclosed, (bool, bool))| {
        let is_allowed = can_collide.allows(&[pair.inner], &[pair.outer]);
        (pair.inner != pair.outer && is_odd && is_apart && is_allowed).then_some(pair)
    };
    Ok(found.into_iter().filter_map(counts).collect())
}

/// The boxes around the closed components, by their least vertices.
fn closed_boxes(mesh: &TriangleMesh, components: &[u32], positions: &[Point]) -> BTreeMap<u32, Aabb> {
    let mut is_open = vec![false; components.len()];
    for (edge, count) in mesh.edges().iter().zip(mesh.face_counts()) {
        // A loose edge takes no part in the surface.
        is_open[components[edge[0] as usize] as usize] |= count % 2 == 1;
    }
    let mut boxes: BTreeMap<u32, Aabb> = BTreeMap::new();
    for face in mesh.faces() {
        let component = components[face[0] as usize];
        if !is_open[component as usize] {
            let around = boxes.entry(component).or_insert(Aabb::EMPTY);
            *around = face.iter().fold(*around, |around, &corner| {
                around.union(&Aabb::of(positions[corner as usize]))
            });
        }
    }
    boxes
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Meets {
    Not,
    /// The start of the ray is a point of the face.
    AtItsStart,
    Beyond,
}

/// The way in which the ray from a point in the direction of x meets a face, exactly.
///
/// The ray starts from p + (0, ε, ε²) for all ε > 0 that are small enough. Seen along x, such a point is on
/// no line through two points, so it is inside or outside of the face there, and a closed surface is met as
/// often as any other ray meets it, modulo 2. If it is inside for all small ε, then p is in the closed face,
/// seen along x, and the face is not parallel to x: p is before its plane, behind it, or a point of the face.
fn ray_meets(p: Point, [a, b, c]: [Point; 3]) -> Meets {
    let first = turn(p, a, b);
    if first == Equal || turn(p, b, c) != first || turn(p, c, a) != first {
        return Meets::Not;
    }
    // All positions are finite. A face that turns counterclockwise, seen against x, turns clockwise as seen
    // from the points before it.
    match orient3d([a, b, c, p]).unwrap_or(Equal) {
        Equal => Meets::AtItsStart,
        side if side == first => Meets::Beyond,
        _ => Meets::Not,
    }
}

/// `Greater` if p + (ε, ε²), a and b turn counterclockwise in the plane of y and z, for all small ε > 0,
/// `Less` if they turn clockwise. `Equal` only if a and b are the same point there.
///
/// The orientation is (a_y − p_y − ε) (b_z − p_z − ε²) − (a_z − p_z − ε²) (b_y − p_y − ε). Its terms without
/// ε are the orientation of p, a and b, the factor of ε is a_z − b_z, that of ε² is b_y − a_y, and those of
/// ε³ cancel.
fn turn(p: Point, a: Point, b: Point) -> Ordering {
    let flat = |point: Point| [0.0, point[1], point[2]];
    // Seen from above the plane.
    let from_above = orient3d([flat(p), flat(a), flat(b), [1.0, p[1], p[2]]]).unwrap_or(Equal);
    let by_z = || a[2].partial_cmp(&b[2]).unwrap_or(Equal);
    let by_y = || b[1].partial_cmp(&a[1]).unwrap_or(Equal);
    match from_above {
        Less => Greater,
        Greater => Less,
        Equal => by_z().then_with(by_y),
    }
}

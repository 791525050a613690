//! The primitives that take part in the steps of a mesh, with near primitives side by side.

use std::collections::HashSet;
use std::sync::Arc;

use exact_ccd::Point;

use crate::broad_phase::{Aabb, Members, extent, order};
use crate::mesh::{TriangleMesh, sides};
use crate::pairs::{CanCollide, OtherEnds, PrimitiveSet, Searched};
use crate::steps::Step;

/// The primitives that take part in successive steps of one mesh. Primitives near each other at the start are
/// side by side. The order is kept until vertices that are side by side have moved apart.
#[derive(Clone, Debug, Default)]
pub(crate) struct Primitives {
    /// The primitives of each [`PrimitiveSet`].
    sets: [Arc<Members>; PrimitiveSet::COUNT],
    /// The other ends of the edges of each vertex, if there are loose edges.
    other_ends: Arc<OtherEnds>,
    /// The number of vertices of the mesh for which the order was made, if it was made.
    ordered: Option<usize>,
    /// The least extent of the vertices' order since it was made.
    extent: f64,
    /// A vertex amid many others at the start of the step.
    origin: Option<u32>,
    /// The usual distance from this vertex in the step.
    size: f64,
}

/// The primitives are ordered anew when the extent of the vertices' order has grown by this factor.
const MAX_GROWTH: f64 = 1.5;

/// The number of vertices from which the origin is chosen, at most.
const SAMPLE: usize = 64;

impl Primitives {
    pub(crate) fn get(&self, set: PrimitiveSet) -> &Arc<Members> {
        &self.sets[set as usize]
    }

    /// A vertex amid many others at the start of the step, even if some are far away.
    pub(crate) fn origin(&self) -> Option<u32> {
        self.origin
    }

    /// The usual distance of a vertex from the [`origin`](Self::origin) in the step, along an axis; 0 if
    /// most are in its place.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    pub(crate) fn other_ends(&self) -> &OtherEnds {
        &self.other_ends
    }

    /// Returns true if there are no pairs of a kind.
    pub(crate) fn lack<K: Searched>(&self) -> bool {
        K::SETS.iter().any(|&set| self.get(set).ids().is_empty())
    }

    /// Takes the next step, with the same predicate as before.
    pub(crate) fn begin(&mut self, step: &Step<'_>, can_collide: &CanCollide) {
        let [x0, _] = step.positions();
        let now = extent(x0, self.get(PrimitiveSet::Vertices).ids());
        if self.ordered != Some(x0.len()) || now > MAX_GROWTH * self.extent {
            *self = Self::new(step.mesh(), x0, can_collide);
        } else {
            self.extent = self.extent.min(now);
        }
        let vertices = self.get(PrimitiveSet::Vertices).ids();
        let origin = amid(vertices, x0);
        self.size = origin.map_or(0.0, |origin| usual_distance(vertices, origin, step));
        self.origin = origin;
    }

    fn new(mesh: &TriangleMesh, x: &[Point], can_collide: &CanCollide) -> Self {
        let ids = (0..x.len() as u32).filter(|&vertex| can_collide.takes_part(&[vertex]));
        let vertices = order(ids.collect(), |vertex| x[vertex as usize]);
        let faces = in_order(mesh.faces(), x, can_collide);
        let edges = in_order(mesh.edges(), x, can_collide);

        let other_ends = OtherEnds::new(mesh, &edges);
        let loose_vertices = among(&vertices, |vertex| other_ends.is_loose(vertex));
        let loose_edges = loose_edges(mesh, &edges, can_collide);
        let (ends, other_ends) = if loose_edges.is_empty() {
            Default::default()
        } else {
            (
                among(&vertices, |vertex| other_ends.is_end(mesh, vertex)),
                other_ends,
            )
        };

        let extent = extent(x, &vertices);
        let of_vertices = |ids| Members::new(ids, |vertex| [vertex]);
        let of_faces = |ids| Members::new(ids, |face| mesh.faces()[face as usize]);
        let of_edges = |ids| Members::new(ids, |edge| mesh.edges()[edge as usize]);
        // In the order of `PrimitiveSet`.
        let sets = [
            of_vertices(vertices),
            of_faces(faces),
            of_edges(edges),
            of_vertices(loose_vertices),
            of_vertices(ends),
            of_edges(loose_edges),
        ];
        Self {
            sets: sets.map(Arc::new),
            other_ends: Arc::new(other_ends),
            ordered: Some(x.len()),
            extent,
            origin: None,
            size: 0.0,
        }
    }
}

/// Some of the vertices.
fn sample(vertices: &[u32]) -> impl Iterator<Item = u32> {
    let stride = vertices.len().div_ceil(SAMPLE).max(1);
    vertices.iter().step_by(stride).copied()
}

/// Of a sample of some vertices, the one nearest to the median along each axis.
fn amid(vertices: &[u32], x: &[Point]) -> Option<u32> {
    let center: Point =
        core::array::from_fn(|axis| median(sample(vertices).map(|id| x[id as usize][axis]).collect()));
    let from_center = |id: u32| distance(x[id as usize], center);
    sample(vertices).min_by(|&a, &b| from_center(a).total_cmp(&from_center(b)))
}

/// Of a sample of some vertices, the median of the distances from a vertex at both ends of a step.
fn usual_distance(vertices: &[u32], origin: u32, step: &Step<'_>) -> f64 {
    let ends = step.positions();
    let of_sample = sample(vertices).filter(|&id| id != origin);
    let distances = of_sample.flat_map(|id| ends.map(|x| distance(x[id as usize], x[origin as usize])));
    median(distances.collect())
}

/// The greatest difference of two points along an axis.
fn distance(a: Point, b: Point) -> f64 {
    let axes = a.into_iter().zip(b);
    axes.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// The median of some numbers, 0 of none.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or_default()
}

/// The indices of the primitives that take part, with near primitives side by side.
fn in_order<const N: usize>(primitives: &[[u32; N]], x: &[Point], can_collide: &CanCollide) -> Vec<u32> {
    let taking_part = (0..)
        .zip(primitives)
        .filter(|(_, vertices)| can_collide.takes_part(*vertices));
    let center = |id: u32| {
        let corners = primitives[id as usize].map(|vertex| x[vertex as usize]);
        corners.into_iter().collect::<Aabb>().center()
    };
    order(taking_part.map(|(id, _)| id).collect(), center)
}

/// The chosen vertices, in their order.
fn among(vertices: &[u32], is_chosen: impl Fn(u32) -> bool) -> Vec<u32> {
    vertices
        .iter()
        .copied()
        .filter(|&vertex| is_chosen(vertex))
        .collect()
}

/// The edges among `edges` that belong to no face that takes part.
fn loose_edges(mesh: &TriangleMesh, edges: &[u32], can_collide: &CanCollide) -> Vec<u32> {
    let takes_part = |face: &&[u32; 3]| can_collide.takes_part(*face);
    let left_out = mesh.faces().iter().filter(|face| !takes_part(face));
    // Only edges of faces that are left out may lack a face.
    let mut lacking: HashSet<[u32; 2]> = left_out.flat_map(sides).collect();
    if !lacking.is_empty() {
        for side in mesh.faces().iter().filter(takes_part).flat_map(sides) {
            lacking.remove(&side);
        }
    }
    let first_loose = mesh.edges().len() - mesh.loose_edges().len();
    let is_loose =
        |&edge: &u32| edge as usize >= first_loose || lacking.contains(&mesh.edges()[edge as usize]);
    edges.iter().copied().filter(is_loose).collect()
}

//! The geometry of contact: the surfaces of all bodies, and the pairs of them that can touch.

use std::ops::Range;

use exact_ccd::{InvalidThickness, Thickness};
use exact_ccd_mesh::{
    Bvh, CanCollide, CandidateOptions, Candidates, MeshError, MinDistance, Point, Step, TriangleMesh,
};

use super::error::SystemError;
use super::obstacles::{contact_parts, obstacle_pairs};
use crate::energies::contact::{Barrier, Surface, Weights};
use crate::half_space::HalfSpace;
use crate::prescribed::Coordinates;
use crate::settings::Formulation;

/// The surfaces of bodies under construction.
#[derive(Default)]
pub(super) struct Outline {
    pub(super) faces: Vec<[u32; 3]>,
    /// The edges of rods.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) particles: Vec<u32>,
    /// The offset of each vertex, in m.
    pub(super) offsets: Vec<f64>,
    /// True for the vertices of obstacles.
    pub(super) is_obstacle: Vec<bool>,
}

/// The surfaces of all bodies, and the half spaces.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    /// The faces, rods and particles; and the vertices in the interior of solids, which take no part.
    pub(crate) mesh: TriangleMesh,
    /// The vertices of faces and rods, and particles, increasing, without the interior vertices of solids.
    pub(crate) vertices: Vec<u32>,
    /// The surface with these vertices only.
    pub(super) compact: TriangleMesh,
    pub(super) particles: Vec<u32>,
    /// The offset of the contact surface at each vertex, in m.
    pub(super) offsets: Vec<f64>,
    /// The sum of two offsets.
    pub(crate) min_distance: MinDistance,
    /// All pairs of surface primitives, except two of obstacles.
    pub(crate) can_collide: CanCollide,
    /// The pairs of obstacles whose relative positions can change. `None` if there are none.
    obstacle_pairs: Option<CanCollide>,
    /// True for the vertices of obstacles that no script moves.
    fixed: Vec<bool>,
    weights: Weights,
    pub(super) half_spaces: Vec<HalfSpace>,
    /// The vertices of the surfaces of all bodies but obstacles: half spaces are obstacles for them.
    pub(super) grounded: Vec<u32>,
}

impl Geometry {
    /// The geometry of an outline, from the vertices of each body, and the position at rest and the scripts
    /// of each vertex.
    pub(super) fn new(
        outline: Outline,
        bodies: &[Range<u32>],
        rest: &[Point],
        scripts: &[Coordinates],
    ) -> Result<Self, SystemError> {
        let Outline {
            faces,
            edges,
            particles,
            offsets,
            is_obstacle,
        } = outline;
        let mesh = TriangleMesh::with_edges(rest.len(), faces, &edges)?;
        let corners = mesh.faces().as_flattened().iter();
        let mut on_surface = vec![false; rest.len()];
        for &vertex in corners.chain(mesh.edges().as_flattened()).chain(&particles) {
            on_surface[vertex as usize] = true;
        }
        let all = 0..rest.len() as u32;
        let vertices: Vec<u32> = all.filter(|&vertex| on_surface[vertex as usize]).collect();
        let is_grounded = |&vertex: &u32| !is_obstacle[vertex as usize];
        let is_fixed = |(&is_obstacle, scripts): (&bool, &Coordinates)| is_obstacle && scripts.are_fixed();
        let parts = contact_parts(bodies, &is_obstacle, scripts);
        Ok(Self {
            min_distance: min_distance(&offsets)?,
            compact: compact(&mesh, &vertices)?,
            weights: Weights::new(&mesh, rest, &parts),
            grounded: vertices.iter().copied().filter(is_grounded).collect(),
            obstacle_pairs: obstacle_pairs(parts),
            fixed: is_obstacle.iter().zip(scripts).map(is_fixed).collect(),
            can_collide: CanCollide::not_two_obstacles(is_obstacle).among(on_surface),
            half_spaces: Vec::new(),
            mesh,
            vertices,
            particles,
            offsets,
        })
    }

    /// The pairs whose surfaces come within the activation distance of a barrier in a step, and some more.
    /// They touch where their distance is at most the sum of their offsets.
    pub(crate) fn near(&self, step: Step<'_>, barrier: &Barrier) -> Candidates {
        let options = CandidateOptions::default()
            .with_distance(barrier.activation_distance())
            .with_min_distance(self.min_distance.clone())
            .with_can_collide(self.can_collide.clone());
        Candidates::with_options(step, &Bvh, &options)
            .expect("the distance of a barrier is not below 0, and each vertex has an offset")
    }

    /// The same at rest. Positions that are not finite have none.
    pub(crate) fn near_at(&self, points: &[Point], barrier: &Barrier) -> Candidates {
        let rest = Step::new(&self.mesh, points, points);
        rest.map_or_else(|_| Candidates::default(), |step| self.near(step, barrier))
    }

    /// The pairs of two obstacles that can touch in a step. Pairs within one obstacle that moves as a whole,
    /// and pairs of obstacles that rest, are left out. The linear motion of a rigid body from one place to
    /// another is an affine map at each time. The map is injective but for a half turn: in the middle of it,
    /// the body is on one line.
    pub(crate) fn obstacle_pairs(&self, step: Step<'_>) -> Candidates {
        let Some(can_collide) = &self.obstacle_pairs else {
            return Candidates::default();
        };
        let options = CandidateOptions::default().with_can_collide(can_collide.clone());
        Candidates::with_options(step, &Bvh, &options).expect("the default distance is 0")
    }

    /// The surface on which contact acts, with the positions at rest.
    pub(super) fn surface<'a>(&'a self, rest: &'a [Point], formulation: Formulation) -> Surface<'a> {
        Surface {
            mesh: &self.mesh,
            rest,
            offsets: &self.offsets,
            half_spaces: &self.half_spaces,
            grounded: &self.grounded,
            fixed: &self.fixed,
            weights: (formulation == Formulation::Convergent).then_some(&self.weights),
        }
    }
}

/// A mesh with some of its vertices only, which are all of its corners.
fn compact(mesh: &TriangleMesh, vertices: &[u32]) -> Result<TriangleMesh, MeshError> {
    let index = |vertex: u32| vertices.partition_point(|&kept| kept < vertex) as u32;
    let faces = mesh.faces().iter().map(|face| face.map(index)).collect();
    let edges: Vec<[u32; 2]> = mesh.loose_edges().iter().map(|edge| edge.map(index)).collect();
    TriangleMesh::with_edges(vertices.len(), faces, &edges)
}

/// The sum of two offsets. Without offsets it is the distance of contact, which is decided faster.
fn min_distance(offsets: &[f64]) -> Result<MinDistance, InvalidThickness> {
    if offsets.iter().all(|&offset| offset == 0.0) {
        return Ok(MinDistance::default());
    }
    Ok(MinDistance::thickness(Thickness::new(offsets)?))
}

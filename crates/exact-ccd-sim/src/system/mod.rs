//! The bodies of a scene, as one list of vertices and lists of elements over it.

mod affine;
mod body_error;
mod designation;
mod error;
mod fingerprint;
mod loads;
mod masses;
mod materials;
mod names;
mod obstacles;
mod parts;
mod selection;
mod springs;

use std::ops::Range;
use std::sync::Arc;

use exact_ccd::{InvalidThickness, Thickness};
use exact_ccd_mesh::{
    Aabb, BoxKind, Bvh, CanCollide, CandidateOptions, Candidates, Frame, MeshError, MinDistance, Point,
    PositionsError, Step, TriangleMesh,
};
use nalgebra::Vector3;

use crate::body::Body;
use crate::carriers::Carriers;
use crate::contact::{Barrier, Part, Surface, Weights};
use crate::elasticity::Chain;
use crate::energy::Energy;
use crate::half_space::{HalfSpace, Plane};
use crate::load::Load;
use crate::scripted::{Coordinates, Scripted, Timed};
use crate::settings::Formulation;
use crate::spring::Spring;
use parts::Parts;

pub use body_error::{BodyError, Selecting};
pub use designation::Designation;
pub use error::SystemError;
pub use fingerprint::Fingerprint;

/// The vertices, masses, elements and scripts of a scene.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) start: Vec<Point>,
    pub(crate) velocities: Vec<Point>,
    pub(crate) masses: Vec<f64>,
    /// The elastic energies.
    pub(crate) elements: Vec<Arc<dyn Energy>>,
    /// The map from unknowns to vertices.
    pub(crate) carriers: Carriers,
    /// The parts of rods that resist twist.
    pub(crate) chains: Vec<Chain>,
    tetrahedra: Vec<[u32; 4]>,
    /// The hash of the materials, for the fingerprint.
    materials: String,
    /// The scripts of each vertex.
    pub(crate) scripts: Vec<Coordinates>,
    /// The faces, rods and particles; and the vertices in the interior of solids, which take no part.
    pub(crate) surface: TriangleMesh,
    /// The vertices of faces and rods, and particles, increasing: without those in the interior of solids.
    pub(crate) surface_vertices: Vec<u32>,
    /// The surface with these vertices only.
    compact_surface: TriangleMesh,
    particles: Vec<u32>,
    /// The offset of the contact surface at each vertex, in m.
    pub(crate) offsets: Vec<f64>,
    min_distance: MinDistance,
    /// All pairs of surface primitives, except two of obstacles.
    pub(crate) can_collide: CanCollide,
    /// The pairs of obstacles whose relative positions can change. `None` if there are none.
    obstacle_pairs: Option<CanCollide>,
    /// Σ E V over all elements, in J: the scale of the rounding errors of elastic energies.
    pub(crate) rigidity: f64,
    loads: Vec<Load>,
    springs: Vec<Spring>,
    half_spaces: Vec<HalfSpace>,
    /// The boundaries of the half spaces.
    planes: Vec<Plane>,
    /// The vertices of the surfaces of all bodies but obstacles: half spaces are obstacles for them.
    grounded: Vec<u32>,
    /// True for the vertices of obstacles that no script moves.
    fixed: Vec<bool>,
    weights: Weights,
    /// The name of each body.
    names: Vec<String>,
    /// The kind of each body.
    kinds: Vec<&'static str>,
    /// The vertices of each body.
    bodies: Vec<Range<u32>>,
    size: f64,
    extent: f64,
}

impl System {
    /// The system of some bodies. Its vertices are those of the bodies, in their order. `scripts` prescribe
    /// the motion of vertices; along each axis, the script of a vertex that began last applies, and the last
    /// of those that begin at the same time. Obstacles without a script are fixed.
    ///
    /// # Errors
    /// [`SystemError`] names the body or the script, unless it is about the mesh of all bodies.
    pub fn new(bodies: &[Body], scripts: &[Scripted]) -> Result<Self, SystemError> {
        let mut parts = Parts::default();
        for (place, body) in bodies.iter().enumerate() {
            parts.add(body).map_err(|source| SystemError::Body {
                body: Designation::among(bodies, place),
                source,
            })?;
        }
        let vertex_count = parts.start.len();
        let ranges = Self::ranges(bodies);
        let body_of = |vertex: u32| {
            let place = ranges.partition_point(|range| range.end <= vertex);
            Designation::among(bodies, place)
        };
        for (index, scripted) in scripts.iter().enumerate() {
            scripted.check().map_err(|source| SystemError::Motion {
                script: index,
                source,
            })?;
            let script = Timed::new(scripted);
            let what = Selecting::Script(index);
            for vertex in selection::unknowns(&parts.carriers, body_of, &scripted.vertices, what)? {
                let slot = parts.scripts.get_mut(vertex as usize);
                let slot = slot.ok_or(SystemError::Script {
                    script: index,
                    vertex,
                    vertex_count,
                })?;
                slot.add(scripted.axes, &script);
            }
        }
        let mesh = TriangleMesh::with_edges(vertex_count, parts.faces, &parts.edges)?;
        // A single point has no extent: 1 m.
        let extent = Some(diagonal(parts.start.iter().copied())).filter(|extent| *extent > 0.0);
        let extent = extent.unwrap_or(1.0);
        let elastic = parts.start.iter().zip(&parts.obstacle);
        let size = diagonal(
            elastic
                .filter(|(_, is_obstacle)| !**is_obstacle)
                .map(|(point, _)| *point),
        );
        let corners = mesh.faces().as_flattened().iter();
        let used = corners.chain(mesh.edges().as_flattened()).chain(&parts.particles);
        let mut on_surface = vec![false; vertex_count];
        for &vertex in used {
            on_surface[vertex as usize] = true;
        }
        let surface_vertices: Vec<u32> = (0..vertex_count as u32)
            .filter(|&vertex| on_surface[vertex as usize])
            .collect();
        let of_contact = contact_parts(&ranges, &parts.obstacle, &parts.scripts);
        let weights = Weights::new(&mesh, &parts.start, &of_contact);
        let is_fixed = |(&is_obstacle, scripts): (&bool, &Coordinates)| is_obstacle && scripts.are_fixed();
        let fixed: Vec<bool> = parts.obstacle.iter().zip(&parts.scripts).map(is_fixed).collect();
        let obstacles = obstacle_groups(&ranges, &of_contact, &fixed);
        let is_grounded = |&vertex: &u32| !parts.obstacle[vertex as usize];
        let grounded = surface_vertices.iter().copied().filter(is_grounded).collect();
        let min_distance = min_distance(&parts.offsets)?;
        let compact_surface = compact(&mesh, &surface_vertices)?;
        Ok(Self {
            obstacle_pairs: obstacle_pairs(obstacles),
            can_collide: CanCollide::not_two_obstacles(parts.obstacle).among(on_surface),
            surface: mesh,
            surface_vertices,
            compact_surface,
            particles: parts.particles,
            min_distance,
            offsets: parts.offsets,
            start: parts.start,
            velocities: parts.velocities,
            masses: parts.masses,
            elements: parts.elements,
            carriers: parts.carriers,
            chains: parts.chains,
            tetrahedra: parts.tetrahedra,
            materials: Fingerprint::materials(bodies),
            scripts: parts.scripts,
            rigidity: parts.rigidity,
            loads: Vec::new(),
            springs: Vec::new(),
            half_spaces: Vec::new(),
            planes: Vec::new(),
            grounded,
            fixed,
            weights,
            names: bodies.iter().map(|body| body.name.clone()).collect(),
            kinds: bodies.iter().map(|body| body.kind.name()).collect(),
            bodies: ranges,
            size: if size > 0.0 { size } else { extent },
            extent,
        })
    }

    /// The range of vertices of each body, in the order of the bodies. The last four of an affine body are
    /// its nodes.
    #[must_use]
    pub fn ranges(bodies: &[Body]) -> Vec<Range<u32>> {
        let mut end = 0;
        let range = |body: &Body| {
            let start = end;
            end += body.vertex_count() as u32;
            start..end
        };
        bodies.iter().map(range).collect()
    }

    /// The pairs whose surfaces come within the activation distance of a barrier in a step, and some more.
    /// They touch where their distance is at most the sum of their offsets.
    pub(crate) fn near(&self, step: Step<'_>, barrier: &Barrier) -> Candidates {
        let options = CandidateOptions::default()
            .with_distance(barrier.activation_distance())
            .with_min_distance(self.min_distance.clone())
            .with_boxes(BoxKind::Moving)
            .with_can_collide(self.can_collide.clone());
        Candidates::with_options(step, &Bvh, &options)
            .expect("the distance of a barrier is not below 0, and each vertex has an offset")
    }

    /// The pairs of two obstacles that can touch in a step. Pairs within one obstacle that moves as a whole
    /// are left out, and so are those of obstacles that rest: their relative positions do not change, because
    /// linear motions between rigid ones are affine.
    pub(crate) fn obstacle_pairs(&self, step: Step<'_>) -> Candidates {
        let Some(can_collide) = &self.obstacle_pairs else {
            return Candidates::default();
        };
        let options = CandidateOptions::default()
            .with_boxes(BoxKind::Moving)
            .with_can_collide(can_collide.clone());
        Candidates::with_options(step, &Bvh, &options).expect("the default distance is 0")
    }

    /// The distance within which two primitives touch: the sum of their offsets.
    #[must_use]
    pub fn min_distance(&self) -> &MinDistance {
        &self.min_distance
    }

    /// Returns true if a body has an offset.
    #[must_use]
    pub fn is_thick(&self) -> bool {
        self.offsets.iter().any(|&offset| offset > 0.0)
    }

    /// The surface on which contact acts.
    pub(crate) fn contact_surface(&self, formulation: Formulation) -> Surface<'_> {
        Surface {
            mesh: &self.surface,
            rest: &self.start,
            offsets: &self.offsets,
            half_spaces: &self.planes,
            grounded: &self.grounded,
            fixed: &self.fixed,
            weights: (formulation == Formulation::Convergent).then_some(&self.weights),
        }
    }

    /// The faces and rods of all bodies. Its loose vertices are particles, and vertices in the interior of
    /// solids.
    #[must_use]
    pub fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// The vertices that are particles, increasing.
    #[must_use]
    pub fn particles(&self) -> &[u32] {
        &self.particles
    }

    /// The corners of all tetrahedra, ordered so that the volume at the start is positive.
    #[must_use]
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.tetrahedra
    }

    /// The surface, for these positions of all vertices of the system: faces, rods and particles. It has no
    /// vertices in the interior of solids.
    ///
    /// # Errors
    /// [`PositionsError`], if a coordinate is not finite or there are too few positions.
    pub fn surface_frame(&self, positions: &[Point]) -> Result<Frame, PositionsError> {
        let at = |&vertex: &u32| positions.get(vertex as usize).copied();
        let frame = Frame {
            positions: self.surface_vertices.iter().filter_map(at).collect(),
            mesh: self.compact_surface.clone(),
        };
        frame.check()?;
        Ok(frame)
    }

    /// The vertices of [`System::surface_frame`] of each body, with its name, or with `body-N` for the Nth
    /// body if it has none. They cover all vertices.
    #[must_use]
    pub fn surface_bodies(&self) -> Vec<(String, Range<u32>)> {
        let place = |vertex: u32| self.surface_vertices.partition_point(|&kept| kept < vertex) as u32;
        let ranges = self.bodies.iter().map(|body| place(body.start)..place(body.end));
        self.body_names().into_iter().zip(ranges).collect()
    }

    /// The vertices of the system that are in [`System::surface_frame`], in its order.
    #[must_use]
    pub fn surface_vertices(&self) -> &[u32] {
        &self.surface_vertices
    }

    /// The offsets of the contact surface at the vertices of [`System::surface_frame`], in m.
    #[must_use]
    pub fn surface_offsets(&self) -> Vec<f64> {
        let vertices = self.surface_vertices.iter();
        vertices.map(|&vertex| self.offsets[vertex as usize]).collect()
    }

    /// The initial positions, in m. They are also the rest shape.
    #[must_use]
    pub fn start(&self) -> &[Point] {
        &self.start
    }

    /// The mass of each vertex, in kg. The vertices of obstacles have mass 0.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// The fingerprint of the system. The run time is proportional to the size of the system.
    #[must_use]
    pub fn fingerprint(&self) -> Fingerprint {
        Fingerprint::of(self)
    }

    /// The diagonal of the bounding box of all bodies with mass at the start, in m: the unit of relative
    /// lengths, as in *Incremental Potential Contact*. If that box is a point, or no body has mass, it is
    /// [`System::extent`].
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The diagonal of the bounding box of everything at the start, obstacles included, in m.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// The diagonals of the bounding boxes of the bodies at the start, in m.
    pub(crate) fn body_sizes(&self) -> impl Iterator<Item = f64> {
        let points = |range: &Range<u32>| self.start[range.start as usize..range.end as usize].iter();
        self.bodies
            .iter()
            .map(move |range| diagonal(points(range).copied()))
    }
}

/// The part of each vertex in contact.
fn contact_parts(bodies: &[Range<u32>], obstacle: &[bool], scripts: &[Coordinates]) -> Vec<Part> {
    let part = |range: &Range<u32>| {
        let vertices = range.start as usize..range.end as usize;
        let (obstacle, scripts) = (&obstacle[vertices.clone()], &scripts[vertices.clone()]);
        let part = if !obstacle.iter().all(|&is_obstacle| is_obstacle) {
            Part::Body
        } else if scripts.windows(2).all(|pair| pair[0] == pair[1])
            && scripts.first().is_none_or(Coordinates::are_rigid)
        {
            Part::Obstacle
        } else {
            Part::DeformingObstacle
        };
        std::iter::repeat_n(part, vertices.len())
    };
    bodies.iter().flat_map(part).collect()
}

/// For each vertex, the number of the rigid motion of its obstacle: 0 for those that rest. `None` for bodies,
/// and the largest number for obstacles that do not move as a whole.
fn obstacle_groups(bodies: &[Range<u32>], parts: &[Part], fixed: &[bool]) -> Vec<Option<u32>> {
    let group = |(number, range): (u32, &Range<u32>)| {
        let vertices = range.start as usize..range.end as usize;
        vertices.map(move |vertex| match parts[vertex] {
            Part::Body => None,
            Part::Obstacle if fixed[vertex] => Some(0),
            Part::Obstacle => Some(number),
            Part::DeformingObstacle => Some(u32::MAX),
        })
    };
    (1..).zip(bodies).flat_map(group).collect()
}

/// The pairs of obstacles of different groups, and those within obstacles that do not move as a whole. `None`
/// if there are none.
fn obstacle_pairs(groups: Vec<Option<u32>>) -> Option<CanCollide> {
    let first = groups.iter().flatten().next()?;
    if *first != u32::MAX && groups.iter().flatten().all(|group| group == first) {
        return None;
    }
    // A primitive belongs to one body.
    let group = move |primitive: &[u32]| primitive.first().and_then(|&vertex| groups[vertex as usize]);
    Some(CanCollide::new(move |a, b| match (group(a), group(b)) {
        (Some(a), Some(b)) => a != b || a == u32::MAX,
        _ => false,
    }))
}

/// The diagonal of the bounding box of points. 0 without points.
fn diagonal(points: impl Iterator<Item = Point>) -> f64 {
    let bounds: Aabb = points.collect();
    if bounds.lower[0] <= bounds.upper[0] {
        (Vector3::from(bounds.upper) - Vector3::from(bounds.lower)).norm()
    } else {
        0.0
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

//! The bodies of a scene, as one list of vertices and lists of elements over it.

mod error;
mod fingerprint;
mod parts;

use std::ops::Range;

use exact_ccd_mesh::{
    Aabb, BoxKind, Bvh, CanCollide, CandidateOptions, Candidates, Frame, FrameError, Point, Step,
    TriangleMesh,
};
use nalgebra::Vector3;

use crate::body::Body;
use crate::contact::Barrier;
use crate::elasticity::Elastic;
use crate::script::Script;
use parts::Parts;

pub use error::SystemError;
pub use fingerprint::Fingerprint;

/// The vertices, masses, elements and scripts of a scene.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) start: Vec<Point>,
    pub(crate) velocities: Vec<Point>,
    pub(crate) masses: Vec<f64>,
    pub(crate) elements: Vec<Elastic>,
    /// The script of each vertex that has one.
    pub(crate) scripts: Vec<Option<Script>>,
    pub(crate) surface: TriangleMesh,
    /// The vertices of faces, increasing: without those in the interior of solids.
    pub(crate) surface_vertices: Vec<u32>,
    /// All pairs of surface primitives, except two of obstacles.
    pub(crate) can_collide: CanCollide,
    /// Σ E V over all elements, in J: the scale of the rounding errors of elastic energies.
    pub(crate) rigidity: f64,
    size: f64,
}

impl System {
    /// The system of some bodies. Its vertices are those of the bodies, in their order. `scripts` prescribe
    /// the motion of vertices; the last script of a vertex applies. Obstacles without a script are fixed.
    ///
    /// # Errors
    /// [`SystemError`] names the body or the script.
    pub fn new(bodies: &[Body], scripts: &[(Vec<u32>, Script)]) -> Result<Self, SystemError> {
        let mut parts = Parts::default();
        for (index, body) in bodies.iter().enumerate() {
            parts.add(index, body)?;
        }
        let vertex_count = parts.start.len();
        for (index, (vertices, script)) in scripts.iter().enumerate() {
            script.check().map_err(|source| SystemError::Motion {
                script: index,
                source,
            })?;
            for &vertex in vertices {
                let slot = parts.scripts.get_mut(vertex as usize);
                *slot.ok_or(SystemError::Script { vertex, vertex_count })? = Some(*script);
            }
        }
        let mesh = TriangleMesh::new(vertex_count, parts.faces)?;
        let bounds: Aabb = parts.start.iter().copied().collect();
        let size = if vertex_count == 0 {
            1.0
        } else {
            (Vector3::from(bounds.upper) - Vector3::from(bounds.lower)).norm()
        };
        let (_, surface_vertices) = mesh.without_loose_vertices();
        let mut on_surface = vec![false; vertex_count];
        for &vertex in &surface_vertices {
            on_surface[vertex as usize] = true;
        }
        Ok(Self {
            can_collide: CanCollide::not_two_obstacles(parts.obstacle).among(on_surface),
            surface: mesh,
            surface_vertices,
            start: parts.start,
            velocities: parts.velocities,
            masses: parts.masses,
            elements: parts.elements,
            scripts: parts.scripts,
            rigidity: parts.rigidity,
            size,
        })
    }

    /// The range of vertices of each body, in the order of the bodies.
    #[must_use]
    pub fn ranges(bodies: &[Body]) -> Vec<Range<u32>> {
        let mut end = 0;
        let range = |body: &Body| {
            let start = end;
            end += body.points.len() as u32;
            start..end
        };
        bodies.iter().map(range).collect()
    }

    /// The pairs that come within the activation distance of a barrier in a step, and some more.
    pub(crate) fn near(&self, step: Step<'_>, barrier: &Barrier) -> Candidates {
        let options = CandidateOptions::default()
            .with_distance(barrier.activation_distance_squared().sqrt())
            .with_boxes(BoxKind::Moving)
            .with_can_collide(self.can_collide.clone());
        // The distance of a barrier is positive.
        Candidates::with_options(step, &Bvh, &options).unwrap_or_default()
    }

    /// The surface of all bodies.
    #[must_use]
    pub fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// The corners of all tetrahedra, ordered so that the volume at the start is positive.
    pub fn tetrahedra(&self) -> impl Iterator<Item = [u32; 4]> {
        self.elements.iter().filter_map(|element| match element {
            Elastic::Tetrahedron(tetrahedron) => Some(tetrahedron.vertices()),
            Elastic::Membrane(_) | Elastic::Hinge(_) => None,
        })
    }

    /// The surface, for these positions of all vertices of the system. It has no vertices in the interior of
    /// solids.
    ///
    /// # Errors
    /// [`FrameError`], if a coordinate is not finite or there are too few positions.
    pub fn surface_frame(&self, positions: &[Point]) -> Result<Frame, FrameError> {
        let frame = Frame::new(positions.to_vec(), self.surface().faces().to_vec())?;
        Ok(frame.without_loose_vertices().0)
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

    /// The diagonal of the bounding box at the start, in m.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// True if a vertex has mass and no script.
    #[must_use]
    pub fn is_free(&self, vertex: usize) -> bool {
        self.scripts[vertex].is_none() && self.masses[vertex] > 0.0
    }

    /// The mass of all free vertices, in kg. If no vertex is free, the mass of all vertices; if no vertex has
    /// mass, 1 kg.
    #[must_use]
    pub fn free_mass(&self) -> f64 {
        self.counted_masses().iter().sum()
    }

    /// The mean mass of the vertices that [`System::free_mass`] sums, in kg.
    #[must_use]
    pub fn mean_mass(&self) -> f64 {
        self.free_mass() / self.counted_masses().len() as f64
    }

    /// The masses that [`System::free_mass`] sums. Not empty.
    fn counted_masses(&self) -> Vec<f64> {
        let masses = |is_counted: &dyn Fn(usize) -> bool| -> Vec<f64> {
            let masses = self.masses.iter().copied().enumerate();
            let counted = masses.filter(|&(vertex, mass)| mass > 0.0 && is_counted(vertex));
            counted.map(|(_, mass)| mass).collect()
        };
        let free = masses(&|vertex| self.is_free(vertex));
        let counted = if free.is_empty() { masses(&|_| true) } else { free };
        if counted.is_empty() { vec![1.0] } else { counted }
    }
}

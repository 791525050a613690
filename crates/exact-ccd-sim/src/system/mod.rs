//! All bodies of a scene, as one list of vertices and lists of elements over it.

mod error;
mod fingerprint;
mod parts;

use std::ops::Range;

use exact_ccd_mesh::{Bounds, Frame, FrameError, Point, TriangleMesh};
use nalgebra::Vector3;

use crate::body::Body;
use crate::contact::Surface;
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
    pub(crate) surface: Surface,
    /// Σ E V, in J: what elastic energies are small differences of.
    pub(crate) rigidity: f64,
    size: f64,
}

impl System {
    /// The system of some bodies, whose vertices follow each other in their order. `scripts` say how some vertices move;
    /// where there are several for one, the last counts. Obstacles without a script are fixed.
    ///
    /// # Errors
    /// [`SystemError`] names the body, and what is wrong with it.
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
        let bounds: Bounds = parts.start.iter().copied().collect();
        let size = if vertex_count == 0 {
            1.0
        } else {
            (Vector3::from(bounds.upper) - Vector3::from(bounds.lower)).norm()
        };
        Ok(Self {
            surface: Surface::new(mesh, parts.obstacle),
            start: parts.start,
            velocities: parts.velocities,
            masses: parts.masses,
            elements: parts.elements,
            scripts: parts.scripts,
            rigidity: parts.rigidity,
            size,
        })
    }

    /// The vertices of each body, in the order of the bodies.
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

    /// The surface of all bodies.
    #[must_use]
    pub fn surface(&self) -> &TriangleMesh {
        self.surface.mesh()
    }

    /// The corners of all tetrahedra, each of positive volume at the start.
    pub fn tetrahedra(&self) -> impl Iterator<Item = [u32; 4]> {
        self.elements.iter().filter_map(|element| match element {
            Elastic::Tetrahedron(tetrahedron) => Some(tetrahedron.vertices()),
            Elastic::Membrane(_) | Elastic::Hinge(_) => None,
        })
    }

    /// The surface alone with its vertices at these positions, which are those of all vertices: without those inside of
    /// solids.
    ///
    /// # Errors
    /// [`FrameError`] tells the first coordinate that is not finite, or that there are too few.
    pub fn surface_frame(&self, positions: &[Point]) -> Result<Frame, FrameError> {
        let frame = Frame::new(positions.to_vec(), self.surface().faces().to_vec())?;
        Ok(frame.without_loose_vertices().0)
    }

    /// The positions at the start, where everything is at rest, in m.
    #[must_use]
    pub fn start(&self) -> &[Point] {
        &self.start
    }

    /// The mass of each vertex, in kg. Obstacles have none.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// What tells it from other systems. It takes a look at all of it.
    #[must_use]
    pub fn fingerprint(&self) -> Fingerprint {
        Fingerprint::of(self)
    }

    /// The diagonal of the box around everything at the start, in m.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Whether a vertex moves by the laws of motion.
    #[must_use]
    pub fn is_free(&self, vertex: usize) -> bool {
        self.scripts[vertex].is_none() && self.masses[vertex] > 0.0
    }

    /// The mass of the vertices that are free, in kg; of all, if none is free, and 1 kg if none has any.
    #[must_use]
    pub fn free_mass(&self) -> f64 {
        self.counted_masses().iter().sum()
    }

    /// The mean mass of the same vertices, in kg.
    #[must_use]
    pub fn mean_mass(&self) -> f64 {
        self.free_mass() / self.counted_masses().len() as f64
    }

    /// The masses that [`System::free_mass`] sums: at least one.
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

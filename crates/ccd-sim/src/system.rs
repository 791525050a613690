//! All bodies of a scene, as one list of vertices and lists of elements over it.

use std::ops::Range;

use ccd_mesh::{Bounds, Frame, FrameError, Point, TetMesh, TetMeshError, TriangleMesh};
use nalgebra::Vector3;

use crate::body::{Body, BodyKind, ShellProperties, SolidProperties};
use crate::contact::Surface;
use crate::elasticity::{Hinge, Membrane, ModuliError, Tetrahedron};
use crate::gather::gather;
use crate::hinges::hinges;
use crate::script::Script;

/// The vertices, masses, elements and scripts of a scene.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) start: Vec<Point>,
    pub(crate) velocities: Vec<Point>,
    pub(crate) masses: Vec<f64>,
    pub(crate) tetrahedra: Vec<Tetrahedron>,
    pub(crate) membranes: Vec<Membrane>,
    pub(crate) hinges: Vec<Hinge>,
    /// The script of each vertex that has one.
    pub(crate) scripts: Vec<Option<Script>>,
    pub(crate) surface: Surface,
    /// Σ E V, in J: what elastic energies are small differences of.
    pub(crate) rigidity: f64,
    size: f64,
}

/// Bodies that make no system.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// A tetrahedron or a triangle names a vertex that its body does not have.
    #[error(
        "body {body}: element {element} names vertex {vertex}, but there are only {vertex_count} vertices"
    )]
    Index {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
        /// The vertex.
        vertex: u32,
        /// How many vertices the body has.
        vertex_count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("body {body}: vertex {vertex} is at {position:?}, expected finite numbers")]
    NotFinite {
        /// The body, from 0.
        body: usize,
        /// The vertex, from 0.
        vertex: usize,
        /// Its position.
        position: Point,
    },
    /// The tetrahedra are no solid.
    #[error("body {body}: {source}")]
    Solid {
        /// The body, from 0.
        body: usize,
        /// What is wrong with them.
        source: TetMeshError,
    },
    /// An element has no volume or no area, up to rounding.
    #[error("body {body}: element {element} is flat, expected a positive volume or area")]
    Flat {
        /// The body, from 0.
        body: usize,
        /// The element, from 0.
        element: usize,
    },
    /// The elastic moduli are out of range.
    #[error("body {body}: {source}")]
    Moduli {
        /// The body, from 0.
        body: usize,
        /// Which modulus.
        source: ModuliError,
    },
    /// The density or the thickness is not positive.
    #[error("body {body}: the {what} is {value}, expected a positive number")]
    NotPositive {
        /// The body, from 0.
        body: usize,
        /// `density` or `thickness`.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A script is for vertices that there are not.
    #[error("a script moves vertex {vertex}, but there are only {vertex_count} vertices")]
    Script {
        /// The vertex.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
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
        for (vertices, script) in scripts {
            for &vertex in vertices {
                let slot = parts.scripts.get_mut(vertex as usize);
                *slot.ok_or(SystemError::Script { vertex, vertex_count })? = Some(*script);
            }
        }
        let mesh = TriangleMesh::new(vertex_count, parts.faces).map_err(|error| SystemError::Index {
            body: 0,
            element: error.face,
            vertex: error.vertex,
            vertex_count,
        })?;
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
            tetrahedra: parts.tetrahedra,
            membranes: parts.membranes,
            hinges: parts.hinges,
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
        self.tetrahedra.iter().map(Tetrahedron::vertices)
    }

    /// The surface alone with its vertices at these positions, which are those of all vertices: without those inside of
    /// solids.
    ///
    /// # Errors
    /// [`FrameError`] tells the first coordinate that is not finite, or that there are too few.
    pub fn surface_frame(&self, positions: &[Point]) -> Result<Frame, FrameError> {
        let vertices = self.surface.vertices();
        let mut numbers = vec![0; self.start.len()];
        for (number, &vertex) in (0..).zip(vertices) {
            numbers[vertex as usize] = number;
        }
        let faces = self
            .surface()
            .faces()
            .iter()
            .map(|face| face.map(|vertex| numbers[vertex as usize]));
        let shown = vertices
            .iter()
            .filter_map(|&vertex| positions.get(vertex as usize).copied());
        Frame::new(shown.collect(), faces.collect())
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

    /// The mean mass of the vertices that are free, in kg.
    #[must_use]
    pub fn mean_mass(&self) -> f64 {
        let free = (0..self.masses.len()).filter(|&vertex| self.is_free(vertex));
        let (count, sum) = free.fold((0_u32, 0.0), |(count, sum), vertex| {
            (count + 1, sum + self.masses[vertex])
        });
        if count == 0 { 0.0 } else { sum / f64::from(count) }
    }
}

#[derive(Default)]
struct Parts {
    start: Vec<Point>,
    velocities: Vec<Point>,
    masses: Vec<f64>,
    faces: Vec<[u32; 3]>,
    tetrahedra: Vec<Tetrahedron>,
    membranes: Vec<Membrane>,
    hinges: Vec<Hinge>,
    scripts: Vec<Option<Script>>,
    obstacle: Vec<bool>,
    rigidity: f64,
}

impl Parts {
    fn add(&mut self, body: usize, added: &Body) -> Result<(), SystemError> {
        let is_finite = |point: &Point| point.iter().all(|x| x.is_finite());
        if let Some(vertex) = added.points.iter().position(|point| !is_finite(point)) {
            let position = added.points[vertex];
            return Err(SystemError::NotFinite {
                body,
                vertex,
                position,
            });
        }
        let first = self.start.len();
        let count = added.points.len();
        self.start.extend(&added.points);
        self.velocities.extend(std::iter::repeat_n(added.velocity, count));
        self.masses.resize(first + count, 0.0);
        let is_obstacle = matches!(added.kind, BodyKind::Obstacle { .. });
        self.obstacle.resize(first + count, is_obstacle);
        self.scripts
            .resize(first + count, is_obstacle.then_some(Script::Fixed));
        match &added.kind {
            BodyKind::Obstacle { faces } => {
                let faces = placed(body, faces, first, count)?;
                self.faces.extend(faces);
            }
            BodyKind::Solid { tetrahedra, material } => {
                let mesh = TetMesh::new(added.points.clone(), tetrahedra.clone())
                    .map_err(|source| SystemError::Solid { body, source })?;
                let surface = placed(body, mesh.surface(), first, count)?;
                let tetrahedra = placed(body, tetrahedra, first, count)?;
                self.add_solid(body, tetrahedra, material)?;
                self.faces.extend(surface);
            }
            BodyKind::Shell { faces, material } => {
                let faces = placed(body, faces, first, count)?;
                self.add_shell(body, faces, material)?;
            }
        }
        Ok(())
    }

    fn add_solid(
        &mut self,
        body: usize,
        mut tetrahedra: Vec<[u32; 4]>,
        material: &SolidProperties,
    ) -> Result<(), SystemError> {
        positive(body, "density", material.density)?;
        material
            .moduli()
            .check()
            .map_err(|source| SystemError::Moduli { body, source })?;
        for (element, corners) in tetrahedra.iter_mut().enumerate() {
            let points = gather(&self.start, corners);
            let volume = (points[1] - points[0])
                .cross(&(points[2] - points[0]))
                .dot(&(points[3] - points[0]));
            if volume < 0.0 {
                corners.swap(2, 3);
            }
            let points = gather(&self.start, corners);
            let tetrahedron = Tetrahedron::new(*corners, &points, material.energy, material.moduli())
                .ok_or(SystemError::Flat { body, element })?;
            for &corner in &*corners {
                self.masses[corner as usize] += 0.25 * material.density * tetrahedron.volume();
            }
            self.rigidity += material.young * tetrahedron.volume();
            self.tetrahedra.push(tetrahedron);
        }
        Ok(())
    }

    fn add_shell(
        &mut self,
        body: usize,
        faces: Vec<[u32; 3]>,
        material: &ShellProperties,
    ) -> Result<(), SystemError> {
        positive(body, "density", material.density)?;
        positive(body, "thickness", material.thickness)?;
        material
            .moduli()
            .check()
            .map_err(|source| SystemError::Moduli { body, source })?;
        for (element, corners) in faces.iter().enumerate() {
            let points = gather(&self.start, corners);
            let membrane = Membrane::new(*corners, &points, material.thickness, material.moduli())
                .ok_or(SystemError::Flat { body, element })?;
            for &corner in corners {
                self.masses[corner as usize] += material.density * membrane.volume() / 3.0;
            }
            self.rigidity += material.young * membrane.volume();
            self.membranes.push(membrane);
        }
        let rigidity = material.moduli().flexural_rigidity(material.thickness);
        for corners in hinges(&faces) {
            self.hinges
                .extend(Hinge::new(corners, &gather(&self.start, &corners), rigidity));
        }
        self.faces.extend(faces);
        Ok(())
    }
}

fn positive(body: usize, what: &'static str, value: f64) -> Result<(), SystemError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(SystemError::NotPositive { body, what, value })
    }
}

/// The elements of a body, with the numbers that its vertices have among all.
fn placed<const N: usize>(
    body: usize,
    elements: &[[u32; N]],
    first: usize,
    vertex_count: usize,
) -> Result<Vec<[u32; N]>, SystemError> {
    let place = |(element, corners): (usize, &[u32; N])| match corners
        .iter()
        .find(|&&vertex| vertex as usize >= vertex_count)
    {
        None => Ok(corners.map(|vertex| first as u32 + vertex)),
        Some(&vertex) => Err(SystemError::Index {
            body,
            element,
            vertex,
            vertex_count,
        }),
    };
    elements.iter().enumerate().map(place).collect()
}

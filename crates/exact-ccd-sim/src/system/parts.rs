//! The construction of a system, body by body.

use std::ops::Range;
use std::sync::Arc;

use exact_ccd::Thickness;
use exact_ccd_mesh::{Point, TetMesh};
use nalgebra::Vector3;

use super::bodies::Bodies;
use super::body_error::{BodyError, Selecting};
use super::elastic::Elastic;
use super::error::SystemError;
use super::geometry::Outline;
use super::materials::materials;
use super::selection;
use crate::body::{Body, BodyKind, ParticleProperties, RodProperties, ShellProperties, SolidProperties};
use crate::carriers::Carriers;
use crate::energies::elasticity::{
    Chain, Membrane, RodBend, StrainLimit, Stretch, Tetrahedron, bending, bending_vertices,
    paths_between_ends,
};
use crate::energies::term::{Energy, gather};
use crate::prescribed::{Coordinates, ScriptedVertices, Timed};
use crate::range::{OutOfRange, check, check_finite, check_positive};

/// The least limit of strains. Rounding alone leads to strains of some 1e-15 in shapes at rest.
const LEAST_STRAIN_LIMIT: f64 = 1e-6;

/// The parts of a system under construction.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) start: Vec<Point>,
    pub(super) velocities: Vec<Point>,
    pub(super) masses: Vec<f64>,
    pub(super) carriers: Carriers,
    pub(super) scripts: Vec<Coordinates>,
    pub(super) elastic: Elastic,
    pub(super) outline: Outline,
}

impl Parts {
    pub(super) fn add(&mut self, added: &Body) -> Result<(), BodyError> {
        let is_finite = |point: &Point| point.iter().all(|x| x.is_finite());
        if let Some(vertex) = added.points.iter().position(|point| !is_finite(point)) {
            let position = added.points[vertex];
            return Err(BodyError::NotFinite { vertex, position });
        }
        let is_obstacle = matches!(added.kind, BodyKind::Obstacle { .. });
        check_motion(added, is_obstacle)?;
        let first = self.start.len();
        let count = added.points.len();
        let end = first + added.vertex_count();
        self.start.extend(&added.points);
        self.velocities.resize(end, added.velocity);
        self.masses.resize(end, 0.0);
        self.outline.is_obstacle.resize(end, is_obstacle);
        self.outline.offsets.resize(end, added.offset);
        self.scripts.resize(end, Coordinates::default());
        let is_empty = match &added.kind {
            BodyKind::Obstacle { faces } | BodyKind::Shell { faces, .. } | BodyKind::Affine { faces, .. } => {
                faces.is_empty()
            }
            BodyKind::Solid { tetrahedra, .. } => tetrahedra.is_empty(),
            BodyKind::Rod { edges, .. } => edges.is_empty(),
            BodyKind::Particles { .. } => count == 0,
        };
        if is_empty {
            return Err(BodyError::Empty);
        }
        match &added.kind {
            BodyKind::Obstacle { faces } => {
                let faces = placed(faces, first, count)?;
                self.outline.faces.extend(faces);
            }
            BodyKind::Solid {
                tetrahedra,
                material,
                regions,
            } => {
                let mesh = TetMesh::new(added.points.clone(), tetrahedra.clone())?;
                let surface = placed(mesh.surface(), first, count)?;
                let tetrahedra = placed(tetrahedra, first, count)?;
                let materials = materials(tetrahedra.len(), material, regions)?;
                self.add_solid(tetrahedra, &materials)?;
                self.outline.faces.extend(surface);
            }
            BodyKind::Shell { faces, material } => {
                let faces = placed(faces, first, count)?;
                self.add_shell(faces, material)?;
            }
            BodyKind::Rod { edges, material } => {
                let edges = placed(edges, first, count)?;
                self.add_rod(edges, material)?;
            }
            BodyKind::Particles { material } => self.add_particles(first..first + count, material)?,
            BodyKind::Affine { faces, material } => {
                let faces = placed(faces, first, count)?;
                self.add_affine(first, faces, material)?;
            }
        }
        Ok(self.spin(first..end, added.angular_velocity.into())?)
    }

    /// Adds a script, by its number.
    pub(super) fn script(
        &mut self,
        number: usize,
        scripted: &ScriptedVertices,
        bodies: &Bodies,
    ) -> Result<(), SystemError> {
        scripted.check().map_err(|source| SystemError::Motion {
            script: number,
            source,
        })?;
        let script = Timed::new(scripted);
        let what = Selecting::Script(number);
        let vertex_count = self.start.len();
        for vertex in selection::unknowns(&self.carriers, bodies, &scripted.vertices, what)? {
            let slot = self.scripts.get_mut(vertex as usize);
            let slot = slot.ok_or(SystemError::Script {
                script: number,
                vertex,
                vertex_count,
            })?;
            slot.add(scripted.axes, &script);
        }
        Ok(())
    }

    /// Adds the velocities of a rotation about the center of mass of a body.
    fn spin(&mut self, vertices: Range<usize>, angular_velocity: Vector3<f64>) -> Result<(), OutOfRange> {
        if angular_velocity == Vector3::zeros() {
            return Ok(());
        }
        let points = || {
            self.start[vertices.clone()]
                .iter()
                .map(|point| Vector3::from(*point))
        };
        let masses = &self.masses[vertices.clone()];
        let moment: Vector3<f64> = points().zip(masses).map(|(point, mass)| point * *mass).sum();
        let center = moment / masses.iter().sum::<f64>();
        let turns: Vec<Vector3<f64>> = points()
            .map(|point| angular_velocity.cross(&(point - center)))
            .collect();
        for (velocity, turn) in self.velocities[vertices].iter_mut().zip(turns) {
            *velocity = (Vector3::from(*velocity) + turn).into();
            check_finite("angular-velocity", velocity)?;
        }
        Ok(())
    }

    fn add_solid(
        &mut self,
        mut tetrahedra: Vec<[u32; 4]>,
        materials: &[&SolidProperties],
    ) -> Result<(), BodyError> {
        for (element, (corners, material)) in tetrahedra.iter_mut().zip(materials).enumerate() {
            let [a, b, c, d] = gather(&self.start, corners);
            if (b - a).cross(&(c - a)).dot(&(d - a)) < 0.0 {
                corners.swap(2, 3);
            }
            let tetrahedron = Tetrahedron::new(*corners, &self.start).ok_or(BodyError::Flat { element })?;
            let volume = tetrahedron.volume();
            self.add_element(
                element,
                material.energy.energy(tetrahedron, material.moduli()),
                volume,
                [material.density, material.young],
            )?;
        }
        self.elastic.tetrahedra.extend(tetrahedra);
        Ok(())
    }

    fn add_shell(&mut self, faces: Vec<[u32; 3]>, material: &ShellProperties) -> Result<(), BodyError> {
        check_positive("density", material.density)
            .and(check_positive("thickness", material.thickness))
            .and(material.moduli().check())
            .and(check(
                material
                    .strain_limit
                    .is_none_or(|limit| limit.is_finite() && limit >= LEAST_STRAIN_LIMIT),
                "strain-limit",
                material.strain_limit.unwrap_or_default(),
                "a finite number of at least 1e-6",
            ))?;
        let limit = material
            .strain_limit
            .map(|limit| StrainLimit::new(limit, material.young));
        for (element, corners) in faces.iter().enumerate() {
            let membrane = Membrane::new(*corners, &self.start, material.thickness, material.moduli())
                .ok_or(BodyError::Flat { element })?
                .with_limit(limit);
            let volume = membrane.volume();
            self.add_element(
                element,
                Arc::new(membrane),
                volume,
                [material.density, material.young],
            )?;
        }
        let rigidity = material.moduli().flexural_rigidity(material.thickness);
        self.elastic
            .elements
            .extend(bending(&self.start, &faces, rigidity, material.poisson));
        self.outline.faces.extend(faces);
        Ok(())
    }

    fn add_rod(&mut self, edges: Vec<[u32; 2]>, material: &RodProperties) -> Result<(), BodyError> {
        check_positive("density", material.density)
            .and(check_positive("radius", material.radius))
            .and(check_positive("young", material.young))
            .and(check_positive("shear", material.shear.unwrap_or(1.0)))?;
        for (element, ends) in edges.iter().enumerate() {
            let stretch = Stretch::new(*ends, &self.start, material.axial_stiffness())
                .ok_or(BodyError::Flat { element })?;
            let volume = material.area() * stretch.length();
            self.add_element(
                element,
                Arc::new(stretch),
                volume,
                [material.density, material.young],
            )?;
        }
        for (element, corners) in bending_vertices(&edges) {
            let bend = RodBend::new(corners, &self.start, material.flexural_rigidity());
            let bend = bend.ok_or(BodyError::Folded { element })?;
            self.elastic.elements.push(Arc::new(bend));
        }
        match material.torsional_rigidity() {
            None => self.elastic.untwisted.extend(paths_between_ends(&edges)),
            Some(rigidity) => {
                let chain = |vertices| Chain::new(vertices, &self.start, rigidity);
                self.elastic
                    .chains
                    .extend(paths_between_ends(&edges).into_iter().map(chain));
            }
        }
        self.outline.edges.extend(edges);
        Ok(())
    }

    /// Adds an element of a body with its mass, in equal shares for its vertices. The material has a density
    /// and a Young's modulus.
    pub(super) fn add_element(
        &mut self,
        element: usize,
        energy: Arc<dyn Energy>,
        volume: f64,
        [density, young]: [f64; 2],
    ) -> Result<(), BodyError> {
        let share = mass(element, density * volume)? / energy.vertices().len() as f64;
        for &corner in energy.vertices() {
            self.masses[corner as usize] += share;
        }
        self.elastic.add(energy, young * volume);
        Ok(())
    }

    fn add_particles(
        &mut self,
        vertices: Range<usize>,
        material: &ParticleProperties,
    ) -> Result<(), BodyError> {
        check_positive("density", material.density).and(check_positive("radius", material.radius))?;
        self.masses[vertices.clone()].fill(mass(0, material.mass())?);
        self.outline
            .particles
            .extend(vertices.map(|vertex| vertex as u32));
        Ok(())
    }
}

/// Checks the velocities and the offset of a body.
fn check_motion(body: &Body, is_obstacle: bool) -> Result<(), OutOfRange> {
    for (field, velocity) in [
        ("velocity", body.velocity),
        ("angular-velocity", body.angular_velocity),
    ] {
        check_finite(field, &velocity)?;
        let (rests, expected) = (velocity == [0.0; 3], "zero: obstacles are moved by scripts");
        check(
            !is_obstacle || rests,
            field,
            format_args!("{velocity:?}"),
            expected,
        )?;
    }
    let (offset, expected) = (
        body.offset,
        format_args!("a number from 0 to {:e}", Thickness::MAX),
    );
    check(
        (0.0..=Thickness::MAX).contains(&offset),
        "offset",
        offset,
        expected,
    )
}

/// Checks the mass of an element.
fn mass(element: usize, mass: f64) -> Result<f64, BodyError> {
    if mass.is_normal() {
        Ok(mass)
    } else {
        Err(BodyError::Mass { element, mass })
    }
}

/// The elements of a body, with the vertex indices of the system.
fn placed<const N: usize>(
    elements: &[[u32; N]],
    first: usize,
    vertex_count: usize,
) -> Result<Vec<[u32; N]>, BodyError> {
    let place = |(element, corners): (usize, &[u32; N])| match corners
        .iter()
        .find(|&&vertex| vertex as usize >= vertex_count)
    {
        None => Ok(corners.map(|vertex| first as u32 + vertex)),
        Some(&vertex) => Err(BodyError::Index {
            element,
            vertex,
            vertex_count,
        }),
    };
    elements.iter().enumerate().map(place).collect()
}

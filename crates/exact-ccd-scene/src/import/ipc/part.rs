//! A shape of a text scene as a body.

use std::rc::Rc;

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;

use super::super::fault::{Fault, Place, Problem};
use super::super::meshes::Meshes;
use super::super::pose::{Pose, box_center};
use super::super::selection::of_vertices;
use super::file::{File, Script as Motion};
use super::held::{self, Piece};
use super::shape::{Dirichlet, RelativeBox, Shape};
use crate::description::{BodyDescription, LoadDescription};
use crate::mesh::Mesh;
use exact_ccd_sim::Force;
use exact_ccd_sim::SolidProperties;
use exact_ccd_sim::elasticity::SolidMaterial;

/// A shape with its mesh and its body.
pub(super) struct Part<'a> {
    shape: &'a Shape,
    mesh: Rc<Mesh>,
    pub(super) pose: Pose,
    pub(super) body: BodyDescription,
    /// The placed vertices.
    pub(super) points: Vec<Point>,
}

impl<'a> Part<'a> {
    /// The body of a shape without its motions.
    pub(super) fn new(shape: &'a Shape, file: &File, meshes: &mut Meshes) -> Result<Self, Fault> {
        let at_shape = |problem: Problem| problem.at(&shape.place);
        let is_solid = is_solid(shape).map_err(at_shape)?;
        if !is_solid && matches!(file.script, Motion::Fall | Motion::FallNoShift | Motion::Twist) {
            let what = "a surface that nothing holds, as in IPC with this script,";
            let instead = "write `script null`, which holds surfaces";
            return Err(at_shape(Problem::unsupported(what, instead)));
        }
        let (path, mesh) = meshes.find(&shape.mesh).map_err(at_shape)?;
        let [young, poisson] = file.stiffness;
        let [density, young, poisson] = shape.material.unwrap_or([file.density, young, poisson]);
        let solid = SolidProperties {
            density,
            young,
            poisson,
            energy: SolidMaterial::NeoHookean,
        };
        let mut part = Self {
            shape,
            mesh,
            pose: Pose::IDENTITY,
            body: BodyDescription {
                mesh: Some(path),
                solid: is_solid.then_some(solid),
                ..BodyDescription::default()
            },
            points: Vec::new(),
        };
        part.place(shape.pose);
        Ok(part)
    }

    pub(super) fn is_solid(&self) -> bool {
        self.body.solid.is_some()
    }

    /// Places the body.
    pub(super) fn place(&mut self, pose: Pose) {
        self.pose = pose;
        pose.apply(&mut self.body);
        let points = self.mesh.points.iter();
        self.points = points.map(|&point| self.body.place(point)).collect();
    }

    /// Adds the motions and the forces that the attributes of the shape say.
    pub(super) fn add_motions(&mut self, file: &File, notes: &mut Vec<(Place, String)>) -> Result<(), Fault> {
        let shape = self.shape;
        let velocities = [&shape.linear_velocity, &shape.angular_velocity].map(Option::as_ref);
        let moved = velocities.into_iter().flatten().map(|(place, _)| place).next();
        let held = shape.dirichlet.iter().map(|held| &held.place).next();
        let started = shape.initial.as_ref().map(|(place, _)| place);
        if file.script != Motion::Null
            && let Some(place) = moved.or(held).or(started)
        {
            let what = "an attribute that IPC ignores with this script";
            return Err(Problem::unsupported(what, "write `script null`, or remove the attribute").at(place));
        }
        if let (Some(_), Some(place)) = (moved, held) {
            let what = "the sum of a motion of the shape and of one of its vertices";
            return Err(Problem::unsupported(what, "write one of them").at(place));
        }
        if let Some(place) = moved {
            let [linear, angular] =
                velocities.map(|velocity| velocity.map_or([0.0; 3], |(_, velocity)| *velocity));
            let piece = Piece {
                place: place.clone(),
                vertices: (0..self.points.len() as u32).collect(),
                linear,
                angular,
                from: 0.0,
                until: f64::INFINITY,
            };
            self.script(&[piece], file, notes)?;
        }
        self.hold(file, notes)?;
        if let Some((place, [linear, angular])) = &shape.initial {
            if !self.is_solid() {
                let what = "an initial velocity of a surface without mass";
                return Err(Problem::unsupported(what, "write `linearVelocity`").at(place));
            }
            self.start(*linear, *angular);
        }
        self.load(file)
    }

    /// The initial velocity, of which the angular part is about the center of the box in IPC.
    fn start(&mut self, linear: Point, angular: Point) {
        let all: Vec<u32> = (0..self.points.len() as u32).collect();
        let arm = self.center_of_mass() - Vector3::from(center(&all, &self.points));
        self.body.velocity = (Vector3::from(linear) + Vector3::from(angular).cross(&arm)).into();
        self.body.angular_velocity = angular;
    }

    fn center_of_mass(&self) -> Vector3<f64> {
        let moment = |tetrahedron: &[u32; 4]| {
            let [a, b, c, d] = tetrahedron.map(|vertex| Vector3::from(self.points[vertex as usize]));
            let volume = (b - a).cross(&(c - a)).dot(&(d - a)).abs();
            (volume, (a + b + c + d) * (0.25 * volume))
        };
        let moments = self.mesh.tetrahedra.iter().map(moment);
        let (volume, moment) = moments.fold((0.0, Vector3::zeros()), |(volume, sum), (part, moment)| {
            (volume + part, sum + moment)
        });
        moment / volume
    }

    /// Scripts of `DBC`.
    fn hold(&mut self, file: &File, notes: &mut Vec<(Place, String)>) -> Result<(), Fault> {
        let [from, until] = file.dirichlet_times;
        let piece = |held: &Dirichlet| Piece {
            place: held.place.clone(),
            vertices: self.inside(&held.vertices),
            linear: held.linear,
            angular: held.angular,
            from: held.from.max(from).max(0.0),
            until: held.until.min(until),
        };
        let mut pieces: Vec<Piece> = self.shape.dirichlet.iter().map(piece).collect();
        pieces.retain(|piece| {
            let acts = !piece.vertices.is_empty() && piece.from < piece.until;
            if !acts {
                notes.push((piece.place.clone(), "no vertex is held".to_owned()));
            }
            acts
        });
        pieces.sort_by(|a, b| a.from.total_cmp(&b.from));
        (1..=pieces.len()).try_for_each(|count| self.script(&pieces[..count], file, notes))
    }

    /// Adds the script of the last of these pieces, of which the others begin before.
    fn script(
        &mut self,
        pieces: &[Piece],
        file: &File,
        notes: &mut Vec<(Place, String)>,
    ) -> Result<(), Fault> {
        let moved = held::moved(pieces)?;
        let Some(piece) = pieces.last() else {
            return Ok(());
        };
        if piece.turns() {
            let message = "turns about the center that the box of the vertices has at the start; IPC computes \
                           this center anew in each time step";
            notes.push((piece.place.clone(), message.to_owned()));
        }
        let selection = of_vertices(&piece.vertices, &self.points);
        let center = Vector3::from(center(&piece.vertices, &self.points)) + moved;
        let script = piece.script(selection, center.into(), file);
        self.body.script.push(script);
        Ok(())
    }

    /// Loads of `NBC`.
    fn load(&mut self, file: &File) -> Result<(), Fault> {
        for load in &self.shape.neumann {
            let vertices = self.inside(&load.vertices);
            let [from, until] = file.neumann_times;
            let (from, until) = (load.from.max(from), load.until.min(until));
            if vertices.is_empty() || from >= until {
                return Err(Problem::invalid("no vertex or no time", "a force that acts").at(&load.place));
            }
            self.body.load.push(LoadDescription {
                vertices: of_vertices(&vertices, &self.points),
                force: Force::Acceleration(load.acceleration),
                from,
                until: until.is_finite().then_some(until),
            });
        }
        Ok(())
    }

    /// The vertices of the surface in a box relative to that of the mesh in its file.
    fn inside(&self, relative: &RelativeBox) -> Vec<u32> {
        let points = &self.mesh.points;
        let Aabb { lower, upper } = points.iter().copied().collect();
        let corner = |fraction: Point| -> Point {
            core::array::from_fn(|axis| (upper[axis] - lower[axis]) * fraction[axis] + lower[axis])
        };
        let (from, to) = (corner(relative.lower), corner(relative.upper));
        let mut is_selected = vec![self.mesh.faces.is_empty(); points.len()];
        for &vertex in self.mesh.faces.iter().flatten() {
            is_selected[vertex as usize] = true;
        }
        let is_inside = |point: &Point| (0..3).all(|axis| (from[axis]..=to[axis]).contains(&point[axis]));
        let vertices = (0..).zip(points.iter().zip(is_selected));
        vertices
            .filter(|(_, (point, is_selected))| *is_selected && is_inside(point))
            .map(|(vertex, _)| vertex)
            .collect()
    }
}

/// The center of the box of some vertices of a body.
fn center(selected: &[u32], points: &[Point]) -> Point {
    box_center(selected.iter().map(|&vertex| points[vertex as usize]))
}

/// True for a file of tetrahedra, false for one of triangles.
fn is_solid(shape: &Shape) -> Result<bool, Problem> {
    match shape.mesh.rsplit('.').next().unwrap_or_default() {
        "msh" => Ok(true),
        "obj" => Ok(false),
        "seg" | "pt" => {
            let what = "an obstacle of edges or of points";
            Err(Problem::unsupported(what, "give it triangles, in an .obj file"))
        }
        _ => {
            let found = format!("`{}`", shape.mesh);
            Err(Problem::invalid(
                found,
                "a .msh file of tetrahedra or an .obj file of triangles",
            ))
        }
    }
}

//! A shape of a text scene as a body.

use std::rc::Rc;

use exact_ccd_mesh::{Aabb, Point};
use exact_ccd_sim::{Force, SolidProperties};
use nalgebra::Vector3;

use super::file::{File, Script as Motion};
use super::held::{self, Piece};
use super::shape::{RelativeBox, Shape};
use crate::fault::{Fault, Problem};
use crate::meshes::Meshes;
use crate::notes::Notes;
use exact_ccd_scene::Mesh;
use exact_ccd_scene::description::Placement;
use exact_ccd_scene::description::{BodyDescription, LoadDescription, Selection};

/// A shape with its mesh and its body.
pub(super) struct Part<'a> {
    shape: &'a Shape,
    mesh: Rc<Mesh>,
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
        // All solids have the energy that the file names.
        let solid = SolidProperties {
            energy: file.material.energy,
            ..shape.material.unwrap_or(file.material)
        };
        let mut part = Self {
            shape,
            mesh,
            body: BodyDescription {
                mesh: Some(path),
                solid: is_solid.then_some(solid),
                ..BodyDescription::default()
            },
            points: Vec::new(),
        };
        part.place(shape.placement);
        Ok(part)
    }

    pub(super) fn is_solid(&self) -> bool {
        self.body.solid.is_some()
    }

    /// Places the body.
    pub(super) fn place(&mut self, placement: Placement) {
        self.body = std::mem::take(&mut self.body).at(placement);
        self.points = placement.all(&self.mesh.points);
    }

    /// Adds the motions and the forces that the attributes of the shape say.
    pub(super) fn add_motions(&mut self, file: &File, notes: &Notes) -> Result<(), Fault> {
        let shape = self.shape;
        let moved = shape.moved.as_ref().map(|(place, _)| place);
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
        if let Some((place, [linear, angular])) = &shape.moved {
            let piece = Piece {
                place: place.clone(),
                vertices: (0..self.points.len() as u32).collect(),
                linear: *linear,
                angular: *angular,
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

    /// The initial velocity. In IPC, its angular part is about the center of the box.
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
    fn hold(&mut self, file: &File, notes: &Notes) -> Result<(), Fault> {
        let piece = |held: &Piece<RelativeBox>| held.of(self.inside(&held.vertices), file.dirichlet_times);
        let mut pieces: Vec<Piece> = self.shape.dirichlet.iter().map(piece).collect();
        pieces.retain(|piece| {
            let acts = !piece.vertices.is_empty() && piece.from < piece.until;
            if !acts {
                notes.add(piece.place.clone(), "no vertex is held");
            }
            acts
        });
        pieces.sort_by(|a, b| a.from.total_cmp(&b.from));
        (1..=pieces.len()).try_for_each(|count| self.script(&pieces[..count], file, notes))
    }

    /// Adds the script of the last of these pieces. The others begin before it.
    fn script(&mut self, pieces: &[Piece], file: &File, notes: &Notes) -> Result<(), Fault> {
        let moved = held::moved(pieces)?;
        let Some(piece) = pieces.last() else {
            return Ok(());
        };
        if piece.turns() {
            let message = "turns about the center that the box of the vertices has at the start; IPC computes \
                           this center anew in each time step";
            notes.add(piece.place.clone(), message);
        }
        let selection = Selection::of_vertices(&piece.vertices, &self.points);
        let center = Vector3::from(center(&piece.vertices, &self.points)) + moved;
        let script = piece.script(selection, center.into(), [file.settings.time_step, file.duration]);
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
                vertices: Selection::of_vertices(&vertices, &self.points),
                force: Force::Acceleration(load.acceleration),
                from,
                until: until.is_finite().then_some(until),
            });
        }
        Ok(())
    }

    /// The vertices of the surface in a box that is relative to the box of the mesh in its file.
    fn inside(&self, relative: &RelativeBox) -> Vec<u32> {
        let points = &self.mesh.points;
        let whole: Aabb = points.iter().copied().collect();
        let sides = whole.sides();
        let corner = |part: Point| [0, 1, 2].map(|axis: usize| sides[axis] * part[axis] + whole.lower[axis]);
        let bounds = Aabb {
            lower: corner(relative.lower),
            upper: corner(relative.upper),
        };
        let mut is_selected = vec![self.mesh.faces.is_empty(); points.len()];
        for &vertex in self.mesh.faces.iter().flatten() {
            is_selected[vertex as usize] = true;
        }
        let vertices = (0..).zip(points.iter().zip(is_selected));
        vertices
            .filter(|(_, (point, is_selected))| *is_selected && bounds.contains(point))
            .map(|(vertex, _)| vertex)
            .collect()
    }
}

/// The center of the box of some vertices of a body.
fn center(selected: &[u32], points: &[Point]) -> Point {
    let bounds: Aabb = selected.iter().map(|&vertex| points[vertex as usize]).collect();
    bounds.center()
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

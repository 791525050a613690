//! Boundary and initial conditions.

use std::cell::Cell;

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;

use super::super::fault::{Fault, Place};
use super::super::selection::of_vertices;
use super::NOTHING;
use super::entry::{Entry, Rule};
use super::expression;
use super::region::Regions;
use super::settings::Time;
use crate::load::Force;
use crate::scene::description::{Axis, BodyDescription, LoadDescription, ScriptDescription, Selection};
use crate::script::{KeyFrame, Script};

/// The most time steps of a motion that is not linear in time.
const MOST: f64 = 1e5;

/// The conditions of a file.
pub(super) struct Conditions<'a> {
    /// The acceleration of gravity: `rhs` with the other sign.
    pub(super) gravity: Point,
    dirichlet: Vec<Condition<'a, Held>>,
    obstacles: Vec<Condition<'a, Held>>,
    forces: Vec<Condition<'a, Force>>,
    velocities: Vec<Condition<'a, Point>>,
}

/// A value for the faces or bodies with some ids.
struct Condition<'a, T> {
    entry: Entry<'a>,
    /// `None` for all ids.
    ids: Option<Vec<i64>>,
    value: T,
    is_used: Cell<bool>,
}

/// A motion along some axes.
struct Held {
    axes: [bool; 3],
    motion: Script,
}

/// The faces of a placed body with their ids.
pub(super) struct Surface<'a> {
    points: &'a [Point],
    faces: &'a [[u32; 3]],
    ids: Vec<Option<i64>>,
}

impl<'a> Surface<'a> {
    pub(super) fn new(points: &'a [Point], faces: &'a [[u32; 3]], regions: Option<&Regions>, bounds: &Aabb) -> Self {
        let id = |face: &[u32; 3]| {
            let corners = face.map(|vertex| Vector3::from(points[vertex as usize]));
            regions?.id(&(corners.iter().sum::<Vector3<f64>>() / 3.0), bounds)
        };
        let ids = faces.iter().map(id).collect();
        Self { points, faces, ids }
    }

    /// The same surface at another place.
    pub(super) fn at<'b>(&'b self, points: &'b [Point]) -> Surface<'b> {
        Surface {
            points,
            faces: self.faces,
            ids: self.ids.clone(),
        }
    }

    /// The id of all faces.
    pub(super) fn single_id(&self) -> Option<i64> {
        let first = self.ids.first().copied().flatten()?;
        self.ids.iter().all(|id| *id == Some(first)).then_some(first)
    }

    /// The vertices of the faces with an id of the condition.
    fn vertices<T>(&self, condition: &Condition<'_, T>) -> Vec<u32> {
        let mut is_selected = vec![false; self.points.len()];
        for face in self.selected(condition) {
            face.iter().for_each(|&vertex| is_selected[vertex as usize] = true);
        }
        (0..).zip(is_selected).filter(|(_, selected)| *selected).map(|(vertex, _)| vertex).collect()
    }

    fn selected<T>(&self, condition: &Condition<'_, T>) -> impl Iterator<Item = &[u32; 3]> {
        let faces = self.faces.iter().zip(&self.ids);
        faces.filter(|(_, id)| condition.has(**id)).map(|(face, _)| face)
    }
}

impl<'a, T> Condition<'a, T> {
    fn new(entry: &Entry<'a>, value: T) -> Result<Self, Fault> {
        let id = entry.need("id")?;
        let ids = if id.value.as_str() == Some("all") {
            None
        } else {
            Some(id.list().iter().map(Entry::integer).collect::<Result<_, _>>()?)
        };
        Ok(Self {
            entry: entry.clone(),
            ids,
            value,
            is_used: Cell::new(false),
        })
    }

    fn has(&self, id: Option<i64>) -> bool {
        self.ids.as_ref().is_none_or(|ids| id.is_some_and(|id| ids.contains(&id)))
    }

    fn check_use(&self) -> Result<(), Fault> {
        if self.is_used.get() {
            return Ok(());
        }
        let instead = "give an id to faces by `surface_selection`, and to bodies by `volume_selection`";
        Err(self.entry.unsupported("an id that no selection of the file gives", instead))
    }
}

impl<'a> Conditions<'a> {
    pub(super) fn parse(root: &Entry<'a>, time: &Time, notes: &mut Vec<(Place, String)>) -> Result<Self, Fault> {
        let mut conditions = Self {
            gravity: [0.0; 3],
            dirichlet: Vec::new(),
            obstacles: Vec::new(),
            forces: Vec::new(),
            velocities: Vec::new(),
        };
        if let Some(boundary) = root.get("boundary_conditions") {
            conditions.boundary(&boundary, time, notes)?;
        }
        if let Some(initial) = root.get("initial_conditions") {
            let rules = [("solution", NOTHING), ("velocity", Rule::Said), ("acceleration", NOTHING)];
            initial.check(&rules, notes)?;
            for entry in initial.get("velocity").iter().flat_map(Entry::list) {
                entry.check(&[("id", Rule::Said), ("value", Rule::Said)], notes)?;
                let velocity = entry.need("value")?.point()?;
                conditions.velocities.push(Condition::new(&entry, velocity)?);
            }
        }
        Ok(conditions)
    }

    fn boundary(&mut self, boundary: &Entry<'a>, time: &Time, notes: &mut Vec<(Place, String)>) -> Result<(), Fault> {
        let rules = [
            ("rhs", Rule::Said),
            ("dirichlet_boundary", Rule::Said),
            ("obstacle_displacements", Rule::Said),
            ("neumann_boundary", Rule::Said),
            ("pressure_boundary", Rule::Said),
            ("normal_aligned_neumann_boundary", NOTHING),
            ("pressure_cavity", NOTHING),
            ("periodic_boundary", NOTHING),
        ];
        boundary.check(&rules, notes)?;
        if let Some(rhs) = boundary.get("rhs").filter(|rhs| rhs.value.as_array().is_none_or(|list| !list.is_empty())) {
            // `0.0 -` and not a negation, so that 0 stays 0.
            self.gravity = rhs.point()?.map(|component| 0.0 - component);
        }
        let entries = |key: &str| boundary.get(key).map_or_else(Vec::new, |entry| entry.list());
        for entry in entries("dirichlet_boundary") {
            self.dirichlet.push(Condition::new(&entry, held(&entry, time, notes)?)?);
        }
        for entry in entries("obstacle_displacements") {
            self.obstacles.push(Condition::new(&entry, held(&entry, time, notes)?)?);
        }
        let rules = [("id", Rule::Said), ("value", Rule::Said), ("interpolation", NOTHING), ("time_reference", NOTHING)];
        for entry in entries("neumann_boundary") {
            entry.check(&rules, notes)?;
            let force = Force::Traction(entry.need("value")?.point()?);
            self.forces.push(Condition::new(&entry, force)?);
        }
        for entry in entries("pressure_boundary") {
            entry.check(&rules, notes)?;
            // PolyFEM's pressure acts along the normal (`PressureForm.cpp`).
            let force = Force::Pressure(0.0 - entry.need("value")?.number()?);
            self.forces.push(Condition::new(&entry, force)?);
        }
        Ok(())
    }

    /// Adds the scripts and loads of a body.
    pub(super) fn apply(&self, body: &mut BodyDescription, surface: &Surface<'_>) -> Result<(), Fault> {
        let mut is_held = vec![false; surface.points.len()];
        for condition in &self.dirichlet {
            let vertices = surface.vertices(condition);
            if vertices.is_empty() {
                continue;
            }
            condition.is_used.set(true);
            if vertices.iter().any(|&vertex| is_held[vertex as usize]) {
                let what = "a vertex that two conditions hold";
                return Err(condition.entry.unsupported(what, "let the faces of both have no vertex in common"));
            }
            vertices.iter().for_each(|&vertex| is_held[vertex as usize] = true);
            let Held { axes, motion } = &condition.value;
            let names = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(axes);
            body.script.push(ScriptDescription {
                axes: names.filter(|(_, is_held)| **is_held).map(|(axis, _)| axis).collect(),
                ..ScriptDescription::new(of_vertices(&vertices, surface.points), motion.clone())
            });
        }
        for condition in &self.forces {
            let vertices = surface.vertices(condition);
            if vertices.is_empty() {
                continue;
            }
            condition.is_used.set(true);
            let has_corners = |face: &&[u32; 3]| face.iter().all(|corner| vertices.binary_search(corner).is_ok());
            if surface.faces.iter().filter(has_corners).count() != surface.selected(condition).count() {
                let what = "a force on faces, of which the corners are also those of another face,";
                return Err(condition.entry.unsupported(what, "select that face too"));
            }
            body.load.push(LoadDescription {
                vertices: of_vertices(&vertices, surface.points),
                force: condition.value,
                from: 0.0,
                until: None,
            });
        }
        Ok(())
    }

    /// Adds the script of an obstacle with an id.
    pub(super) fn move_obstacle(&self, body: &mut BodyDescription, id: Option<i64>) -> Result<(), Fault> {
        let Some(id) = id else {
            return Ok(());
        };
        let conditions = self.obstacles.iter().chain(&self.dirichlet);
        let Some(condition) = conditions.into_iter().find(|condition| condition.has(Some(id))) else {
            return Ok(());
        };
        condition.is_used.set(true);
        let motion = condition.value.motion.clone();
        body.script.push(ScriptDescription::new(Selection::All, motion));
        Ok(())
    }

    /// The initial velocity of a body with an id.
    pub(super) fn velocity(&self, id: Option<i64>) -> Result<Point, Fault> {
        let Some(condition) = self.velocities.iter().find(|condition| condition.has(id)) else {
            return Ok([0.0; 3]);
        };
        condition.is_used.set(true);
        Ok(condition.value)
    }

    /// Checks that all conditions apply to something.
    pub(super) fn check_use(&self) -> Result<(), Fault> {
        self.dirichlet.iter().chain(&self.obstacles).try_for_each(Condition::check_use)?;
        self.forces.iter().try_for_each(Condition::check_use)?;
        self.velocities.iter().try_for_each(Condition::check_use)
    }
}

/// A displacement as a function of time.
fn held(entry: &Entry<'_>, time: &Time, notes: &mut Vec<(Place, String)>) -> Result<Held, Fault> {
    if entry.value.is_string() {
        return Err(entry.unsupported("a file of displacements", "write `id` and `value`"));
    }
    let rules = [
        ("id", Rule::Said),
        ("value", Rule::Said),
        ("dimension", Rule::Said),
        ("time_reference", NOTHING),
        ("interpolation", NOTHING),
    ];
    entry.check(&rules, notes)?;
    let values = entry.need("value")?;
    let [x, y, z] = &values.elements()?[..] else {
        return Err(values.invalid("three numbers or functions of t"));
    };
    let mut axes = [true; 3];
    if let Some(dimension) = entry.get("dimension") {
        let flags: Result<Vec<bool>, Fault> = dimension.elements()?.iter().map(Entry::is_true).collect();
        axes = flags?.try_into().map_err(|_| dimension.invalid("three of true and false"))?;
    }
    let displacement = |t: f64| -> Result<Point, Fault> { Ok([at(x, t)?, at(y, t)?, at(z, t)?]) };
    let motion = motion(&displacement, time, &values)?;
    Ok(Held { axes, motion })
}

/// The value of a function of time.
fn at(entry: &Entry<'_>, t: f64) -> Result<f64, Fault> {
    let Some(text) = entry.value.as_str() else {
        return entry.number();
    };
    expression::value(text, t).ok_or_else(|| {
        let instead = "write a function of t with + - * / ( ) pi sin cos sqrt abs min max";
        entry.unsupported("this function", instead)
    })
}

/// The script of a displacement: its values at the ends of time steps.
fn motion(displacement: &dyn Fn(f64) -> Result<Point, Fault>, time: &Time, values: &Entry<'_>) -> Result<Script, Fault> {
    let count = (time.duration / time.step).ceil();
    if !(0.0..=MOST).contains(&count) {
        return Err(values.invalid(&format!("at most {MOST} time steps, of positive length")));
    }
    let frame = |index: f64| -> Result<KeyFrame, Fault> {
        let time = index * time.step;
        Ok(KeyFrame {
            time,
            translate: displacement(time)?,
            degrees: 0.0,
        })
    };
    let mut frames = vec![frame(0.0)?];
    for index in 1..=count as u64 {
        let next = frame(index as f64)?;
        if let [.., before, last] = &frames[..]
            && is_between(before, last, &next)
        {
            frames.pop();
        }
        frames.push(next);
    }
    if frames.iter().all(|frame| frame.translate == [0.0; 3]) {
        return Ok(Script::Fixed);
    }
    Ok(Script::KeyFrames {
        frames,
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
    })
}

/// True if a key frame is on the line between two others, up to rounding.
fn is_between(before: &KeyFrame, frame: &KeyFrame, after: &KeyFrame) -> bool {
    let share = (frame.time - before.time) / (after.time - before.time);
    (0..3).all(|axis| {
        let (from, to) = (before.translate[axis], after.translate[axis]);
        let expected = from + share * (to - from);
        (expected - frame.translate[axis]).abs() <= 1e-12 * (from.abs() + to.abs())
    })
}

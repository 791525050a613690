//! Boundary and initial conditions.

use std::cell::Cell;

use exact_ccd_mesh::Point;

use super::super::fault::{Fault, Place};
use super::super::selection::of_vertices;
use super::NOTHING;
use super::entry::{Entry, Rule};
use super::motion::{Held, held};
use super::settings::Time;
use super::surface::{Ids, Surface};
use crate::description::{Axis, BodyDescription, LoadDescription, ScriptDescription, Selection};
use exact_ccd_sim::Force;

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
    ids: Ids,
    value: T,
    is_used: Cell<bool>,
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
            ids: Ids(ids),
            value,
            is_used: Cell::new(false),
        })
    }

    fn check_use(&self) -> Result<(), Fault> {
        if self.is_used.get() {
            return Ok(());
        }
        let instead = "give an id to faces by `surface_selection`, and to bodies by `volume_selection`";
        Err(self
            .entry
            .unsupported("an id that no selection of the file gives", instead))
    }
}

impl<'a> Conditions<'a> {
    pub(super) fn parse(
        root: &Entry<'a>,
        time: &Time,
        notes: &mut Vec<(Place, String)>,
    ) -> Result<Self, Fault> {
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
            let rules = [
                ("solution", NOTHING),
                ("velocity", Rule::Said),
                ("acceleration", NOTHING),
            ];
            initial.check(&rules, notes)?;
            for entry in initial.get("velocity").iter().flat_map(Entry::list) {
                entry.check(&[("id", Rule::Said), ("value", Rule::Said)], notes)?;
                let velocity = entry.need("value")?.point()?;
                conditions.velocities.push(Condition::new(&entry, velocity)?);
            }
        }
        Ok(conditions)
    }

    fn boundary(
        &mut self,
        boundary: &Entry<'a>,
        time: &Time,
        notes: &mut Vec<(Place, String)>,
    ) -> Result<(), Fault> {
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
        if let Some(rhs) = boundary
            .get("rhs")
            .filter(|rhs| rhs.value.as_array().is_none_or(|list| !list.is_empty()))
        {
            // `0.0 -` and not a negation, so that 0 stays 0.
            self.gravity = rhs.point()?.map(|component| 0.0 - component);
        }
        let entries = |key: &str| boundary.get(key).map_or_else(Vec::new, |entry| entry.list());
        for entry in entries("dirichlet_boundary") {
            self.dirichlet
                .push(Condition::new(&entry, held(&entry, time, notes)?)?);
        }
        for entry in entries("obstacle_displacements") {
            self.obstacles
                .push(Condition::new(&entry, held(&entry, time, notes)?)?);
        }
        let rules = [
            ("id", Rule::Said),
            ("value", Rule::Said),
            ("interpolation", NOTHING),
            ("time_reference", NOTHING),
        ];
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
            let vertices = surface.vertices(&condition.ids);
            if vertices.is_empty() {
                continue;
            }
            condition.is_used.set(true);
            if vertices.iter().any(|&vertex| is_held[vertex as usize]) {
                let what = "a vertex that two conditions hold";
                return Err(condition
                    .entry
                    .unsupported(what, "let the faces of both have no vertex in common"));
            }
            vertices
                .iter()
                .for_each(|&vertex| is_held[vertex as usize] = true);
            let Held { axes, motion } = &condition.value;
            let names = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(axes);
            body.script.push(ScriptDescription {
                axes: names
                    .filter(|(_, is_held)| **is_held)
                    .map(|(axis, _)| axis)
                    .collect(),
                ..ScriptDescription::new(of_vertices(&vertices, surface.points), motion.clone())
            });
        }
        for condition in &self.forces {
            let vertices = surface.vertices(&condition.ids);
            if vertices.is_empty() {
                continue;
            }
            condition.is_used.set(true);
            let has_corners =
                |face: &&[u32; 3]| face.iter().all(|corner| vertices.binary_search(corner).is_ok());
            if surface.faces.iter().filter(has_corners).count() != surface.selected(&condition.ids).count() {
                let what = "a force on faces that share all their corners with a face without it";
                return Err(condition.entry.unsupported(what, "select both faces"));
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
        let Some(condition) = conditions
            .into_iter()
            .find(|condition| condition.ids.contain(Some(id)))
        else {
            return Ok(());
        };
        condition.is_used.set(true);
        let motion = condition.value.motion.clone();
        body.script.push(ScriptDescription::new(Selection::All, motion));
        Ok(())
    }

    /// The initial velocity of a body with an id.
    pub(super) fn velocity(&self, id: i64) -> Point {
        let mut velocities = self.velocities.iter();
        velocities
            .find(|condition| condition.ids.contain(Some(id)))
            .map_or([0.0; 3], |condition| {
                condition.is_used.set(true);
                condition.value
            })
    }

    /// Checks that all conditions apply to something.
    pub(super) fn check_use(&self) -> Result<(), Fault> {
        self.dirichlet
            .iter()
            .chain(&self.obstacles)
            .try_for_each(Condition::check_use)?;
        self.forces.iter().try_for_each(Condition::check_use)?;
        self.velocities.iter().try_for_each(Condition::check_use)
    }
}

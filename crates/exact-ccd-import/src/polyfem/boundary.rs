//! Boundary and initial conditions.

use std::cell::Cell;

use exact_ccd_mesh::Point;
use exact_ccd_sim::{Force, Script};

use super::entry::{Entry, NOTHING, Rule};
use super::motion::{Held, held};
use super::settings::Time;
use super::surface::{Ids, Surface};
use crate::fault::Fault;
use exact_ccd_scene::description::{Axis, BodyDescription, LoadDescription, ScriptDescription, Selection};

/// The conditions of a file.
pub(super) struct Conditions<'a> {
    /// The acceleration of gravity: `rhs` with the other sign.
    pub(super) gravity: Point,
    conditions: Vec<Condition<'a>>,
}

/// An effect on the faces or bodies with some ids.
struct Condition<'a> {
    entry: Entry<'a>,
    ids: Ids,
    effect: Effect<'a>,
    is_used: Cell<bool>,
}

enum Effect<'a> {
    /// The motion of an obstacle.
    Obstacle(Held<'a>),
    /// The motion of the vertices of faces.
    Faces(Held<'a>),
    /// A force on faces.
    Force(Force),
    /// The initial velocity of bodies.
    Velocity(Point),
}

impl<'a> Conditions<'a> {
    pub(super) fn parse(root: &Entry<'a>, time: &Time) -> Result<Self, Fault> {
        let mut conditions = Self {
            gravity: [0.0; 3],
            conditions: Vec::new(),
        };
        if let Some(boundary) = root.get("boundary_conditions") {
            conditions.boundary(&boundary, time)?;
        }
        if let Some(initial) = root.get("initial_conditions") {
            initial.check(&[("solution acceleration", NOTHING), ("velocity", Rule::Said)])?;
            conditions.add_all(&initial, "velocity", |entry| {
                entry.check(&[("id value", Rule::Said)])?;
                Ok(Effect::Velocity(entry.need("value")?.point()?))
            })?;
        }
        Ok(conditions)
    }

    fn boundary(&mut self, boundary: &Entry<'a>, time: &Time) -> Result<(), Fault> {
        boundary.check(&[
            (
                "rhs dirichlet_boundary obstacle_displacements neumann_boundary pressure_boundary",
                Rule::Said,
            ),
            (
                "normal_aligned_neumann_boundary pressure_cavity periodic_boundary",
                NOTHING,
            ),
        ])?;
        if let Some(rhs) = boundary.get_filled("rhs") {
            // `0.0 -` and not a negation, so that 0 stays 0.
            self.gravity = rhs.point()?.map(|component| 0.0 - component);
        }
        // Of two conditions of an obstacle, the first one counts.
        self.add_all(boundary, "obstacle_displacements", |entry| {
            Ok(Effect::Obstacle(held(entry, time)?))
        })?;
        self.add_all(boundary, "dirichlet_boundary", |entry| {
            Ok(Effect::Faces(held(entry, time)?))
        })?;
        let rules = [
            ("id value", Rule::Said),
            ("interpolation time_reference", NOTHING),
        ];
        self.add_all(boundary, "neumann_boundary", |entry| {
            entry.check(&rules)?;
            Ok(Effect::Force(Force::Traction(entry.need("value")?.point()?)))
        })?;
        self.add_all(boundary, "pressure_boundary", |entry| {
            entry.check(&rules)?;
            // PolyFEM's pressure acts along the normal (`PressureForm.cpp`).
            let pressure = 0.0 - entry.need("value")?.number()?;
            Ok(Effect::Force(Force::Pressure(pressure)))
        })
    }

    /// Adds the conditions in the list of a key.
    fn add_all(
        &mut self,
        parent: &Entry<'a>,
        key: &str,
        effect: impl Fn(&Entry<'a>) -> Result<Effect<'a>, Fault>,
    ) -> Result<(), Fault> {
        for entry in parent.get(key).iter().flat_map(Entry::list) {
            self.conditions.push(Condition {
                effect: effect(&entry)?,
                ids: Ids::parse(&entry.need("id")?)?,
                entry,
                is_used: Cell::new(false),
            });
        }
        Ok(())
    }

    /// Adds the scripts and loads of a body with these points.
    pub(super) fn apply(
        &self,
        body: &mut BodyDescription,
        surface: &Surface<'_>,
        points: &[Point],
    ) -> Result<(), Fault> {
        // For each vertex and axis, the script that holds it.
        let mut holding: Vec<[Option<Script>; 3]> = vec![[const { None }; 3]; points.len()];
        for condition in &self.conditions {
            let vertices = surface.vertices(&condition.ids);
            if vertices.is_empty() {
                continue;
            }
            let selection = Selection::of_vertices(&vertices, points);
            match &condition.effect {
                Effect::Faces(held) => {
                    let groups = if held.depends_on_place() {
                        vertices.iter().map(std::slice::from_ref).collect()
                    } else {
                        vec![&vertices[..]]
                    };
                    for group in groups {
                        let motion = held.script(points[group[0] as usize])?;
                        for &vertex in group {
                            let slots = holding[vertex as usize].iter_mut().zip(held.axes);
                            for (slot, _) in slots.filter(|(_, is_held)| *is_held) {
                                if slot.replace(motion.clone()).is_some_and(|other| other != motion) {
                                    let what =
                                        "a vertex that two conditions move along one axis in different ways";
                                    let instead = "let the faces of both have no vertex in common";
                                    return Err(condition.entry.unsupported(what, instead));
                                }
                            }
                        }
                        let names = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(held.axes);
                        body.script.push(ScriptDescription {
                            axes: names
                                .filter(|(_, is_held)| *is_held)
                                .map(|(axis, _)| axis)
                                .collect(),
                            ..ScriptDescription::new(Selection::of_vertices(group, points), motion)
                        });
                    }
                }
                Effect::Force(force) => {
                    let has_corners =
                        |face: &&[u32; 3]| face.iter().all(|corner| vertices.binary_search(corner).is_ok());
                    let covered = surface.faces.iter().filter(has_corners).count();
                    if covered != surface.selected(&condition.ids).count() {
                        let what = "a force on faces that share all their corners with a face without it";
                        return Err(condition.entry.unsupported(what, "select both faces"));
                    }
                    body.load.push(LoadDescription {
                        vertices: selection,
                        force: *force,
                        from: 0.0,
                        until: None,
                    });
                }
                Effect::Obstacle(_) | Effect::Velocity(_) => continue,
            }
            condition.is_used.set(true);
        }
        Ok(())
    }

    /// Adds the script of an obstacle with an id.
    pub(super) fn move_obstacle(&self, body: &mut BodyDescription, id: Option<i64>) -> Result<(), Fault> {
        let held = self.first(id, |effect| match effect {
            Effect::Obstacle(held) | Effect::Faces(held) => Some(held),
            _ => None,
        });
        if let Some(held) = held {
            let motion = held.script_of_all()?;
            body.script.push(ScriptDescription::new(Selection::All, motion));
        }
        Ok(())
    }

    /// The initial velocity of a body with an id.
    pub(super) fn velocity(&self, id: i64) -> Point {
        let velocity = self.first(Some(id), |effect| match effect {
            Effect::Velocity(velocity) => Some(velocity),
            _ => None,
        });
        velocity.copied().unwrap_or_default()
    }

    /// The first effect of a kind on an id.
    fn first<'b, T>(
        &'b self,
        id: Option<i64>,
        of_kind: impl Fn(&'b Effect<'a>) -> Option<&'b T>,
    ) -> Option<&'b T> {
        self.conditions.iter().find_map(|condition| {
            let effect = of_kind(&condition.effect).filter(|_| id.is_some() && condition.ids.contain(id))?;
            condition.is_used.set(true);
            Some(effect)
        })
    }

    /// Checks that all conditions apply to something.
    pub(super) fn check_use(&self) -> Result<(), Fault> {
        match self.conditions.iter().find(|condition| !condition.is_used.get()) {
            None => Ok(()),
            Some(Condition { entry, .. }) => {
                let instead =
                    "give an id to faces by `surface_selection`, and to bodies by `volume_selection`";
                Err(entry.unsupported("an id that no selection of the file gives", instead))
            }
        }
    }
}

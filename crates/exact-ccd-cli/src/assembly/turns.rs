//! Bodies that turn from a frame to the next one, while their vertices move in straight lines.

use exact_ccd_mesh::{Point, RigidFit};
use serde::{Deserialize, Serialize};

use super::Assembly;
use crate::messages::notes::Notes;

/// The connected components of a motion, and the step in which each body shrinks most.
pub(crate) struct Turns {
    /// The vertices of each component that moves and has an edge.
    components: Vec<Vec<u32>>,
    /// The worst turn of each body.
    worst: Vec<Option<Turn>>,
}

/// The turn of a component from a frame to the next one.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct Turn {
    frame: usize,
    vertex: u32,
    /// In radians.
    angle: f64,
    /// The number of steps that lose little ([`RigidFit::steps`]).
    steps: f64,
    /// Relative to the size of the component.
    shrinkage: f64,
    /// In the unit of the coordinates.
    shrinks_by: f64,
}

impl Turns {
    pub(crate) fn of(scene: &Assembly) -> Self {
        let moving = scene.moving_vertices();
        let of_vertices = scene.mesh().components();
        let mut vertices: Vec<u32> = moving.into_iter().flatten().collect();
        vertices.sort_unstable_by_key(|&vertex| (of_vertices[vertex as usize], vertex));
        let components = vertices.chunk_by(|&v, &w| of_vertices[v as usize] == of_vertices[w as usize]);
        let components = components.filter(|component| component.len() > 1);
        Self {
            components: components.map(<[u32]>::to_vec).collect(),
            worst: Vec::new(),
        }
    }

    /// The turns in the step that begins at a frame, the worst of each body.
    pub(crate) fn in_step(&self, scene: &Assembly, frame: usize, [x0, x1]: [&[Point]; 2]) -> Vec<Turn> {
        let mut worst = Vec::new();
        for component in &self.components {
            let at = |x: &[Point]| {
                component
                    .iter()
                    .map(|&vertex| x[vertex as usize])
                    .collect::<Vec<_>>()
            };
            let Some(fit) = RigidFit::new(&at(x0), &at(x1)) else {
                continue;
            };
            if fit.is_turn() {
                let turn = Turn {
                    frame,
                    vertex: component[0],
                    angle: fit.angle,
                    steps: fit.steps(),
                    shrinkage: fit.shrinkage,
                    shrinks_by: fit.shrinkage * fit.size,
                };
                keep_worst(&mut worst, scene, turn);
            }
        }
        worst.into_iter().flatten().collect()
    }

    /// Adds turns, of later steps than those before.
    pub(crate) fn add(&mut self, scene: &Assembly, turns: &[Turn]) {
        for turn in turns {
            keep_worst(&mut self.worst, scene, turn.clone());
        }
    }

    /// Adds a note for each body that turns, about the step in which it shrinks most.
    pub(crate) fn note(&self, scene: &Assembly, notes: &mut Notes) {
        for turn in self.worst.iter().flatten() {
            let Turn { frame, vertex, .. } = turn;
            let name = scene.component_name(*vertex);
            let (first, second) = (scene.frame_name(*frame), scene.frame_name(frame + 1));
            let (angle, percent, steps) = (turn.angle.to_degrees(), 100.0 * turn.shrinkage, turn.steps);
            notes.note(format!(
                "{name} turns by {angle:.1}° from frame {frame} ({first}) to frame {} ({second}) as a rigid body, but \
                 vertices move in straight lines: halfway, they are up to {percent:.1} % of its size too near to the \
                 axis, and the answer is about this smaller body; {steps} steps in place of this one keep that below \
                 0.1 %, and the library exact-ccd-curved decides rotations",
                frame + 1
            ));
        }
    }
}

/// Keeps a turn if its body does not shrink as much in another one.
fn keep_worst(worst: &mut Vec<Option<Turn>>, scene: &Assembly, turn: Turn) {
    let body = scene.names.body(turn.vertex);
    if worst.len() <= body {
        worst.resize_with(body + 1, || None);
    }
    let worst = &mut worst[body];
    if worst
        .as_ref()
        .is_none_or(|worst| turn.shrinks_by > worst.shrinks_by)
    {
        *worst = Some(turn);
    }
}

//! Bodies that turn from a frame to the next one, while their vertices move in straight lines.

use exact_ccd_mesh::{Point, RigidFit};

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
struct Turn {
    frame: usize,
    vertex: u32,
    fit: RigidFit,
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

    /// Adds the step that begins at a frame.
    pub(crate) fn add(&mut self, scene: &Assembly, frame: usize, [x0, x1]: [&[Point]; 2]) {
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
            let vertex = component[0];
            let body = scene.names.body(vertex);
            if self.worst.len() <= body {
                self.worst.resize_with(body + 1, || None);
            }
            let worst = &mut self.worst[body];
            let is_worse = |worst: &Turn| fit.shrinkage * fit.size > worst.fit.shrinkage * worst.fit.size;
            if fit.is_turn() && worst.as_ref().is_none_or(is_worse) {
                *worst = Some(Turn { frame, vertex, fit });
            }
        }
    }

    /// Adds a note for each body that turns, about the step in which it shrinks most.
    pub(crate) fn note(&self, scene: &Assembly, notes: &mut Notes) {
        for Turn { frame, vertex, fit } in self.worst.iter().flatten() {
            let name = scene.component_name(*vertex);
            let (first, second) = (scene.frame_name(*frame), scene.frame_name(frame + 1));
            let (angle, percent) = (fit.angle.to_degrees(), 100.0 * fit.shrinkage);
            let steps = fit.steps();
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

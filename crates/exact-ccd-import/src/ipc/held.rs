//! Prescribed motions of vertices, as scripts.

use exact_ccd_mesh::Point;
use nalgebra::{UnitQuaternion, Vector3};

use crate::fault::{Fault, Place, Problem};
use exact_ccd_scene::description::{ScriptDescription, Selection};
use exact_ccd_sim::{KeyFrame, Script};

/// A motion of vertices at constant velocity, at times from `from` to before `until`.
#[derive(Clone, Debug)]
pub(super) struct Piece<V = Vec<u32>> {
    pub(super) place: Place,
    /// The vertices, increasing.
    pub(super) vertices: V,
    pub(super) linear: Point,
    /// In each time step h, the rotation about z by its component times h, then about y, then about x.
    pub(super) angular: Point,
    pub(super) from: f64,
    pub(super) until: f64,
}

impl<V> Piece<V> {
    /// The same motion of these vertices, within these times.
    pub(super) fn of(&self, vertices: Vec<u32>, [from, until]: [f64; 2]) -> Piece {
        Piece {
            place: self.place.clone(),
            vertices,
            linear: self.linear,
            angular: self.angular,
            from: self.from.max(from).max(0.0),
            until: self.until.min(until),
        }
    }
}

impl Piece {
    pub(super) fn turns(&self) -> bool {
        self.angular != [0.0; 3]
    }

    /// The axis of length 1 and the angular velocity about it, of the rotations of successive time steps.
    fn turn(&self, time_step: f64) -> Option<(Vector3<f64>, f64)> {
        let angular = Vector3::from(self.angular);
        let mut components = self.angular.iter().enumerate().filter(|(_, rate)| **rate != 0.0);
        match (components.next(), components.next()) {
            (None, _) => None,
            (Some((axis, rate)), None) => Some((Vector3::ith(axis, 1.0), *rate)),
            _ => {
                let about = |axis: usize| UnitQuaternion::new(Vector3::ith(axis, angular[axis] * time_step));
                let (axis, angle) = (about(0) * about(1) * about(2)).axis_angle()?;
                Some((axis.into_inner(), angle / time_step))
            }
        }
    }

    /// The script of this motion, about a center at its start, for the time step and the duration of a scene.
    pub(super) fn script(
        &self,
        vertices: Selection,
        center: Point,
        [time_step, duration]: [f64; 2],
    ) -> ScriptDescription {
        let motion = match (self.turn(time_step), self.linear == [0.0; 3]) {
            (None, true) => Script::Fixed,
            (None, false) => Script::Moving {
                velocity: self.linear,
                until: None,
            },
            (Some((axis, rate)), true) => Script::Twisting {
                center,
                axis: axis.into(),
                rate,
                until: None,
            },
            (Some((axis, rate)), false) => {
                let end = self.until.min(duration.max(self.from));
                let frame = |time: f64| KeyFrame {
                    time,
                    translate: self.linear.map(|velocity| velocity * (time - self.from)),
                    degrees: (rate * (time - self.from)).to_degrees(),
                };
                let frames = [self.from, end].map(frame).to_vec();
                Script::KeyFrames {
                    frames: if self.from < end {
                        frames
                    } else {
                        vec![frame(self.from)]
                    },
                    center,
                    axis: axis.into(),
                }
            }
        };
        ScriptDescription {
            from: self.from,
            release: Some(self.until).filter(|until| *until < duration),
            ..ScriptDescription::new(vertices, motion)
        }
    }
}

/// The distance by which the center of the vertices of the last piece has moved when it begins. The pieces
/// are in the order of their starts.
///
/// # Errors
/// The last piece has a vertex in common with another one at the same time, or it turns vertices whose center
/// is not known.
pub(super) fn moved(pieces: &[Piece]) -> Result<Vector3<f64>, Fault> {
    let mut moved = Vector3::zeros();
    let Some((last, before)) = pieces.split_last() else {
        return Ok(moved);
    };
    let mut held_until = 0.0;
    let mut is_known = true;
    for piece in before {
        let is_shared = |vertex: &u32| last.vertices.binary_search(vertex).is_ok();
        if !piece.vertices.iter().any(is_shared) {
            continue;
        }
        if piece.until > last.from {
            let what = "a vertex in two boxes at the same time, of which IPC adds the motions,";
            let instead = "separate the boxes or their times";
            return Err(Problem::unsupported(what, instead).at(&last.place));
        }
        is_known &= piece.vertices == last.vertices && piece.from == held_until;
        held_until = piece.until;
        moved += Vector3::from(piece.linear) * (piece.until - piece.from);
    }
    is_known &= held_until == last.from;
    if last.turns() && !is_known {
        let what = "a rotation of vertices that were free, or that moved in other boxes, about their center";
        let instead = "let the times of the motions of a box follow each other, from 0";
        return Err(Problem::unsupported(what, instead).at(&last.place));
    }
    Ok(moved)
}

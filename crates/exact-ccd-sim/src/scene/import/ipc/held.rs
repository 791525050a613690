//! Prescribed motions of vertices that follow each other in time.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Vector3};

use super::super::fault::{Fault, Place, Problem};
use super::file::File;
use crate::scene::description::{ScriptDescription, Selection};
use crate::script::{KeyFrame, Script};

/// A motion at constant velocity, at times from `from` to before `until`.
pub(super) struct Piece {
    pub(super) place: Place,
    pub(super) linear: Point,
    /// In each time step h, the rotation about z by its component times h, then about y, then about x.
    pub(super) angular: Point,
    pub(super) from: f64,
    pub(super) until: f64,
}

impl Piece {
    pub(super) fn endless(place: Place, linear: Point, angular: Point) -> Self {
        Self {
            place,
            linear,
            angular,
            from: 0.0,
            until: f64::INFINITY,
        }
    }

    /// The axis of length 1 and the angular velocity about it, of the rotations of successive time steps.
    fn turn(&self, time_step: f64) -> Option<(Vector3<f64>, f64)> {
        let angular = Vector3::from(self.angular);
        let mut components = self.angular.iter().enumerate().filter(|(_, rate)| **rate != 0.0);
        match (components.next(), components.next()) {
            (None, _) => None,
            (Some((axis, rate)), None) => Some((Vector3::ith(axis, 1.0), *rate)),
            _ => {
                let about = |axis: usize| Rotation3::new(Vector3::ith(axis, angular[axis] * time_step));
                let (axis, angle) = (about(0) * about(1) * about(2)).axis_angle()?;
                Some((axis.into_inner(), angle / time_step))
            }
        }
    }
}

/// The script of a selection that moves by these pieces, about this center at the start.
pub(super) fn script(
    vertices: Selection,
    pieces: &[Piece],
    center: Point,
    file: &File,
) -> Result<ScriptDescription, Fault> {
    let mut sorted: Vec<&Piece> = pieces.iter().collect();
    sorted.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut end = None;
    for piece in &sorted {
        if end.map_or(piece.from > 0.0, |end| piece.from != end) {
            let what = format!(
                "a motion from {} s, of vertices that are free or held by another one before,",
                piece.from
            );
            let instead = "let the times of the motions of a box follow each other, from 0";
            return Err(Problem::unsupported(what, instead).at(&piece.place));
        }
        end = Some(piece.until);
    }
    let release = end.filter(|end| *end < file.duration);
    let motion = motion(&sorted, center, file)?;
    Ok(ScriptDescription {
        release,
        ..ScriptDescription::new(vertices, motion)
    })
}

fn motion(pieces: &[&Piece], center: Point, file: &File) -> Result<Script, Fault> {
    let turns: Vec<Option<(Vector3<f64>, f64)>> =
        pieces.iter().map(|piece| piece.turn(file.time_step)).collect();
    if let ([piece], [turn]) = (pieces, &turns[..]) {
        match (turn, piece.linear == [0.0; 3]) {
            (None, true) => return Ok(Script::Fixed),
            (None, false) => {
                return Ok(Script::Moving {
                    velocity: piece.linear,
                    until: None,
                });
            }
            (Some((axis, rate)), true) => {
                return Ok(Script::Twisting {
                    center,
                    axis: (*axis).into(),
                    rate: *rate,
                    until: None,
                });
            }
            (Some(_), false) => {}
        }
    }
    let axis = turns
        .iter()
        .flatten()
        .next()
        .map_or(Vector3::y(), |(axis, _)| *axis);
    let mut state = KeyFrame {
        time: 0.0,
        translate: [0.0; 3],
        degrees: 0.0,
    };
    let mut frames = vec![state];
    for (piece, turn) in pieces.iter().zip(&turns) {
        let rate = match turn {
            None => 0.0,
            Some((other, rate)) if *other == axis => *rate,
            Some((other, rate)) if *other == -axis => -rate,
            Some(_) => {
                let what = "successive rotations about different axes";
                return Err(Problem::unsupported(what, "write one axis").at(&piece.place));
            }
        };
        let until = piece.until.min(file.duration);
        let length = until - state.time;
        if length > 0.0 {
            let moved = Vector3::from(state.translate) + Vector3::from(piece.linear) * length;
            state = KeyFrame {
                time: until,
                translate: moved.into(),
                degrees: state.degrees + (rate * length).to_degrees(),
            };
            frames.push(state);
        }
    }
    Ok(Script::KeyFrames {
        frames,
        center,
        axis: axis.into(),
    })
}

//! The motion of nodes by an animation that translates them.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;

use super::accessor::Accessors;
use super::document::{Animation, Document, Interpolation, at};
use crate::error::{Fault, Place};
use crate::note::{Fact, Note};

/// The translations of nodes at each time. Nodes keep their rotation and scale.
#[derive(Debug, Default)]
pub(super) struct Motion {
    tracks: Vec<Track>,
    moments: Vec<Moment>,
    /// Rotations and scales that an animation sets, the same ones at all times.
    pub(super) rotations: BTreeMap<u32, [f64; 4]>,
    pub(super) scales: BTreeMap<u32, [f64; 3]>,
}

/// The translations of a node at its keys, of which there is one at least. Times increase.
#[derive(Debug)]
struct Track {
    node: u32,
    times: Vec<f64>,
    values: Vec<Point>,
    /// A value holds until the next key. Otherwise, values between keys are on the straight line.
    holds: bool,
}

/// A time of a frame. At a jump, there are two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Moment {
    time: f64,
    is_before_jump: bool,
}

const FRAMES: &str = "the meshes are at rest; export each frame as OBJ or PLY with the same vertices, or leave out \
                      the animation";

impl Motion {
    /// The motion by the animation of a file, if it translates nodes only; otherwise, a note about it.
    /// `moves` is true for the nodes of meshes and the nodes above them.
    pub(super) fn read(accessors: &Accessors, moves: &[bool]) -> Result<(Self, Option<Note>), Fault> {
        let animations = &accessors.document.animations;
        let is_relevant = |animation: &&Animation| targets(animation, moves).next().is_some();
        let relevant: Vec<&Animation> = animations.iter().filter(is_relevant).collect();
        let not_read = |part: String, remedy| {
            Ok((
                Self::default(),
                Some(Fact::not_read(part, remedy).at(Place::File)),
            ))
        };
        match relevant[..] {
            [] => Ok((Self::default(), None)),
            [animation] => match Self::of(animation, accessors, moves)? {
                Ok(motion) => {
                    let jumps = motion.moments.iter().any(|moment| moment.is_before_jump);
                    Ok((motion, jumps.then(|| Fact::Jumps.at(Place::File))))
                }
                Err(part) => not_read(part, FRAMES),
            },
            _ => {
                let part = format!("{} animations", relevant.len());
                not_read(
                    part,
                    "the meshes are at rest; export one animation, or each frame as OBJ or PLY",
                )
            }
        }
    }

    /// The motion by an animation, or the part of it that is not read.
    fn of(
        animation: &Animation,
        accessors: &Accessors,
        moves: &[bool],
    ) -> Result<Result<Self, String>, Fault> {
        let mut motion = Self::default();
        for (node, path, sampler) in targets(animation, moves) {
            let sampler = at(&animation.samplers, sampler, "sampler")?;
            if at(&accessors.document.nodes, node, "node")?.matrix.is_some() {
                let expected = format!("no matrix of node {node}, which is animated");
                return Err(Fault::expected(expected, "one"));
            }
            let is_spline = sampler.interpolation == Interpolation::CubicSpline;
            let unread = Ok(Err(format!("the animation of the {path} of node {node}")));
            match path {
                "translation" if !is_spline => motion.tracks.push(Track {
                    node,
                    times: accessors.times(sampler.input)?,
                    values: accessors.vectors(sampler.output, "VEC3", "three numbers of a translation")?,
                    holds: sampler.interpolation == Interpolation::Step,
                }),
                "rotation" if !is_spline => {
                    let values = accessors.vectors(sampler.output, "VEC4", "four numbers of a rotation")?;
                    let Some(value) = constant(&values) else {
                        return unread;
                    };
                    motion.rotations.insert(node, value);
                }
                "scale" if !is_spline => {
                    let values = accessors.vectors(sampler.output, "VEC3", "three numbers of a scale")?;
                    let Some(value) = constant(&values) else {
                        return unread;
                    };
                    motion.scales.insert(node, value);
                }
                // Without morph targets, which are refused, weights have no effect.
                "weights" => {}
                _ => return unread,
            }
        }
        for Track {
            times, values, node, ..
        } in &motion.tracks
        {
            if times.is_empty() || times.len() != values.len() {
                let expected = format!("a translation of node {node} at each of {} keys", times.len());
                return Err(Fault::expected(expected, values.len().to_string()));
            }
        }
        motion.moments = moments(&motion.tracks);
        Ok(Ok(motion))
    }

    pub(super) fn frame_count(&self) -> usize {
        self.moments.len().max(1)
    }

    /// The time of a frame, if there is a motion.
    pub(super) fn time(&self, frame: usize) -> Option<f64> {
        Some(self.moments.get(frame)?.time)
    }

    /// The translation of each node that is animated.
    pub(super) fn translations(&self, frame: usize) -> BTreeMap<u32, Point> {
        let Some(&moment) = self.moments.get(frame) else {
            return BTreeMap::new();
        };
        self.tracks
            .iter()
            .map(|track| (track.node, track.value(moment)))
            .collect()
    }
}

/// The node, the path and the sampler of each channel of an animation that may move a mesh.
fn targets<'a>(animation: &'a Animation, moves: &'a [bool]) -> impl Iterator<Item = (u32, &'a str, u32)> {
    animation.channels.iter().filter_map(|channel| {
        let node = channel.target.node?;
        let moves_mesh = moves.get(node as usize).copied().unwrap_or(false);
        moves_mesh.then_some((node, &*channel.target.path, channel.sampler))
    })
}

/// The value of all keys, if it is the same one.
fn constant<T: Copy + PartialEq>(values: &[T]) -> Option<T> {
    let (&first, rest) = values.split_first()?;
    rest.iter().all(|value| *value == first).then_some(first)
}

/// The times of all keys in their order. Motions between them are straight.
fn moments(tracks: &[Track]) -> Vec<Moment> {
    let mut times: Vec<f64> = tracks.iter().flat_map(|track| &track.times).copied().collect();
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let moment = |time| {
        let [before, after] = [true, false].map(|is_before_jump| Moment { time, is_before_jump });
        let jumps = tracks
            .iter()
            .any(|track| track.holds && track.value(before) != track.value(after));
        [jumps.then_some(before), Some(after)]
    };
    times.into_iter().flat_map(moment).flatten().collect()
}

impl Track {
    /// The translation at a moment: that of the first key before it, that of the last key after it.
    ///
    /// Between two keys of a straight motion it is a + (b − a) s with s = (t − tₐ) / (t_b − tₐ), each
    /// operation rounded to nearest.
    fn value(&self, Moment { time, is_before_jump }: Moment) -> Point {
        let is_passed = |key: &f64| if is_before_jump { *key < time } else { *key <= time };
        let passed = self.times.partition_point(is_passed);
        let Some(last) = passed.checked_sub(1) else {
            return self.values[0];
        };
        let (start, a) = (self.times[last], self.values[last]);
        match (self.times.get(passed), self.values.get(passed)) {
            (Some(end), Some(b)) if !self.holds && start < time => {
                let s = (time - start) / (end - start);
                std::array::from_fn(|k| a[k] + (b[k] - a[k]) * s)
            }
            _ => a,
        }
    }
}

/// Sets the constant rotations and scales of a motion in a document.
pub(super) fn pose(document: &mut Document, motion: &Motion) {
    for (&node, rotation) in &motion.rotations {
        document.nodes[node as usize].rotation = Some(Box::new(*rotation));
    }
    for (&node, scale) in &motion.scales {
        document.nodes[node as usize].scale = Some(Box::new(*scale));
    }
}

//! The answer of the repair of a recording.

use std::fmt;

use exact_ccd_mesh::TriangleMesh;
use exact_ccd_repair::{Blocked, Change, Recording};
use serde::Serialize;

use super::remaining::{Pairs, Remaining};
use crate::assembly::Assembly;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct RecordingAnswer {
    /// The number of frames.
    frames: usize,
    /// The repaired frames, from the first one on. The motion between them is certified.
    repaired_frames: Vec<Displaced>,
    /// The frame for which no free motion was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    blocked: Option<BlockedFrame>,
}

/// The displacement of a frame, relative to the diagonal of its box.
#[derive(Serialize)]
struct Displaced {
    file: String,
    mean: f64,
    max: f64,
}

#[derive(Serialize)]
struct BlockedFrame {
    frame: usize,
    file: String,
    /// The numbers of pairs.
    pairs: Pairs,
    #[serde(flatten)]
    remaining: Remaining,
}

impl RecordingAnswer {
    /// The answer for the frames that were repaired. `is_stopped`: the time was spent, so that no pairs are
    /// the reason.
    pub(super) fn new(
        scene: &Assembly,
        mesh: &TriangleMesh,
        recording: &Recording,
        is_stopped: bool,
    ) -> Self {
        let displaced = |(frame, change): (usize, &Change)| Displaced {
            file: scene.frame_name(frame),
            mean: change.mean_displacement,
            max: change.max_displacement,
        };
        let blocked = recording.blocked.as_ref().filter(|_| !is_stopped);
        let named = |blocked: &Blocked| BlockedFrame {
            frame: blocked.frame,
            file: scene.frame_name(blocked.frame),
            pairs: Pairs::of(&blocked.crossings, &blocked.contacts),
            remaining: Remaining::new(scene, mesh, &blocked.crossings, &blocked.contacts),
        };
        Self {
            frames: scene.frame_count(),
            repaired_frames: recording.changes.iter().enumerate().map(displaced).collect(),
            blocked: blocked.map(named),
        }
    }

    pub(super) fn is_repaired(&self) -> bool {
        self.repaired_frames.len() == self.frames
    }

    /// The line of the text that has the answer.
    fn verdict(&self) -> String {
        match &self.blocked {
            Some(BlockedFrame { frame: 0, file, .. }) => {
                format!("not repaired: no free positions were found for frame 0 ({file})")
            }
            Some(BlockedFrame { frame, file, .. }) => {
                format!("not repaired: no free motion was found to frame {frame} ({file})")
            }
            None if self.is_repaired() => {
                "repaired: all frames and the straight motion between them are certified to be free of contact".to_owned()
            }
            None => format!(
                "not repaired: --max-seconds ended it before frame {}",
                self.repaired_frames.len()
            ),
        }
    }
}

/// The text on a terminal.
impl fmt::Display for RecordingAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.verdict())?;
        if let Some(BlockedFrame { pairs, remaining, .. }) = &self.blocked {
            write!(f, "pairs in the way: {pairs}\n{remaining}")?;
        }
        writeln!(
            f,
            "frames: {} of {} repaired",
            self.repaired_frames.len(),
            self.frames
        )?;
        for (frame, Displaced { file, mean, max }) in self.repaired_frames.iter().enumerate() {
            writeln!(
                f,
                "  frame {frame} ({file}): moved by {mean:.5} of the diagonal in the mean, {max:.5} at most"
            )?;
        }
        Ok(())
    }
}

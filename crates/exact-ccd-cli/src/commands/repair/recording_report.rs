//! The report of the repair of a recording.

use std::fmt;

use exact_ccd_mesh::TriangleMesh;
use exact_ccd_repair::{Blocked, Change, Recording};
use serde::Serialize;

use super::remaining::{Pairs, Remaining};
use crate::assembly::{Assembly, Summary};
use crate::messages::notes::Notes;
use crate::options::distances::Distances;
use crate::text::json::to_json;
use crate::text::seconds::Seconds;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(super) notes: Notes,
    #[serde(flatten)]
    distances: Distances,
    pub(super) repaired: bool,
    /// The number of frames.
    frames: usize,
    /// The repaired frames, from the first one on. The motion between them is certified.
    repaired_frames: Vec<Displaced>,
    /// The frame for which no free motion was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    blocked: Option<BlockedFrame>,
    /// The folder that was written.
    pub(super) output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) seconds: Option<Seconds>,
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

impl Report {
    /// The report of a recording that is not repaired.
    pub(super) fn new(scene: &Assembly, notes: Notes, distances: Distances) -> Self {
        Self {
            summary: scene.summary(),
            notes,
            distances,
            repaired: false,
            frames: scene.frame_count(),
            repaired_frames: Vec::new(),
            blocked: None,
            output: None,
            seconds: None,
        }
    }

    /// Adds the repaired frames. `is_stopped`: the time was spent, so that no pairs are the reason.
    pub(super) fn add(
        &mut self,
        scene: &Assembly,
        mesh: &TriangleMesh,
        recording: &Recording,
        is_stopped: bool,
    ) {
        let displaced = |(frame, change): (usize, &Change)| Displaced {
            file: scene.frame_name(frame),
            mean: change.mean_displacement,
            max: change.max_displacement,
        };
        self.repaired = recording.frames.len() == self.frames;
        self.repaired_frames = recording.changes.iter().enumerate().map(displaced).collect();
        let blocked = recording.blocked.as_ref().filter(|_| !is_stopped);
        let named = |blocked: &Blocked| BlockedFrame {
            frame: blocked.frame,
            file: scene.frame_name(blocked.frame),
            pairs: Pairs::of(&blocked.crossings, &blocked.contacts),
            remaining: Remaining::new(scene, mesh, &blocked.crossings, &blocked.contacts),
        };
        self.blocked = blocked.map(named);
    }

    pub(super) fn text(&self, is_json: bool) -> String {
        if is_json {
            to_json("repair", self)
        } else {
            self.to_string().trim_end().to_owned()
        }
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
            None if self.repaired => {
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
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.summary, self.distances)?;
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
        if let Some(output) = &self.output {
            writeln!(f, "written: {output}")?;
        }
        self.seconds
            .iter()
            .try_for_each(|seconds| writeln!(f, "{seconds}"))
    }
}

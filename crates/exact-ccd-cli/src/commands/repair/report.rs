//! The report of a repair, of a mesh or of a recording.

use std::fmt::{self, Display};

use serde::Serialize;

use crate::assembly::{Assembly, Summary};
use crate::messages::notes::Notes;
use crate::options::distances::Distances;
use crate::text::json::to_json;
use crate::text::seconds::Seconds;

/// A report around an answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report<A> {
    #[serde(flatten)]
    summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(super) notes: Notes,
    #[serde(flatten)]
    distances: Distances,
    pub(super) repaired: bool,
    #[serde(flatten)]
    pub(super) answer: A,
    /// The file or the folder that was written.
    pub(super) output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) seconds: Option<Seconds>,
}

impl<A: Display + Serialize> Report<A> {
    /// The report of an answer that is not written yet.
    pub(super) fn new(
        scene: &Assembly,
        notes: Notes,
        distances: Distances,
        repaired: bool,
        answer: A,
    ) -> Self {
        Self {
            summary: scene.summary(),
            notes,
            distances,
            repaired,
            answer,
            output: None,
            seconds: None,
        }
    }

    pub(super) fn text(&self, is_json: bool) -> String {
        if is_json {
            to_json("repair", self)
        } else {
            self.to_string().trim_end().to_owned()
        }
    }
}

/// The text on a terminal.
impl<A: Display> Display for Report<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.summary, self.distances, self.answer)?;
        if let Some(output) = &self.output {
            writeln!(f, "written: {output}")?;
        }
        self.seconds
            .iter()
            .try_for_each(|seconds| writeln!(f, "{seconds}"))
    }
}

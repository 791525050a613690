//! Notes beside an answer: facts about the input that change its meaning.

use std::io::Write;

use serde::Serialize;

/// Notes in the order in which they came up. Each is printed on standard error, and is in JSON reports.
#[derive(Default, Serialize)]
#[serde(transparent)]
pub(crate) struct Notes(Vec<String>);

impl Notes {
    /// A fact.
    pub(crate) fn note(&mut self, text: String) {
        self.add("note", text);
    }

    /// A fact that is probably a fault of the input.
    pub(crate) fn warn(&mut self, text: String) {
        self.add("warning", text);
    }

    fn add(&mut self, kind: &str, text: String) {
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: {kind}: {text}");
        self.0.push(text);
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

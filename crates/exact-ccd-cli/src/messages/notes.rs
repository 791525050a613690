//! Notes beside an answer: facts about the input that change its meaning.

use std::io::Write;

use serde::Serialize;

/// Notes in the order in which they came up. Each is printed on standard error, and is in JSON reports.
#[derive(Default, Serialize)]
#[serde(transparent)]
pub(crate) struct Notes {
    texts: Vec<String>,
    #[serde(skip)]
    are_unprinted: bool,
}

impl Notes {
    /// Notes that are not printed.
    pub(crate) fn unprinted() -> Self {
        Self {
            are_unprinted: true,
            ..Self::default()
        }
    }

    /// A fact.
    pub(crate) fn note(&mut self, text: String) {
        self.add("note", text);
    }

    /// A fact that is probably a fault of the input.
    pub(crate) fn warn(&mut self, text: String) {
        self.add("warning", text);
    }

    fn add(&mut self, kind: &str, text: String) {
        if !self.are_unprinted {
            // An error of standard error itself cannot be reported.
            let _ = writeln!(std::io::stderr(), "exact-ccd: {kind}: {text}");
        }
        self.texts.push(text);
    }

    pub(crate) fn into_texts(self) -> Vec<String> {
        self.texts
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }
}

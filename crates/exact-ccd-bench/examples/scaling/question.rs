//! The questions about a step.

use std::hint::black_box;

use exact_ccd::CONTACT;
use exact_ccd_mesh::{Bvh, Detector, Step, StepReport};

/// A question about a whole step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Question {
    Report,
    Earliest,
    Free,
}

impl Question {
    pub(crate) const ALL: [Self; 3] = [Self::Report, Self::Earliest, Self::Free];

    /// One word, as an argument.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Report => "report",
            Self::Earliest => "earliest",
            Self::Free => "free",
        }
    }

    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|question| question.word() == word)
    }

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Report => "all contacts",
            Self::Earliest => "earliest contact",
            Self::Free => "free of contact?",
        }
    }

    /// The least distance of the sheets. They come into contact except for the last question, which
    /// would not examine all candidates if there were contact.
    pub(crate) fn nearest(self) -> f64 {
        match self {
            Self::Report | Self::Earliest => 0.1,
            Self::Free => 0.45,
        }
    }

    /// Answers with a detector that has no memory of earlier steps.
    pub(crate) fn answer(self, step: Step<'_>, mut detector: Detector) {
        let [x0, x1] = step.positions();
        match self {
            Self::Report => drop(black_box(StepReport::new(step, &Bvh, &|_| ()))),
            Self::Earliest => drop(black_box(detector.collision(x0, x1, CONTACT))),
            Self::Free => drop(black_box(detector.collides(x0, x1, CONTACT))),
        }
    }
}

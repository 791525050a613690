//! Parts of the step.

/// A part of the step, from k 2⁻ⁿ to (k + 1) 2⁻ⁿ: both times are exact, and so are their differences from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) start: f64,
    pub(super) end: f64,
    level: u32,
}

/// The most halvings of the step.
const LEVELS: u32 = 30;

impl Part {
    pub(super) const WHOLE: Self = Self {
        start: 0.0,
        end: 1.0,
        level: 0,
    };

    /// The halves, unless the part is as short as parts get.
    pub(super) fn halves(self) -> Option<[Self; 2]> {
        let middle = 0.5 * (self.start + self.end);
        let half = |start, end| Self {
            start,
            end,
            level: self.level + 1,
        };
        (self.level < LEVELS).then(|| [half(self.start, middle), half(middle, self.end)])
    }

    pub(super) fn length(self) -> f64 {
        self.end - self.start
    }
}

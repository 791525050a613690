//! The times of one part of a time step.

/// A part of a time step. Scripts and loads act in a time step if they act at this part before its end, so
/// that rounding errors of times do not shift them by a time step. It is smaller than the shortest part of a
/// step.
const BEFORE_END: f64 = 1e-8;

/// One of the equal parts of a time step, with its times in s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Times {
    /// The number of the time step, from 1.
    pub(crate) step: u64,
    /// The number of the part, from 1, and the number of parts.
    pub(crate) part: [usize; 2],
    pub(crate) duration: f64,
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The moments shortly before the start and before the end. Scripts and loads act in the part if they
    /// act at the second one. They begin in it if they begin between both.
    pub(crate) moments: [f64; 2],
}

impl Times {
    /// The times of a part, counted from 1, of the time step after `steps` others.
    pub(crate) fn new(steps: u64, time_step: f64, [part, parts]: [usize; 2]) -> Self {
        let end = |part: usize| (steps as f64 + part as f64 / parts as f64) * time_step;
        let [start, end] = [end(part - 1), end(part)];
        Self {
            step: steps + 1,
            part: [part, parts],
            duration: time_step / parts as f64,
            start,
            end,
            moments: [start, end].map(|time| time - BEFORE_END * time_step),
        }
    }
}

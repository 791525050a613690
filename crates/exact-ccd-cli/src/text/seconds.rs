//! The durations of the phases of a command.

use std::time::{Duration, Instant};
use std::{fmt, mem};

use serde::{Serialize, Serializer};

/// A clock that is read at the end of each phase, and the durations of the phases so far.
#[derive(Clone)]
pub(crate) struct Seconds {
    last: Instant,
    phases: Vec<(&'static str, Duration)>,
}

impl Seconds {
    /// The clock at the beginning of the first phase.
    pub(crate) fn begin() -> Self {
        Self {
            last: Instant::now(),
            phases: Vec::new(),
        }
    }

    /// The time since the clock was read last.
    pub(crate) fn lap(&mut self) -> Duration {
        let now = Instant::now();
        now - mem::replace(&mut self.last, now)
    }

    /// Adds the time since the clock was read last to a phase.
    pub(crate) fn end(&mut self, phase: &'static str) {
        let duration = self.lap();
        self.add(phase, duration);
    }

    /// Adds a duration to a phase.
    pub(crate) fn add(&mut self, phase: &'static str, duration: Duration) {
        match self.phases.iter_mut().find(|(name, _)| *name == phase) {
            Some((_, sum)) => *sum += duration,
            None => self.phases.push((phase, duration)),
        }
    }

    /// The names of the phases with their durations in s, then the total.
    fn all(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let total = self.phases.iter().map(|(_, duration)| *duration).sum();
        let all = self.phases.iter().copied().chain([("total", total)]);
        all.map(|(name, duration)| (name, duration.as_secs_f64()))
    }
}

impl Serialize for Seconds {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.all())
    }
}

/// A line of text.
impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let phases = self.all().map(|(name, seconds)| format!("{seconds:.3} {name}"));
        write!(f, "seconds: {}", phases.collect::<Vec<_>>().join(", "))
    }
}

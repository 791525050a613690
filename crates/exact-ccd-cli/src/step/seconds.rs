//! The durations of a step.

use std::fmt;
use std::time::{Duration, Instant};

use serde::Serialize;

/// A clock that is read at the end of each phase.
pub(super) struct Laps(Instant);

impl Laps {
    /// The clock at the beginning of the first phase.
    pub(super) fn begin() -> Self {
        Self(Instant::now())
    }

    /// The duration of the phase that ends now, since the end of the phase before it.
    pub(super) fn lap(&mut self) -> Duration {
        let now = Instant::now();
        now - std::mem::replace(&mut self.0, now)
    }
}

/// The durations of the phases, in s, and their sum. Those that the command line does not ask for are absent.
#[derive(Serialize)]
pub(super) struct Seconds {
    read: f64,
    start: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    half_spaces: Option<f64>,
    broad: f64,
    narrow: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    list: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    write: Option<f64>,
    total: f64,
}

/// The durations, as they are measured.
#[derive(Clone, Copy, Default)]
pub(super) struct Phases {
    pub(super) read: Duration,
    /// The examination of the start.
    pub(super) start: Duration,
    pub(super) half_spaces: Option<Duration>,
    /// The search for contact, both phases.
    pub(super) search: Duration,
    /// The share of the narrow phase in the search.
    pub(super) narrow: Duration,
    /// The search for all contacts, for files.
    pub(super) list: Option<Duration>,
    /// The writing of files.
    pub(super) write: Option<Duration>,
}

impl From<Phases> for Seconds {
    fn from(phases: Phases) -> Self {
        let Phases {
            read,
            start,
            half_spaces,
            search,
            narrow,
            list,
            write,
        } = phases;
        let optional = [half_spaces, list, write];
        let total = read + start + search + optional.into_iter().flatten().sum::<Duration>();
        let seconds = |duration: Duration| duration.as_secs_f64();
        let [half_spaces, list, write] = optional.map(|duration| duration.map(seconds));
        Self {
            read: seconds(read),
            start: seconds(start),
            half_spaces,
            broad: seconds(search.saturating_sub(narrow)),
            narrow: seconds(narrow.min(search)),
            list,
            write,
            total: seconds(total),
        }
    }
}

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let phases = [
            (Some(self.read), "reading"),
            (Some(self.start), "start"),
            (self.half_spaces, "half spaces"),
            (Some(self.broad), "broad phase"),
            (Some(self.narrow), "narrow phase"),
            (self.list, "listing"),
            (self.write, "writing"),
        ];
        f.write_str("seconds: ")?;
        for (seconds, name) in phases {
            if let Some(seconds) = seconds {
                write!(f, "{seconds:.3} {name}, ")?;
            }
        }
        write!(f, "{:.3} in total", self.total)
    }
}

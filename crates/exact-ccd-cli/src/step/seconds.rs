//! The durations of a step.

use std::fmt;
use std::time::Duration;

use serde::Serialize;

/// The durations of the phases.
#[derive(Serialize)]
pub(super) struct Seconds {
    read: f64,
    start: f64,
    broad: f64,
    narrow: f64,
    pub(super) total: f64,
}

impl Seconds {
    /// The durations, from that of reading, that of the examination of the start, that of all the
    /// rest, and the narrow phase's share of the rest.
    pub(super) fn new(read: Duration, start: Duration, rest: Duration, narrow: Duration) -> Self {
        let [read, start, rest, narrow] = [read, start, rest, narrow].map(|time| time.as_secs_f64());
        Self {
            read,
            start,
            broad: (rest - narrow).max(0.0),
            narrow,
            total: read + start + rest,
        }
    }
}

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "seconds: {:.3} reading, {:.3} start, {:.3} broad phase, {:.3} narrow phase, {:.3} in total",
            self.read, self.start, self.broad, self.narrow, self.total
        )
    }
}

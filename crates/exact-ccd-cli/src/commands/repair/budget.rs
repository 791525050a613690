//! The time after which a repair ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::messages::failure::Failure;

/// The time of the option `--max-seconds`.
pub(super) struct Budget {
    began: Instant,
    time: Option<Duration>,
    is_spent: AtomicBool,
}

impl Budget {
    /// This time in seconds, from now on.
    pub(super) fn begin(seconds: Option<f64>) -> Result<Self, Failure> {
        let time = seconds.map(Duration::try_from_secs_f64).transpose();
        Ok(Self {
            began: Instant::now(),
            time: time.map_err(|error| Failure::new(format_args!("--max-seconds: {error}")))?,
            is_spent: AtomicBool::new(false),
        })
    }

    /// Returns true if the time is spent.
    pub(super) fn stops(&self) -> bool {
        let stops = self.time.is_some_and(|time| self.began.elapsed() >= time);
        self.is_spent.fetch_or(stops, Ordering::Relaxed);
        stops
    }

    /// Returns true if the repair was told to end.
    pub(super) fn is_spent(&self) -> bool {
        self.is_spent.load(Ordering::Relaxed)
    }
}

//! Lines of progress inside a long time step.

use std::io::Write;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use exact_ccd_sim::{Iteration, Simulation};
use indicatif::ProgressBar;

/// The least time between two lines, and between the start of a time step and its first line.
const INTERVAL: Duration = Duration::from_secs(1);

/// The least time between two lines where no progress bar is visible, as in a file.
const LONG_INTERVAL: Duration = Duration::from_secs(30);

/// The same simulation, which prints a line now and then above a progress bar, or on standard error if the
/// bar is not visible.
pub(super) fn watched(simulation: Simulation, bar: &ProgressBar) -> Simulation {
    let bar = bar.clone();
    let last = Mutex::new(Last {
        step: 0,
        time: Instant::now(),
        interval: if bar.is_hidden() { LONG_INTERVAL } else { INTERVAL },
    });
    simulation.with_watch(move |iteration| {
        // A panic of another thread has ended the run.
        let Ok(mut last) = last.lock() else { return };
        if last.is_due(iteration.step, Instant::now()) {
            if bar.is_hidden() {
                let _ = writeln!(std::io::stderr(), "exact-ccd: {}", line(iteration));
            } else {
                bar.println(line(iteration));
            }
        }
    })
}

/// The time step of the last iteration, and the time of its last line, or of its first iteration if it has no
/// line.
struct Last {
    step: u64,
    time: Instant,
    interval: Duration,
}

impl Last {
    /// Returns true if an iteration of a time step has a line, and takes its place then.
    fn is_due(&mut self, step: u64, now: Instant) -> bool {
        let is_due = step == self.step && now.duration_since(self.time) >= self.interval;
        if is_due || step != self.step {
            (self.step, self.time) = (step, now);
        }
        is_due
    }
}

/// The line for an iteration.
fn line(iteration: &Iteration) -> String {
    let Iteration {
        step,
        part: [part, parts],
        iteration,
        residual,
        tolerance,
        contacts,
    } = iteration;
    let of_parts = match parts {
        1 => String::new(),
        _ => format!(", part {part} of {parts}"),
    };
    let plural = if *contacts == 1 { "" } else { "s" };
    format!(
        "step {step}{of_parts}, iteration {iteration}: residual {residual:.2e} m/s of {tolerance:.2e} m/s, \
         {contacts} contact{plural}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Iterations each 0.4 s: the first line comes after three, then each third has one. A time step of less
    /// than a second has none, and the next one begins anew.
    #[test]
    fn lines_are_a_second_apart_within_a_time_step() {
        let start = Instant::now();
        let mut last = Last {
            step: 0,
            time: start,
            interval: INTERVAL,
        };
        let steps = [1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3];
        let due = (0..).zip(steps).filter_map(|(place, step)| {
            let now = start + Duration::from_millis(400 * place);
            last.is_due(step, now).then_some(place)
        });
        assert_eq!(due.collect::<Vec<_>>(), [3, 6, 13]);
    }

    #[test]
    fn a_line_has_residual_and_contacts() {
        let iteration = Iteration {
            step: 12,
            part: [1, 1],
            iteration: 34,
            residual: 0.00123,
            tolerance: 1e-4,
            contacts: 1,
        };
        assert_eq!(
            line(&iteration),
            "step 12, iteration 34: residual 1.23e-3 m/s of 1.00e-4 m/s, 1 contact"
        );
        let part = Iteration {
            part: [3, 4],
            contacts: 0,
            ..iteration
        };
        assert_eq!(
            line(&part),
            "step 12, part 3 of 4, iteration 34: residual 1.23e-3 m/s of 1.00e-4 m/s, 0 contacts"
        );
    }
}

//! Lines of progress inside a long time step.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use exact_ccd_sim::{Iteration, Simulation};
use indicatif::ProgressBar;

/// The least time between two lines, and between the start of a time step and its first line.
const INTERVAL: Duration = Duration::from_secs(1);

/// The same simulation, which prints a line now and then above a progress bar, if the bar is visible: on a
/// terminal.
pub(super) fn watched(simulation: Simulation, bar: &ProgressBar) -> Simulation {
    if bar.is_hidden() {
        return simulation;
    }
    let bar = bar.clone();
    let last = Mutex::new((0, Instant::now()));
    simulation.with_watch(move |iteration| {
        // A panic of another thread has ended the run.
        let Ok(mut last) = last.lock() else { return };
        if last.0 != iteration.step {
            *last = (iteration.step, Instant::now());
        } else if last.1.elapsed() >= INTERVAL {
            bar.println(line(iteration));
            last.1 = Instant::now();
        }
    })
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

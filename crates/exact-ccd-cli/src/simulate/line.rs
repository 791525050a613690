//! One time step as a line of text.

use std::fmt::Write;

use ccd_sim::Statistics;

/// What matters of a time step.
pub(super) fn of(statistics: &Statistics) -> String {
    let Statistics {
        step,
        time,
        iterations,
        contacts,
        seconds,
        ..
    } = statistics;
    let mut line = format!("step {step}, {time:.4} s: {iterations} iterations, {contacts} contacts");
    // Writing to a string does not fail.
    if let Some(distance) = statistics.minimal_distance {
        let _ = write!(line, " down to {distance:.2e} m");
    }
    let _ = write!(line, ", energy {:.6e} J", statistics.energies.mechanical());
    if statistics.script_lag > 0.0 {
        let _ = write!(line, ", {:.2e} m behind the script", statistics.script_lag);
    }
    if !statistics.converged {
        line += ", not converged";
    }
    let _ = write!(
        line,
        "; {:.2} s (assembly {:.2}, solve {:.2}, ccd {:.2}, line search {:.2})",
        seconds.total, seconds.assembly, seconds.solve, seconds.ccd, seconds.line_search
    );
    line
}

//! A scene and a time step, each as a line of text.

use std::fmt::Write;

use exact_ccd_sim::{Simulation, Statistics};

/// What a simulation is about, up to so many time steps: wrong units show here first.
pub(super) fn of_scene(simulation: &Simulation, steps: u64) -> String {
    let (system, settings) = (simulation.system(), simulation.settings());
    let done = simulation.state().step;
    let mut line = format!(
        "{} vertices, {} faces, {:.3e} m across; contact distance {:.2e} m; ",
        system.start().len(),
        system.surface().faces().len(),
        system.size(),
        settings.contact_distance.meters(system.size()),
    );
    // Writing to a string does not fail.
    let _ = match done {
        0 => write!(line, "{steps} time steps of {} s", settings.time_step),
        _ if done < steps => write!(
            line,
            "time steps {} to {steps} of {} s",
            done + 1,
            settings.time_step
        ),
        _ => write!(
            line,
            "time step {done} is there already, up to {steps} nothing is left to do"
        ),
    };
    line
}

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

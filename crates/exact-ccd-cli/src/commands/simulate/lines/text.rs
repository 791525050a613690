//! One line of text for a scene and for each time step.

use std::fmt::Write;

use exact_ccd_sim::{Simulation, Statistics, System};

use super::significant::significant;
use crate::commands::simulate::queries::{Counts, Numbers};

/// The line for a scene, simulated up to a time step. Its lengths help to notice wrong units.
pub(crate) fn of_scene(simulation: &Simulation, last: u64, is_saved: bool) -> String {
    let system = simulation.system();
    let mut line = format!(
        "{} vertices, {} faces, {}{}; {}",
        system.mesh_vertices().len(),
        system.surface().faces().len(),
        rods_and_particles(system),
        lengths(simulation),
        time_steps(simulation, last)
    );
    if !is_saved {
        line += "; without --output, nothing is saved";
    }
    line
}

/// The lines about a scene on its page.
pub(crate) fn description(simulation: &Simulation, last: u64) -> String {
    format!("{}\n{}", lengths(simulation), time_steps(simulation, last))
}

/// The size of the scene and the contact distance.
fn lengths(simulation: &Simulation) -> String {
    let size = simulation.system().size();
    let distance = simulation.settings().contact_distance.meters(size);
    format!(
        "{} m across; contact distance {} m",
        significant(size, 4),
        significant(distance, 3)
    )
}

/// The time steps from the present one to the last one.
fn time_steps(simulation: &Simulation, steps: u64) -> String {
    let done = simulation.state().step;
    let time_step = simulation.settings().time_step;
    let plural = if steps == 1 { "" } else { "s" };
    match done {
        0 => format!("{steps} time step{plural} of {time_step} s"),
        _ if done + 1 == steps => format!("time step {steps} of {time_step} s"),
        _ if done < steps => format!("time steps {} to {steps} of {time_step} s", done + 1),
        _ => format!("nothing to do: the results have time step {done}, the last step is {steps}"),
    }
}

/// The numbers of rod edges and particles, where there are any.
fn rods_and_particles(system: &System) -> String {
    let counts = [
        (system.surface().loose_edges().len(), "rod edges"),
        (system.particles().len(), "particles"),
    ];
    let present = counts.into_iter().filter(|(count, _)| *count > 0);
    present.map(|(count, what)| format!("{count} {what}, ")).collect()
}

/// The line for a time step.
pub(crate) fn of_step(statistics: &Statistics, no_seconds: bool) -> String {
    let Statistics {
        step,
        time,
        iterations,
        contacts,
        seconds,
        ..
    } = statistics;
    let plural = |count: usize| if count == 1 { "" } else { "s" };
    let mut line = format!(
        "step {step}, {time:.4} s: {iterations} iteration{}, {contacts} contact{}",
        plural(*iterations),
        plural(*contacts)
    );
    // Writing to a string does not fail.
    if let Some(distance) = statistics.minimal_distance {
        let _ = write!(line, " down to {distance:.2e} m");
    }
    let _ = write!(line, ", energy {:.6e} J", statistics.energies.mechanical());
    if statistics.script_lag > 0.0 {
        let _ = write!(line, ", script lag {:.2e} m", statistics.script_lag);
    }
    if !statistics.converged {
        line += ", not converged";
    }
    if no_seconds {
        return line;
    }
    let _ = write!(
        line,
        "; {:.2} s (assembly {:.2}, solve {:.2}, ccd {:.2}, line search {:.2})",
        seconds.total, seconds.assembly, seconds.solve, seconds.ccd, seconds.line_search
    );
    line
}

/// The line for the queries of all time steps.
pub(crate) fn of_queries(counts: &Counts) -> String {
    let text = |name: &str, numbers: &Numbers| {
        let Numbers {
            total,
            in_contact,
            kept,
        } = numbers;
        format!("{kept} of {total} {name} queries, {in_contact} in contact")
    };
    let vertex_face = text("vertex-face", &counts.vertex_face);
    format!("kept {vertex_face}; {}", text("edge-edge", &counts.edge_edge))
}

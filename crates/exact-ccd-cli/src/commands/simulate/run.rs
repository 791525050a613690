//! A run: the time steps of a simulation, and their lines and files.

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use exact_ccd_scene::Scene;
use exact_ccd_sim::{Simulation, SimulationError, Statistics};
use indicatif::ProgressBar;

use super::arguments::Arguments;
use super::folder::path::NewtonPath;
use super::interrupt;
use super::iterations;
use super::lines::convergence::Convergence;
use super::outputs::Outputs;
use crate::files::outputs::print;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};

/// A simulation from its present time step to the last one.
pub(super) struct Run<'a> {
    arguments: &'a Arguments,
    /// The command line, which continues the run after Ctrl-C.
    command: &'a [OsString],
    simulation: Simulation,
    outputs: Outputs,
    notes: Notes,
    /// The number of the last time step.
    last: u64,
    /// The number of time steps of this run.
    count: u64,
    convergence: Convergence,
    bar: ProgressBar,
}

/// The end of the time steps.
pub(super) enum Ended {
    Complete,
    Interrupted,
    /// A time step failed, or did not converge with `--strict`.
    Failed(Failure),
}

impl<'a> Run<'a> {
    /// The run of a scene, from its start or from the checkpoint. The line about the scene is printed.
    pub(super) fn begin(
        arguments: &'a Arguments,
        command: &'a [OsString],
        scene: Scene,
        mut notes: Notes,
    ) -> Result<Self, Failure> {
        let last = arguments.steps.unwrap_or(scene.steps);
        let (simulation, outputs) = Outputs::open(arguments, scene.simulation, &scene.rendering, last)?;
        print(&arguments.lines.of_scene(&simulation, last, arguments.has_files()))?;
        if simulation.state().step == 0 {
            let warnings = simulation.warnings();
            warnings
                .iter()
                .for_each(|warning| notes.warn(warning.to_string()));
        }
        let simulation = simulation.with_interrupt(interrupt::flag());
        let count = last.saturating_sub(simulation.state().step);
        let bar = progress::bar(usize::try_from(count).unwrap_or(usize::MAX), "time steps");
        Ok(Self {
            arguments,
            command,
            simulation: iterations::watched(simulation, &bar),
            outputs,
            notes,
            last,
            count,
            convergence: Convergence::default(),
            bar,
        })
    }

    /// Simulates the time steps.
    pub(super) fn advance(&mut self) -> Result<Ended, Failure> {
        during(self.bar.clone(), |progress| {
            while self.simulation.state().step < self.last {
                if let Some(ended) = self.step()? {
                    return Ok(ended);
                }
                progress(1);
            }
            Ok(Ended::Complete)
        })
    }

    /// Simulates a time step, writes its files and prints its line. Returns the end of the run if it is
    /// before the last time step.
    fn step(&mut self) -> Result<Option<Ended>, Failure> {
        let mut path = self.outputs.path(&self.simulation);
        let stepped = self.simulation.step_along(&mut |positions| {
            if let Some(path) = &mut path {
                path.add(positions);
            }
        });
        let statistics = match stepped {
            Ok(statistics) => statistics,
            Err(SimulationError::Interrupted { .. }) => return Ok(Some(Ended::Interrupted)),
            Err(error) => return Ok(Some(Ended::Failed(Failure::of(&self.arguments.scene, error)))),
        };
        let is_failure = self.arguments.strict && !statistics.converged;
        let is_last = is_failure || statistics.step == self.last;
        let path = path.map_or_else(|| Ok(Vec::new()), NewtonPath::finish)?;
        self.outputs.add(&self.simulation, &statistics, path, is_last)?;
        // The progress bar is hidden while the line is printed.
        let line = self.arguments.lines.of_step(&statistics);
        self.bar.suspend(|| print(&line))?;
        self.convergence.add(&statistics);
        Ok(is_failure.then(|| Ended::Failed(self.not_converged(&statistics))))
    }

    fn not_converged(&self, statistics: &Statistics) -> Failure {
        Failure::new(format_args!(
            "time step {} did not converge, expected convergence with --strict: {}",
            statistics.step,
            self.convergence.remedy()
        ))
    }

    /// Writes the files about all time steps, and reports on the end of the run.
    pub(super) fn finish(mut self, ended: Ended) -> Result<ExitCode, Failure> {
        let left = self.last.saturating_sub(self.simulation.state().step);
        let (is_complete, verdict) = match &ended {
            Ended::Failed(failure) => (false, failure.on_one_line()),
            Ended::Interrupted => (false, self.convergence.text(self.count.saturating_sub(left))),
            Ended::Complete => (true, self.convergence.text(self.count)),
        };
        let written = self.outputs.finish(&self.simulation, is_complete, &verdict);
        match ended {
            Ended::Failed(failure) => Err(failure),
            Ended::Interrupted => written.map(|()| self.interrupted()),
            Ended::Complete => written.and_then(|()| self.conclude()),
        }
    }

    /// Reports the interruption, and the command that continues the run.
    fn interrupted(&self) -> ExitCode {
        let message = interrupt::message(self.simulation.state().step, self.arguments, self.command);
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: {message}");
        ExitCode::from(interrupt::STATUS)
    }

    /// Reports on all time steps, and draws the whole motion.
    fn conclude(mut self) -> Result<ExitCode, Failure> {
        if let Some(warning) = self.convergence.warning(self.count) {
            self.notes.warn(warning);
        }
        if let Some(counts) = self.outputs.query_counts() {
            print(&self.arguments.lines.of_queries(counts))?;
        }
        self.outputs.draw(&self.arguments.scene, &self.simulation)?;
        Ok(ExitCode::SUCCESS)
    }
}

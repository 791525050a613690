//! The time steps that did not converge.

use exact_ccd_sim::Statistics;

use super::significant::significant;

/// The time steps that did not converge, with what kept them from it.
#[derive(Default)]
pub(crate) struct Convergence {
    /// Their numbers.
    steps: Vec<u64>,
    /// The number of those in which scripts stayed behind.
    lagging: usize,
    /// The greatest distance of a scripted vertex from its target, in m.
    lag: f64,
    /// The number of those that stopped at rounding errors.
    stagnated: usize,
}

impl Convergence {
    /// Adds a time step.
    pub(crate) fn add(&mut self, statistics: &Statistics) {
        if statistics.converged {
            return;
        }
        self.steps.push(statistics.step);
        if statistics.stagnated {
            self.stagnated += 1;
        } else if statistics.script_lag > 0.0 {
            self.lagging += 1;
            self.lag = self.lag.max(statistics.script_lag);
        }
    }

    /// The warning that time steps did not converge, if there were any among this number of steps.
    pub(crate) fn warning(&self, steps: u64) -> Option<String> {
        self.steps.first()?;
        let text = self.text(steps);
        Some(format!(
            "{text}: there, the motion is not accurate; {}",
            self.remedy()
        ))
    }

    /// The time steps that did not converge, among this number of steps.
    pub(crate) fn text(&self, steps: u64) -> String {
        match self.steps[..] {
            [] if steps == 1 => "the time step converged".to_owned(),
            [] => format!("all {steps} time steps converged"),
            [only] => format!("time step {only} did not converge"),
            [first, ..] => {
                let count = self.steps.len();
                format!("{count} of {steps} time steps did not converge, the first is {first}")
            }
        }
    }

    /// Advice for each cause.
    pub(crate) fn remedy(&self) -> String {
        let mut remedies = Vec::new();
        if self.lagging > 0 {
            remedies.push(format!(
                "scripted vertices stayed up to {} m behind their targets, because something is in their way: set a \
                 smaller `time-step`, or `line-search = \"vertex\"`",
                significant(self.lag, 3)
            ));
        }
        if self.stagnated > 0 {
            remedies
                .push("rounding errors are larger than the tolerance: set a larger `tolerance`".to_owned());
        }
        if self.lagging + self.stagnated < self.steps.len() {
            remedies
                .push("set a smaller `time-step`, a larger `max-iterations`, or `max-substeps`".to_owned());
        }
        remedies.join("; ")
    }
}

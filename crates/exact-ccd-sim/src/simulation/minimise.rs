//! The minimisation of the potential of one part of a time step, with the terms of damping and of lagged
//! friction.

use exact_ccd_mesh::Point;

use super::problem::Problem;
use crate::energies::contact::Collision;
use crate::energies::damper::Damper;
use crate::energies::friction::{FrictionContact, Smoothing};
use crate::energies::term::Energy;
use crate::error::SimulationError;
use crate::integrator::Integrator;
use crate::solver::{Iterate, Memory};
use crate::statistics::Statistics;

impl Problem<'_> {
    /// Minimises the potential from an iterate, with friction from the forces there, and again with friction
    /// from the forces at the minimum, as often as the settings say. If `convergent`, ends where Newton's
    /// method does not converge.
    pub(super) fn minimise(
        &mut self,
        memory: &mut Memory,
        now: &mut Iterate<'_>,
        convergent: bool,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<Statistics, SimulationError> {
        let mut statistics = Statistics {
            step: self.paths.times.step,
            time: self.paths.times.end,
            converged: true,
            ..Statistics::default()
        };
        self.newton.terms.dampers = self.dampers();
        let mut stiffness = self.kept_stiffness().unwrap_or(now.stiffness);
        let settings = &self.simulation.settings.friction;
        for lag in 0..settings.lags {
            let iterations = statistics.iterations;
            self.newton.terms.friction = self.friction(now, stiffness);
            let converged = self.newton.minimise(memory, now, &mut statistics, visit)?;
            statistics.converged &= converged;
            stiffness = now.stiffness;
            // The forces of an update leave the positions where they are, within the tolerance.
            let is_settled = lag > 0 && converged && statistics.iterations == iterations + 1;
            if is_settled || convergent && !converged || !settings.acts() {
                break;
            }
        }
        Ok(statistics)
    }

    /// The damping of the elastic elements in proportion to their stiffness.
    fn dampers(&self) -> Vec<Damper> {
        let settings = &self.simulation.settings;
        let factor = settings.stiffness_damping * self.scheme.duration;
        if factor == 0.0 || settings.integrator == Integrator::QuasiStatic {
            return Vec::new();
        }
        let (positions, origin) = (&self.simulation.state.positions, &self.scheme.origin);
        let elements = self.simulation.system.elastic.elements.iter();
        elements
            .map(|element| Damper::new(&**element, positions, origin, factor))
            .collect()
    }

    /// The friction of the collisions of an iterate, with normal forces for a stiffness κ.
    fn friction(&self, now: &Iterate<'_>, stiffness: f64) -> Vec<FrictionContact> {
        let Self {
            simulation, scheme, ..
        } = self;
        let settings = &simulation.settings.friction;
        if !settings.acts() {
            return Vec::new();
        }
        let smoothing = Smoothing {
            threshold: settings.static_velocity.meters(simulation.system.size()) * scheme.duration,
        };
        let contact = |collision: &Collision| {
            let coefficient = simulation.coefficients.of(simulation.system.bodies_of(collision));
            if coefficient == 0.0 {
                return None;
            }
            let bound = coefficient * stiffness * collision.normal_force(&now.positions);
            let vertices = collision.vertices().iter().copied().collect();
            let shortest = collision.shortest_vector(&now.positions);
            Some(FrictionContact::new(
                vertices,
                &scheme.origin,
                &shortest,
                bound,
                smoothing,
            ))
        };
        now.collisions.as_slice().iter().filter_map(contact).collect()
    }
}

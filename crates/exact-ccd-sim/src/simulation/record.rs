//! The record of one part of a time step: the state at its end, and its statistics.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::problem::Problem;
use crate::energies::contact::CollisionSet;
use crate::energies::elasticity::Twist;
use crate::solver::{Form, Iterate};
use crate::state::{Earlier, State};
use crate::statistics::{Energies, Statistics};

impl Problem<'_> {
    /// The state with the positions of an iterate, and its collisions. Adds its figures to the statistics.
    pub(super) fn record(&self, now: Iterate<'_>, statistics: &mut Statistics) -> (State, CollisionSet) {
        let before = &self.simulation.state;
        let twists = self.newton.chains.twists(&now.dirichlet);
        let velocities = self.scheme.velocities(&now.positions);
        let touched = before.stiffness.is_some() || now.collisions.count() > 0;
        statistics.contacts = now.collisions.count();
        statistics.minimal_distance = Some(now.collisions.minimal_distance()).filter(|d| d.is_finite());
        statistics.script_lag = now.dirichlet.lag(&now.positions);
        statistics.energies = self.energies(&now, &twists, &velocities);
        statistics.stiffness = touched.then_some(now.stiffness);
        let state = State {
            // Parts of a time step do not count.
            step: before.step,
            velocities,
            earlier: Some(Earlier {
                positions: before.positions.clone(),
                velocities: before.velocities.clone(),
            }),
            stiffness: touched.then_some(now.stiffness * self.scheme.duration.powi(-2)),
            origins: self.paths.origins.clone(),
            behind: now.dirichlet.behind(),
            twists: self.newton.chains.angles(&twists, &now.positions),
            positions: now.positions,
        };
        (state, now.collisions)
    }

    fn energies(&self, now: &Iterate<'_>, twists: &[Twist], velocities: &[Point]) -> Energies {
        let (positions, duration) = (&now.positions, self.scheme.duration);
        let masses = || self.simulation.system.masses.iter();
        // The incremental potential is the energy times duration².
        let scale = duration.powi(-2);
        let contacts = self.newton.terms.friction.iter();
        let friction: f64 = contacts.map(|contact| contact.work(positions)).sum();
        let gravity = Vector3::from(self.simulation.settings.gravity);
        Energies {
            kinetic: masses()
                .zip(velocities)
                .map(|(m, v)| 0.5 * m * Vector3::from(*v).norm_squared())
                .sum(),
            elastic: Form::elastic(&self.simulation.system, 1.0).value(positions)
                + Form::of(twists, 1.0).value(positions),
            barrier: scale * Form::of(now.collisions.as_slice(), now.stiffness).value(positions),
            // Slips are velocities times the effective time step, which is shorter than the time step for
            // BDF2.
            friction: scale * friction * self.paths.times.duration / duration,
            gravity: masses()
                .zip(positions)
                .map(|(m, x)| -m * gravity.dot(&Vector3::from(*x)))
                .sum(),
        }
    }
}

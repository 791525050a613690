//! The problem of one part of a time step: the incremental potential, and the iterate from which its
//! minimisation starts.

use nalgebra::Vector3;

use super::Simulation;
use crate::energies::contact::CollisionSet;
use crate::energies::elasticity::Twist;
use crate::integrator::Scheme;
use crate::prescribed::{Dirichlet, HeldChains, Paths};
use crate::solver::{Form, Iterate, Newton, Terms};

/// The problem of one part of a time step.
pub(super) struct Problem<'a> {
    pub(super) simulation: &'a Simulation,
    pub(super) paths: &'a Paths<'a>,
    pub(super) scheme: Scheme,
    pub(super) newton: Newton<'a>,
}

impl<'a> Problem<'a> {
    /// The problem along the paths of scripts, without the terms of damping and friction.
    pub(super) fn new(simulation: &'a Simulation, paths: &'a Paths<'a>) -> Self {
        let Simulation {
            system,
            settings,
            state,
            barrier,
            ..
        } = simulation;
        let scheme = settings
            .integrator
            .scheme(state, paths.times.duration, settings.damping);
        let [_, moment] = paths.times.moments;
        let held = system.held(moment);
        let loads = system.accelerations(&state.positions, moment);
        let acceleration = |vertex: usize| {
            let load = loads.as_ref().map_or_else(Vector3::zeros, |loads| loads[vertex]);
            Vector3::from(settings.gravity) + load
        };
        let terms = Terms {
            duration: scheme.duration,
            inertia: scheme.inertia(&system.masses, &held, acceleration),
            dampers: Vec::new(),
            friction: Vec::new(),
        };
        let newton = Newton {
            system,
            settings,
            filter: &simulation.filter,
            barrier: *barrier,
            range: simulation.range(&scheme),
            terms,
            chains: HeldChains::new(paths, &held),
            held,
            times: paths.times,
            interrupt: &simulation.interrupt,
            watch: simulation.watch.as_deref(),
        };
        Self {
            simulation,
            paths,
            scheme,
            newton,
        }
    }

    /// The iterate at the start.
    pub(super) fn first(&self) -> Iterate<'a> {
        let dirichlet = Dirichlet::new(self.paths, &self.newton.held);
        let collisions = self.simulation.collisions().into_owned();
        let twists = self.newton.chains.twists(&dirichlet);
        Iterate {
            positions: self.simulation.state.positions.clone(),
            stiffness: self.stiffness(&collisions, &twists),
            collisions,
            value: None,
            dirichlet,
        }
    }

    /// κ at the start: the larger of the κ that balances the other forces and the previous κ.
    fn stiffness(&self, collisions: &CollisionSet, twists: &[Twist]) -> f64 {
        let before = self.kept_stiffness().unwrap_or(0.0);
        let range = &self.newton.range;
        if collisions.as_slice().is_empty() {
            return before.max(range.least);
        }
        let positions = &self.simulation.state.positions;
        let mut energy = self.newton.potential(before, twists).gradient(positions, &[]);
        let mut barriers = Form::of(collisions.as_slice(), 1.0).gradient(positions);
        self.simulation.system.carriers.collect(&mut barriers);
        for (vertex, held) in self.newton.held.iter().enumerate() {
            for axis in (0..3).filter(|&axis| held[axis]) {
                energy[vertex][axis] = 0.0;
                barriers[vertex][axis] = 0.0;
            }
        }
        before.max(range.balance(&energy, &barriers))
    }

    /// The κ of this step with which the barrier has the same forces as in the previous step.
    pub(super) fn kept_stiffness(&self) -> Option<f64> {
        let (energy, duration) = (self.simulation.state.stiffness, self.scheme.duration);
        energy.map(|stiffness| stiffness * duration * duration)
    }
}

//! A simulation, step by step.

use std::time::Instant;

use ccd_mesh::{Bounds, Point};
use nalgebra::Vector3;

use crate::contact::{Barrier, Collisions, Pairs, StiffnessRange};
use crate::drive::Drive;
use crate::filter::{self, StepFilter, UnknownFilter};
use crate::friction::{FrictionContact, Smoothing};
use crate::gather::gather_some;
use crate::integrator::Scheme;
use crate::settings::{Length, Settings};
use crate::solver::{LinearSolver, Newton, Outcome, Potential};
use crate::state::{Earlier, State};
use crate::statistics::{Energies, Statistics};
use crate::system::System;

/// A system that moves under elasticity, gravity, contact and friction.
///
/// ```
/// use ccd_sim::{Body, Settings, Simulation, System, shapes};
///
/// let cube = shapes::solid_box([1, 1, 1], [1.0; 3]);
/// let system = System::new(&[cube], &[])?;
/// let mut simulation = Simulation::new(system, Settings::default())?;
/// let statistics = simulation.step()?;
/// assert!(statistics.energies.kinetic > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Simulation {
    system: System,
    settings: Settings,
    filter: Box<dyn StepFilter>,
    barrier: Barrier,
    solver: LinearSolver,
    state: State,
}

/// What keeps a simulation from starting or from going on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// A number of the settings is out of range.
    #[error("`{what}` is {value}, expected {expected}")]
    Setting {
        /// Which, as in [`Settings`] with dots and hyphens.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// There is no such method of continuous collision detection.
    #[error(transparent)]
    Filter(#[from] UnknownFilter),
    /// The state is that of another system.
    #[error("the state has {found} {what}, expected {expected}, one for each vertex")]
    State {
        /// `positions`, `velocities`, and so on.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many vertices the system has.
        expected: usize,
    },
    /// The linear system of a Newton iteration has no solution: forces are not finite, or far out of proportion.
    #[error("step {step}: the linear system has no solution")]
    Singular {
        /// The number of the step.
        step: u64,
    },
    /// No part of a Newton step is free of contact.
    #[error("step {step}: `{filter}` finds contact where the step begins")]
    Blocked {
        /// The number of the step.
        step: u64,
        /// The method of continuous collision detection.
        filter: String,
    },
}

/// How much larger than the scene at its start the box is in which [`filter::Parity`] expects it to stay.
const ROOM: f64 = 4.0;

impl Simulation {
    /// The simulation of a system from its start.
    ///
    /// # Errors
    /// [`SimulationError`] names the setting that is out of range.
    pub fn new(system: System, settings: Settings) -> Result<Self, SimulationError> {
        let state = State {
            step: 0,
            positions: system.start.clone(),
            velocities: system.velocities.clone(),
            earlier: None,
            stiffness: None,
        };
        Self::resume(system, settings, state)
    }

    /// The simulation of a system from a state in which it was.
    ///
    /// # Errors
    /// [`SimulationError`] names the setting that is out of range, or what of the state does not fit the system.
    pub fn resume(system: System, settings: Settings, state: State) -> Result<Self, SimulationError> {
        check(&settings, system.size())?;
        let expected = system.start.len();
        let fits = |what, found| {
            (found == expected).then_some(()).ok_or(SimulationError::State {
                what,
                found,
                expected,
            })
        };
        fits("positions", state.positions.len())?;
        fits("velocities", state.velocities.len())?;
        if let Some(earlier) = &state.earlier {
            fits("earlier positions", earlier.positions.len())?;
            fits("earlier velocities", earlier.velocities.len())?;
        }
        let filter = filter::by_name(&settings.ccd, room(&system))?;
        let barrier = Barrier::new(settings.contact_distance.meters(system.size()));
        Ok(Self {
            system,
            settings,
            filter,
            barrier,
            solver: LinearSolver::default(),
            state,
        })
    }

    /// The same, with another method of continuous collision detection.
    #[must_use]
    pub fn with_filter(mut self, filter: Box<dyn StepFilter>) -> Self {
        self.filter = filter;
        self
    }

    /// The same, with its filter inside of another one, which may observe what it is asked.
    #[must_use]
    pub fn map_filter(mut self, wrap: impl FnOnce(Box<dyn StepFilter>) -> Box<dyn StepFilter>) -> Self {
        self.filter = wrap(self.filter);
        self
    }

    /// The system.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The settings.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Where the simulation is: all that [`Simulation::resume`] needs to go on.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The time in the simulation, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.state.step as f64 * self.settings.time_step
    }

    /// Takes one time step. After an error, the state is what it was before.
    ///
    /// # Errors
    /// [`SimulationError::Singular`] and [`SimulationError::Blocked`].
    pub fn step(&mut self) -> Result<Statistics, SimulationError> {
        self.step_along(&mut |_| ())
    }

    /// Takes one time step, and shows the way: all positions after each increment of it.
    ///
    /// Each increment, in straight lines from the one before, is what has been filtered. The straight line from the start of
    /// the time step to its end is another way, on which there may be contact.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    pub fn step_along(&mut self, visit: &mut dyn FnMut(&[Point])) -> Result<Statistics, SimulationError> {
        let clock = Instant::now();
        let Self { system, settings, .. } = &*self;
        let step = self.state.step + 1;
        let time = step as f64 * settings.time_step;
        let mut statistics = Statistics {
            step,
            time,
            ..Statistics::default()
        };
        let scheme = settings
            .integrator
            .scheme(&self.state, settings.time_step, settings.gravity);
        let smoothing = Smoothing {
            threshold: settings.friction.static_velocity.meters(system.size()) * scheme.duration,
        };
        let range = StiffnessRange::new(system.size(), system.mean_mass(), &self.barrier);

        let positions = self.state.positions.clone();
        let pairs = Pairs::near(
            &system.surface,
            &positions,
            &positions,
            self.barrier.reach().sqrt(),
        );
        let collisions = Collisions::new(&system.surface, &pairs, &positions, &system.start, self.barrier);
        let mut lagged = self.state.stiffness;
        let mut now = Outcome {
            stiffness: self.stiffness(&scheme, &collisions, &range, smoothing),
            drive: Drive::new(system, &positions, time),
            positions,
            collisions,
        };
        let mut solver = std::mem::take(&mut self.solver);
        let Self { system, settings, .. } = &*self;
        let mut friction = Vec::new();
        for _ in 0..settings.friction.lags.max(1) {
            friction = self.friction(&now, lagged.unwrap_or(now.stiffness));
            let newton = Newton {
                system,
                scheme: &scheme,
                friction: &friction,
                smoothing,
                barrier: self.barrier,
                range,
                filter: &*self.filter,
                tolerance: settings.tolerance.meters(system.size()),
                max_iterations: settings.max_iterations,
            };
            newton.minimise(&mut solver, &mut now, &mut statistics, visit)?;
            lagged = Some(now.stiffness);
            if settings.friction.coefficient == 0.0 {
                break;
            }
        }

        statistics.contacts = now.collisions.as_slice().len();
        statistics.minimal_distance = Some(now.collisions.minimal_distance()).filter(|d| d.is_finite());
        statistics.script_lag = now.drive.lag(&now.positions);
        let velocities = scheme.velocities(&now.positions);
        let potential = potential(system, &scheme, now.stiffness, &friction, smoothing);
        statistics.energies = energies(&potential, settings.gravity, &now, &velocities);
        let touched = self.state.stiffness.is_some() || statistics.contacts > 0;
        statistics.stiffness = touched.then_some(now.stiffness);

        self.solver = solver;
        let before = std::mem::replace(
            &mut self.state,
            State {
                step,
                positions: now.positions,
                velocities,
                earlier: None,
                stiffness: statistics.stiffness,
            },
        );
        self.state.earlier = Some(Earlier {
            positions: before.positions,
            velocities: before.velocities,
        });
        statistics.seconds.total = clock.elapsed().as_secs_f64();
        Ok(statistics)
    }

    /// κ at the start of a step: at least what balances the other forces, and never less than before.
    fn stiffness(
        &self,
        scheme: &Scheme,
        collisions: &Collisions,
        range: &StiffnessRange,
        smoothing: Smoothing,
    ) -> f64 {
        let before = self.state.stiffness.unwrap_or(0.0);
        if collisions.as_slice().is_empty() {
            return before.max(range.least);
        }
        let potential = potential(&self.system, scheme, before, &[], smoothing);
        let positions = &self.state.positions;
        let mut energy = potential.smooth_gradient(positions);
        let mut barriers = collisions.gradient(positions);
        for vertex in 0..positions.len() {
            if !self.system.is_free(vertex) {
                energy[vertex] = Vector3::zeros();
                barriers[vertex] = Vector3::zeros();
            }
        }
        before.max(range.balance(&energy, &barriers))
    }

    fn friction(&self, now: &Outcome, stiffness: f64) -> Vec<FrictionContact> {
        let coefficient = self.settings.friction.coefficient;
        if coefficient == 0.0 {
            return Vec::new();
        }
        let contact = |collision: &crate::contact::Collision| {
            let corners = gather_some(&now.positions, collision.vertices());
            let force = stiffness * collision.normal_force(&corners, &self.barrier);
            let separation = collision.separation(&corners);
            FrictionContact::new(collision.vertices().clone(), &separation, coefficient * force)
        };
        now.collisions.as_slice().iter().map(contact).collect()
    }
}

fn potential<'a>(
    system: &'a System,
    scheme: &'a Scheme,
    stiffness: f64,
    friction: &'a [FrictionContact],
    smoothing: Smoothing,
) -> Potential<'a> {
    Potential {
        system,
        scheme,
        stiffness,
        friction,
        smoothing,
        springs: &[],
    }
}

fn energies(potential: &Potential<'_>, gravity: Point, now: &Outcome, velocities: &[Point]) -> Energies {
    let masses = || potential.system.masses.iter();
    // The potential has the square of the duration as a factor.
    let scale = potential.scheme.duration.powi(-2);
    let gravity = Vector3::from(gravity);
    Energies {
        kinetic: masses()
            .zip(velocities)
            .map(|(m, v)| 0.5 * m * Vector3::from(*v).norm_squared())
            .sum(),
        elastic: potential.elastic(&now.positions),
        barrier: scale * now.stiffness * now.collisions.value(&now.positions),
        friction: scale * potential.friction(&now.positions),
        gravity: masses()
            .zip(&now.positions)
            .map(|(m, x)| -m * gravity.dot(&Vector3::from(*x)))
            .sum(),
    }
}

fn room(system: &System) -> Bounds {
    let bounds: Bounds = system.start.iter().copied().collect();
    let margin = 0.5 * (ROOM - 1.0) * system.size();
    Bounds {
        lower: bounds.lower.map(|x| x - margin),
        upper: bounds.upper.map(|x| x + margin),
    }
}

fn check(settings: &Settings, size: f64) -> Result<(), SimulationError> {
    let number = |length: Length| length.meters(size);
    let positive = [
        ("time-step", settings.time_step),
        ("contact-distance", number(settings.contact_distance)),
        ("tolerance", number(settings.tolerance)),
        (
            "friction.static-velocity",
            number(settings.friction.static_velocity),
        ),
    ];
    for (what, value) in positive {
        if !(value > 0.0 && value.is_finite()) {
            let expected = "a positive number";
            return Err(SimulationError::Setting {
                what,
                value,
                expected,
            });
        }
    }
    let coefficient = settings.friction.coefficient;
    if !(coefficient >= 0.0 && coefficient.is_finite()) {
        return Err(SimulationError::Setting {
            what: "friction.coefficient",
            value: coefficient,
            expected: "a number not below 0",
        });
    }
    match settings.gravity.iter().find(|g| !g.is_finite()) {
        None => Ok(()),
        Some(&value) => Err(SimulationError::Setting {
            what: "gravity",
            value,
            expected: "finite numbers",
        }),
    }
}

//! One time step.

use std::collections::BTreeSet;
use std::time::Instant;

use exact_ccd_mesh::{Point, Step};
use nalgebra::Vector3;

use super::{Simulation, SimulationError};
use crate::anchor::Anchor;
use crate::contact::{Collision, Collisions, StiffnessRange};
use crate::damper::Damper;
use crate::dirichlet::{Dirichlet, Motion};
use crate::elasticity::{Chain, Twist};
use crate::energy::Energy;
use crate::friction::{FrictionContact, Smoothing};
use crate::integrator::{Integrator, Scheme};
use crate::iteration::Iteration;
use crate::scripted::Axes;
use crate::solver::{Form, Iterate, Newton, Potential};
use crate::state::{Earlier, State};
use crate::statistics::{Energies, Seconds, Statistics};
use crate::system::turn;

/// A part of a time step. Scripts and loads act in a time step if they act at this part before its end, so
/// that rounding errors of times do not shift them by a time step. It is smaller than the shortest part of a
/// step.
const BEFORE_END: f64 = 1e-8;

/// The part of a time step by which the scripts of a body fall behind if it does not move.
const STUCK: f64 = 0.99;

impl Simulation {
    /// Takes one time step. An error leaves the state unchanged.
    ///
    /// # Errors
    /// [`SimulationError::Singular`], [`SimulationError::Blocked`] and [`SimulationError::Interrupted`].
    pub fn step(&mut self) -> Result<Statistics, SimulationError> {
        self.step_along(&mut |_| ())
    }

    /// Takes one time step, and calls `visit` with all positions after each accepted Newton step.
    ///
    /// The filter applies to these increments, in which all vertices move in straight lines. The straight
    /// motion from the start of the time step to its end is a different one, which may have contacts.
    ///
    /// If Newton's method does not converge or fails, the time step is repeated in twice as many parts of
    /// equal duration, up to [`max_substeps`](crate::Settings::max_substeps). A time step of BDF2 in which
    /// bodies begin or cease to touch is repeated as one of implicit Euler. Only the increments of the last
    /// attempt are visited, when it ends.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    pub fn step_along(
        &mut self,
        visit: &mut (dyn FnMut(&[Point]) + Send),
    ) -> Result<Statistics, SimulationError> {
        // The whole step runs on a thread of the pool: each parallel call from outside the pool would cost a
        // context switch.
        rayon::scope(|_| self.attempts(visit))
    }

    fn attempts(&mut self, visit: &mut dyn FnMut(&[Point])) -> Result<Statistics, SimulationError> {
        let start = self.state.clone();
        let touching = (self.settings.integrator == Integrator::Bdf2).then(|| self.touching());
        let (mut parts, mut seconds, mut is_impact) = (1, Seconds::default(), false);
        loop {
            let is_last = 2 * parts > self.settings.max_substeps;
            let mut increments = Vec::new();
            let mut visit_later = |positions: &[Point]| increments.push(positions.to_vec());
            let found = match self.substeps(parts, !is_last, &mut visit_later) {
                Err(SimulationError::Singular { .. } | SimulationError::Blocked { .. }) if !is_last => None,
                Err(error) => {
                    self.state = start;
                    return Err(error);
                }
                Ok(statistics) => {
                    seconds = seconds.plus(&statistics.seconds);
                    let is_taken = statistics.converged || is_last || self.is_stuck_since(&start);
                    is_taken.then_some(statistics)
                }
            };
            let is_smooth = || touching.as_ref().is_none_or(|before| *before == self.touching());
            match found {
                None => parts *= 2,
                Some(statistics) if is_impact || is_smooth() => {
                    if is_impact {
                        self.state.earlier = None;
                    }
                    increments.iter().for_each(|positions| visit(positions));
                    return Ok(Statistics {
                        seconds,
                        ..statistics
                    });
                }
                Some(_) => is_impact = true,
            }
            self.state = start.clone();
            if is_impact {
                self.state.earlier = None;
            }
        }
    }

    /// Returns true if a body with a script has not moved since a state one time step before, because
    /// something is in its way. Shorter time steps would not move it either.
    fn is_stuck_since(&self, start: &State) -> bool {
        let least = STUCK * self.settings.time_step;
        let mut late = self.state.behind.iter();
        late.any(|(body, behind)| behind - start.behind.get(body).unwrap_or(&0.0) > least)
    }

    /// The pairs of bodies and half spaces in contact.
    fn touching(&self) -> BTreeSet<[usize; 2]> {
        self.contacts().iter().map(|contact| contact.bodies).collect()
    }

    /// Takes one time step in parts of equal duration. If `convergent`, ends after a part that does not
    /// converge. An error leaves the state unchanged.
    fn substeps(
        &mut self,
        parts: usize,
        convergent: bool,
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<Statistics, SimulationError> {
        let start = self.state.clone();
        let mut sum: Option<Statistics> = None;
        for part in 1..=parts {
            // BDF2 needs equal time steps: parts are steps of implicit Euler.
            if parts > 1 {
                self.state.earlier = None;
            }
            match self.advance([part, parts], visit) {
                Ok(statistics) => {
                    let is_last = convergent && !statistics.converged;
                    sum = Some(match sum {
                        None => statistics,
                        Some(before) => before.followed_by(statistics),
                    });
                    if is_last {
                        break;
                    }
                }
                Err(error) => {
                    self.state = start;
                    return Err(error);
                }
            }
        }
        if parts > 1 {
            self.state.earlier = None;
        }
        self.state.step = start.step + 1;
        Ok(sum.unwrap_or_default())
    }

    /// Takes one part, counted from 1, of a time step in equal parts.
    fn advance(
        &mut self,
        [part, parts]: [usize; 2],
        visit: &mut dyn FnMut(&[Point]),
    ) -> Result<Statistics, SimulationError> {
        let clock = Instant::now();
        let mut memory = std::mem::take(&mut self.memory);
        let Self { system, settings, .. } = &*self;
        let step = self.state.step + 1;
        let time_step = settings.time_step / parts as f64;
        let end = |part: usize| (self.state.step as f64 + part as f64 / parts as f64) * settings.time_step;
        let moment = |part: usize| end(part) - BEFORE_END * settings.time_step;
        let (time, before, moment) = (end(part), moment(part - 1), moment(part));
        let mut statistics = Statistics {
            step,
            time,
            converged: true,
            ..Statistics::default()
        };
        let scheme = settings
            .integrator
            .scheme(&self.state, time_step, settings.damping);
        let smoothing = Smoothing {
            threshold: settings.friction.static_velocity.meters(system.size()) * scheme.duration,
        };
        let range = StiffnessRange::new(system.size(), system.mean_mass(), &self.barrier);

        let positions = self.state.positions.clone();
        let rest = Step::new(&system.surface, &positions, &positions);
        let candidates = rest
            .map(|step| system.near(step, &self.barrier))
            .unwrap_or_default();
        let collisions = Collisions::new(
            system.contact_surface(settings.formulation),
            &candidates,
            &positions,
            self.barrier,
        );
        let mut lagged = self.kept_stiffness(&scheme);
        let held = system.held(moment);
        let loads = system.accelerations(&self.state.positions, moment);
        let acceleration = |vertex: usize| {
            let load = loads.as_ref().map_or_else(Vector3::zeros, |loads| loads[vertex]);
            Vector3::from(settings.gravity) + load
        };
        let inertia = scheme.inertia(&system.masses, &held, acceleration);
        let dampers = self.dampers(&scheme);
        let origins = system.origins(&self.state.origins, &positions, end(part - 1), [before, moment]);
        let start = end(part - 1);
        let behind = &self.state.behind;
        let at = |vertex: usize, fraction: f64| {
            let late = behind
                .get(&(system.body_of(vertex as u32) as u32))
                .unwrap_or(&0.0);
            time - (1.0 - fraction) * (time - (start - late))
        };
        let path = |vertex: usize, fraction: f64| {
            let origins = system.origins_of(&origins, vertex);
            system.scripts[vertex].position(&origins, moment, at(vertex, fraction))
        };
        // The turn of the ends of a chain up to a fraction of the step: by the earlier scripts, until others
        // begin within the step, and by these.
        let turned = |chain: &Chain, fraction: f64| {
            let during = |is_later: bool| {
                let (origins, then) = if is_later {
                    (&origins, moment)
                } else {
                    (&self.state.origins, before)
                };
                turn(chain, &|vertex, apart| {
                    let vertex = vertex as usize;
                    let scripts = &system.scripts[vertex];
                    let beginnings = scripts.beginning([before, moment]).into_iter().flatten();
                    let [first, last] = [0.0, fraction].map(|part| at(vertex, part));
                    let begin = beginnings.fold(first, f64::max).min(last);
                    let origins = system.origins_of(origins, vertex);
                    let origins = origins.map(|origin| (Vector3::from(origin) + apart).into());
                    let times = if is_later { [begin, last] } else { [first, begin] };
                    times.map(|time| scripts.position(&origins, then, time))
                })
            };
            during(false) + during(true)
        };
        let chains = system.held_chains(&held);
        let angle = |number: &u32| self.state.twists.get(number).copied().unwrap_or(0.0);
        // An obstructed end has turned as far as its body has moved.
        let twists_of = |dirichlet: &Dirichlet<'_>| -> Vec<Twist> {
            let twist = |(number, chain): &(u32, &Chain)| {
                let fraction = dirichlet.fraction(system.body_of(chain.ends()[0][0]) as u32);
                let angle = angle(number) + turned(chain, fraction);
                Twist::new(chain, &self.state.positions, angle)
            };
            chains.iter().map(twist).collect()
        };
        let bodies = (0..).zip(system.body_vertices());
        let motions = bodies.filter_map(|(body, vertices)| {
            let unknowns = vertices
                .clone()
                .filter(|&vertex| system.carriers.of(vertex).is_none());
            Motion::new(body, unknowns, &held, &positions, &path)
        });
        let dirichlet = Dirichlet::new(motions.collect(), &path);
        let mut now = Iterate {
            stiffness: self.stiffness(
                &scheme,
                &inertia,
                &twists_of(&dirichlet),
                &collisions,
                &range,
                &held,
            ),
            dirichlet,
            positions,
            collisions,
        };
        let Self { system, settings, .. } = &*self;
        let tolerance = settings.newton_tolerance(system.size());
        let watch = |iteration: usize, residual: f64, collisions: &Collisions| {
            if let Some(watch) = &self.watch {
                watch(&Iteration {
                    step,
                    part: [part, parts],
                    iteration,
                    residual,
                    tolerance,
                    contacts: collisions.count(),
                });
            }
        };
        let mut friction = Vec::new();
        for lag in 0..settings.friction.lags.max(1) {
            let iterations = statistics.iterations;
            friction = self.friction(&now, lagged.unwrap_or(now.stiffness), &scheme, smoothing);
            let newton = Newton {
                system,
                duration: scheme.duration,
                inertia: &inertia,
                held: &held,
                interrupt: &self.interrupt,
                friction: &friction,
                dampers: &dampers,
                twists: &twists_of,
                barrier: self.barrier,
                range,
                filter: &self.filter,
                formulation: settings.formulation,
                line_search: settings.line_search,
                tolerance,
                max_iterations: settings.max_iterations,
                watch: &watch,
            };
            statistics.converged &= newton.minimise(&mut memory, &mut now, &mut statistics, visit)?;
            lagged = Some(now.stiffness);
            // The forces of an update leave the positions where they are, within the tolerance.
            let is_settled = lag > 0 && statistics.converged && statistics.iterations == iterations + 1;
            if is_settled || !settings.friction.acts() {
                break;
            }
        }

        statistics.contacts = now.collisions.count();
        statistics.minimal_distance = Some(now.collisions.minimal_distance()).filter(|d| d.is_finite());
        statistics.script_lag = now.dirichlet.lag(&now.positions);
        let late = |motion: &Motion| {
            let late = (1.0 - motion.fraction) * (time - start + behind.get(&motion.body).unwrap_or(&0.0));
            (late > 0.0).then_some((motion.body, late))
        };
        let behind = now.dirichlet.motions().iter().filter_map(late).collect();
        let twists = twists_of(&now.dirichlet);
        let twisted = |((number, _), twist): (&(u32, &Chain), &Twist)| (*number, twist.angle(&now.positions));
        let angles = chains.iter().zip(&twists).map(twisted).collect();
        let velocities = scheme.velocities(&now.positions);
        let potential = Potential {
            system,
            duration: scheme.duration,
            stiffness: now.stiffness,
            inertia: &inertia,
            friction: &friction,
            dampers: &dampers,
            twists: &twists,
        };
        statistics.energies = energies(&potential, settings.gravity, time_step, &now, &velocities);
        let touched = self.state.stiffness.is_some() || statistics.contacts > 0;
        statistics.stiffness = touched.then_some(now.stiffness);

        let positions = now.positions;
        self.memory = memory;
        // Parts of a time step do not count.
        let step = self.state.step;
        let before = std::mem::replace(
            &mut self.state,
            State {
                step,
                positions,
                velocities,
                earlier: None,
                stiffness: statistics
                    .stiffness
                    .map(|stiffness| stiffness * scheme.duration.powi(-2)),
                origins,
                behind,
                twists: angles,
            },
        );
        self.state.earlier = Some(Earlier {
            positions: before.positions,
            velocities: before.velocities,
        });
        statistics.seconds.total = clock.elapsed().as_secs_f64();
        Ok(statistics)
    }

    /// κ at the start of a step: the larger of the κ that balances the other forces and the previous κ.
    fn stiffness(
        &self,
        scheme: &Scheme,
        inertia: &[Anchor],
        twists: &[Twist],
        collisions: &Collisions,
        range: &StiffnessRange,
        held: &[Axes],
    ) -> f64 {
        let before = self.kept_stiffness(scheme).unwrap_or(0.0);
        if collisions.as_slice().is_empty() {
            return before.max(range.least);
        }
        let potential = Potential {
            system: &self.system,
            duration: scheme.duration,
            stiffness: before,
            inertia,
            friction: &[],
            dampers: &[],
            twists,
        };
        let positions = &self.state.positions;
        let mut energy = potential.gradient(positions, &[]);
        let mut barriers = Form::of(collisions.as_slice(), 1.0).gradient(positions);
        self.system.carriers.collect(&mut barriers);
        for (place, _) in held
            .as_flattened()
            .iter()
            .enumerate()
            .filter(|(_, is_held)| **is_held)
        {
            energy[place / 3][place % 3] = 0.0;
            barriers[place / 3][place % 3] = 0.0;
        }
        before.max(range.balance(&energy, &barriers))
    }

    /// The damping of the elastic elements in proportion to their stiffness.
    fn dampers(&self, scheme: &Scheme) -> Vec<Damper> {
        let factor = self.settings.stiffness_damping * scheme.duration;
        if factor == 0.0 || self.settings.integrator == Integrator::QuasiStatic {
            return Vec::new();
        }
        let elements = self.system.elements.iter();
        elements
            .map(|element| Damper::new(&**element, &self.state.positions, &scheme.origin, factor))
            .collect()
    }

    /// The κ of this step with which the barrier has the same forces as in the previous step.
    fn kept_stiffness(&self, scheme: &Scheme) -> Option<f64> {
        let energy = self.state.stiffness;
        energy.map(|stiffness| stiffness * scheme.duration * scheme.duration)
    }

    fn friction(
        &self,
        now: &Iterate<'_>,
        stiffness: f64,
        scheme: &Scheme,
        smoothing: Smoothing,
    ) -> Vec<FrictionContact> {
        if !self.settings.friction.acts() {
            return Vec::new();
        }
        let contact = |collision: &Collision| {
            let coefficient = self.coefficients.of(self.system.bodies_of(collision));
            if coefficient == 0.0 {
                return None;
            }
            let bound = coefficient * stiffness * collision.normal_force(&now.positions);
            let vertices = collision.vertices().iter().copied().collect();
            let separation = collision.separation(&now.positions);
            Some(FrictionContact::new(
                vertices,
                &scheme.origin,
                &separation,
                bound,
                smoothing,
            ))
        };
        now.collisions.as_slice().iter().filter_map(contact).collect()
    }
}

fn energies(
    potential: &Potential<'_>,
    gravity: Point,
    time_step: f64,
    now: &Iterate<'_>,
    velocities: &[Point],
) -> Energies {
    let masses = || potential.system.masses.iter();
    // The incremental potential is the energy times duration².
    let scale = potential.duration.powi(-2);
    let friction: f64 = potential
        .friction
        .iter()
        .map(|contact| contact.work(&now.positions))
        .sum();
    let gravity = Vector3::from(gravity);
    Energies {
        kinetic: masses()
            .zip(velocities)
            .map(|(m, v)| 0.5 * m * Vector3::from(*v).norm_squared())
            .sum(),
        elastic: potential.elasticity(1.0).value(&now.positions)
            + Form::of(potential.twists, 1.0).value(&now.positions),
        barrier: scale * Form::of(now.collisions.as_slice(), now.stiffness).value(&now.positions),
        // Slips are velocities times the effective time step, which is shorter than the time step for BDF2.
        friction: scale * friction * time_step / potential.duration,
        gravity: masses()
            .zip(&now.positions)
            .map(|(m, x)| -m * gravity.dot(&Vector3::from(*x)))
            .sum(),
    }
}

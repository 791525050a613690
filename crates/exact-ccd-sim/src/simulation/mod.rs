//! Simulations.

mod known;
mod minimise;
mod problem;
mod record;
mod reported_contact;
mod resume;
mod start;
mod step;
mod warning;

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::checkpoint::Checkpoint;
use crate::energies::contact::{Barrier, StiffnessRange};
use crate::energies::friction::Coefficients;
use crate::error::SimulationError;
use crate::filter::StepFilter;
use crate::integrator::Scheme;
use crate::iteration::{Iteration, Watch};
use crate::range::{OutOfRange, check, check_finite, check_not_negative};
use crate::settings::{LineSearch, Settings};
use crate::solver::Memory;
use crate::state::State;
use crate::system::{Fingerprint, System};

use known::KnownCollisions;
pub use reported_contact::Contact;
pub use warning::Warning;

/// The motion of a system under elasticity, gravity, contact and friction.
///
/// ```
/// use exact_ccd_sim::{Body, Settings, Simulation, System, shapes};
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
    /// The mean stiffness of a vertex at rest, in N/m.
    stiffness: f64,
    settings: Settings,
    filter: StepFilter,
    barrier: Barrier,
    coefficients: Coefficients,
    memory: Memory,
    state: State,
    known: Option<KnownCollisions>,
    fingerprint: Fingerprint,
    interrupt: Arc<AtomicBool>,
    watch: Option<Arc<Watch>>,
}

impl Simulation {
    /// The simulation of a system from its initial positions and velocities.
    ///
    /// # Errors
    /// [`SimulationError`] names the setting that is out of range, or two primitives that intersect or touch
    /// at the start. A body entirely inside another one has no such pair: it is accepted and stays inside.
    pub fn new(system: System, settings: Settings) -> Result<Self, SimulationError> {
        let state = start::state(&system);
        Self::resume(system, settings, state)
    }

    /// The simulation of a system from its initial positions and velocities, with a filter, whose name
    /// replaces the name in the settings.
    ///
    /// # Errors
    /// As for [`Simulation::new`] and [`Simulation::with_filter`].
    pub fn with_method(
        system: System,
        settings: Settings,
        filter: StepFilter,
    ) -> Result<Self, SimulationError> {
        let state = start::state(&system);
        Self::resume_with(system, settings, state, filter)
    }

    /// The simulation of a system from an earlier state.
    ///
    /// # Errors
    /// [`SimulationError`] names the setting that is out of range, the part of the state that does not match
    /// the system, or two primitives that intersect or touch, as in [`Simulation::new`].
    pub fn resume(system: System, settings: Settings, state: State) -> Result<Self, SimulationError> {
        let filter = StepFilter::default();
        if !settings.ccd.eq_ignore_ascii_case(filter.name()) {
            return Err(SimulationError::Method { name: settings.ccd });
        }
        Self::resume_with(system, settings, state, filter)
    }

    /// [`Simulation::resume`] with a filter, whose name replaces the name in the settings.
    pub(crate) fn resume_with(
        system: System,
        mut settings: Settings,
        state: State,
        filter: StepFilter,
    ) -> Result<Self, SimulationError> {
        check_filter(&system, &settings, &filter)?;
        filter.name().clone_into(&mut settings.ccd);
        settings.check(system.size())?;
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
        check_numbers(&state).map_err(SimulationError::InState)?;
        start::check(&system, &state)?;
        let distance = settings.contact_distance.meters(system.size());
        let barrier = Barrier::new(distance);
        if !StiffnessRange::new(system.size(), system.mean_mass(), 0.0, &barrier).is_valid() {
            let expected =
                "a length for which the masses give a positive and finite stiffness of the barrier";
            check(false, "contact-distance", distance, expected)?;
        }
        let coefficients = Coefficients::new(&settings.friction, &system)
            .map_err(|(pair, source)| SimulationError::FrictionPair { pair, source })?;
        Ok(Self {
            coefficients,
            fingerprint: Fingerprint::of(&system),
            stiffness: system.mean_stiffness(),
            system,
            settings,
            filter,
            barrier,
            memory: Memory::default(),
            state,
            known: None,
            interrupt: Arc::default(),
            watch: None,
        })
    }

    /// The same simulation with another filter. Settings and checkpoints then have the name of this filter.
    ///
    /// # Errors
    /// [`SimulationError::Offset`] and [`SimulationError::ByVertex`], if the method of the filter is not
    /// exact, and a body has an offset or the line search is by vertex.
    pub fn with_filter(mut self, filter: StepFilter) -> Result<Self, SimulationError> {
        check_filter(&self.system, &self.settings, &filter)?;
        filter.name().clone_into(&mut self.settings.ccd);
        self.filter = filter;
        Ok(self)
    }

    /// The same simulation with a flag that interrupts it: once the flag is true, a time step ends with
    /// [`SimulationError::Interrupted`] before its next Newton iteration.
    #[must_use]
    pub fn with_interrupt(self, interrupt: Arc<AtomicBool>) -> Self {
        Self { interrupt, ..self }
    }

    /// The same simulation with a function that is called in each iteration of Newton's method, also of
    /// attempts at a time step that are repeated in parts: for displays of progress. No result depends on it.
    #[must_use]
    pub fn with_watch(self, watch: impl Fn(&Iteration) + Send + Sync + 'static) -> Self {
        let watch = Some(Arc::new(watch) as Arc<Watch>);
        Self { watch, ..self }
    }

    /// The filter.
    #[must_use]
    pub fn filter(&self) -> &StepFilter {
        &self.filter
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

    /// The current state, from which [`Simulation::resume`] continues.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// A checkpoint of the current state. [`Checkpoint::resume`] compares settings and system with the
    /// checkpoint, then continues from this state.
    #[must_use]
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            settings: self.settings.clone(),
            system: self.fingerprint.clone(),
            state: self.state.clone(),
        }
    }

    /// The range of the barrier's stiffness for the equations of a time step.
    fn range(&self, scheme: &Scheme) -> StiffnessRange {
        let (mass, square) = (self.system.mean_mass(), scheme.duration * scheme.duration);
        let gravity = Vector3::from(self.settings.gravity).norm();
        let inertia = (scheme.inertia * mass).max(ELASTIC * square * self.stiffness);
        StiffnessRange::new(
            self.system.size(),
            inertia,
            square * mass * gravity,
            &self.barrier,
        )
    }

    /// The simulated time, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.state.step as f64 * self.settings.time_step
    }
}

/// The part of the elastic stiffness of a vertex that counts as much as its inertia for the stiffness of the
/// barrier. So inertia determines it for rubber in common time steps, as in *Incremental Potential Contact*,
/// and elasticity in long ones.
const ELASTIC: f64 = 0.01;

/// Checks that the numbers of a state are finite, and the stiffness not negative.
fn check_numbers(state: &State) -> Result<(), OutOfRange> {
    // Steps below 2⁵³ are exact as an f64.
    let step = state.step;
    check(
        step < 1 << f64::MANTISSA_DIGITS,
        "step",
        step,
        "a number below 2⁵³",
    )?;
    let finite = |field, points: &[Point]| {
        let mut points = points.iter();
        points.try_for_each(|point| check_finite(field, point))
    };
    finite("positions", &state.positions)?;
    finite("velocities", &state.velocities)?;
    if let Some(earlier) = &state.earlier {
        finite("earlier.positions", &earlier.positions)?;
        finite("earlier.velocities", &earlier.velocities)?;
    }
    for origins in state.origins.values() {
        finite("origins", origins)?;
    }
    let mut times = state.behind.values();
    times.try_for_each(|&time| check_not_negative("behind", time))?;
    for angle in state.twists.values() {
        check(angle.is_finite(), "twists", angle, "a finite number")?;
    }
    check_not_negative("stiffness", state.stiffness.unwrap_or(0.0))
}

/// Checks that the method of a filter takes the offsets of the bodies into account, and that it can decide
/// the steps of vertices.
fn check_filter(system: &System, settings: &Settings, filter: &StepFilter) -> Result<(), SimulationError> {
    let affine = system.carriers.bodies().first();
    if let (LineSearch::Vertex, Some(carried)) = (settings.line_search, affine) {
        let body = system.bodies.designation(system.bodies.of(carried.start));
        return Err(SimulationError::AffineByVertex { body });
    }
    if filter.is_exact() {
        return Ok(());
    }
    let name = filter.name().to_owned();
    if system.is_thick() {
        return Err(SimulationError::Offset { name });
    }
    match settings.line_search {
        LineSearch::Common => Ok(()),
        LineSearch::Vertex => Err(SimulationError::ByVertex { name }),
    }
}

impl fmt::Debug for Simulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Simulation")
            .field("settings", &self.settings)
            .field("filter", &self.filter.name())
            .field("state", &self.state)
            .finish_non_exhaustive()
    }
}

//! Time, contact and solver.

use exact_ccd_mesh::Point;

use super::entry::{Entry, NOTHING, Rule};
use crate::fault::Fault;
use exact_ccd_sim::{Formulation, Friction, Integrator, Length, Settings};

const SOLVER: Rule = Rule::Ignored("it concerns the method by which PolyFEM solves a time step");

/// The duration and the time step in s.
pub(super) struct Time {
    pub(super) duration: f64,
    pub(super) step: f64,
    integrator: Integrator,
}

/// Checks that lengths are in m and elements linear.
pub(super) fn check_units_and_space(root: &Entry<'_>) -> Result<(), Fault> {
    if let Some(units) = root.get("units") {
        units.check(&[
            ("length", Rule::Only("m")),
            ("mass", Rule::Only("kg")),
            ("time", Rule::Only("s")),
            ("characteristic_length", SOLVER),
        ])?;
    }
    if let Some(space) = root.get("space") {
        space.check(&[
            ("discr_order discr_orderq", Rule::Only("1")),
            ("pressure_discr_order poly_basis_type advanced", SOLVER),
            ("basis_type", Rule::Only("Lagrange")),
            ("use_p_ref", NOTHING),
            ("remesh", Rule::Said),
        ])?;
        if let Some(remesh) = space.get("remesh")
            && remesh.flag("enabled")?
        {
            return Err(remesh.unsupported("meshes that change", "write `\"enabled\": false`"));
        }
    }
    Ok(())
}

/// The key `time`.
pub(super) fn time(root: &Entry<'_>) -> Result<Time, Fault> {
    let Some(time) = root.get("time") else {
        let instead = "add `time`, with `\"quasistatic\": true` for a sequence of equilibria";
        return Err(root.unsupported("a static problem", instead));
    };
    time.check(&[
        ("t0", Rule::Only("0")),
        ("tend dt time_steps integrator quasistatic", Rule::Said),
    ])?;
    let number = |key| time.get(key).map(|entry| entry.number()).transpose();
    let (duration, step) = match (number("tend")?, number("dt")?, number("time_steps")?) {
        (Some(end), Some(step), _) => (end, step),
        (Some(end), None, Some(count)) => (end, end / count),
        (None, Some(step), Some(count)) => (step * count, step),
        _ => return Err(time.invalid("two of `tend`, `dt` and `time_steps`")),
    };
    let integrator = match time.get("integrator") {
        _ if time.flag("quasistatic")? => Integrator::QuasiStatic,
        None => Integrator::ImplicitEuler,
        Some(entry) => integrator(&entry)?,
    };
    Ok(Time {
        duration,
        step,
        integrator,
    })
}

fn integrator(entry: &Entry<'_>) -> Result<Integrator, Fault> {
    let name = entry.get("type").unwrap_or_else(|| entry.clone());
    let order = entry.get("steps").map_or(Ok(1), |steps| steps.integer())?;
    match (name.text()?, order) {
        ("ImplicitEuler" | "BDF1", _) | ("BDF", 1) => Ok(Integrator::ImplicitEuler),
        ("BDF2", _) | ("BDF", 2) => Ok(Integrator::Bdf2),
        _ => Err(entry.unsupported("this time integration", "write \"ImplicitEuler\" or \"BDF2\"")),
    }
}

/// The settings of `contact` and `solver`. `shortest_edge` is the length of the shortest edge of all
/// surfaces, in m.
pub(super) fn settings(
    root: &Entry<'_>,
    time: &Time,
    gravity: Point,
    shortest_edge: f64,
) -> Result<Settings, Fault> {
    let Some(contact) = root
        .get("contact")
        .filter(|contact| contact.value.get("enabled") == Some(&true.into()))
    else {
        let instead = "write `\"enabled\": true` in `contact`";
        return Err(root.unsupported("bodies that pass through each other", instead));
    };
    contact.check(&[
        (
            "enabled dhat dhat_percentage epsv friction_coefficient use_convergent_formulation",
            Rule::Said,
        ),
        (
            "use_area_weighting use_improved_max_operator use_physical_barrier",
            Rule::Only("true"),
        ),
        ("min_distance_ratio alpha_t alpha_n", SOLVER),
        (
            "use_adaptive_dhat use_gcp_formulation collision_mesh periodic adhesion",
            NOTHING,
        ),
    ])?;
    let formulation = if contact.flag("use_convergent_formulation")? {
        Formulation::Convergent
    } else {
        Formulation::Sum
    };
    let (lags, max_iterations) = solver(root)?;
    Ok(Settings {
        time_step: time.step,
        gravity,
        integrator: time.integrator,
        contact_distance: Length::Absolute(contact_distance(&contact, shortest_edge)?),
        formulation,
        friction: Friction {
            coefficient: contact.number_or("friction_coefficient", 0.0)?,
            static_velocity: Length::Absolute(contact.number_or("epsv", 1e-3)?),
            lags,
            ..Friction::default()
        },
        max_iterations,
        ..Settings::default()
    })
}

/// The contact distance: if it is not given, and its default exceeds the shortest edge, a share of that edge.
fn contact_distance(contact: &Entry<'_>, shortest_edge: f64) -> Result<f64, Fault> {
    let default = 1e-3;
    match contact.get("dhat") {
        Some(distance) => distance.number(),
        None if default > shortest_edge => Ok(contact.number_or("dhat_percentage", 0.8)? * shortest_edge),
        None => Ok(default),
    }
}

/// The numbers of friction lags and of Newton iterations.
fn solver(root: &Entry<'_>) -> Result<(usize, usize), Fault> {
    let (mut lags, mut iterations) = (1, 500);
    let Some(solver) = root.get("solver") else {
        return Ok((lags, iterations));
    };
    solver.check(&[
        (
            "max_threads linear adjoint_linear augmented_lagrangian advanced",
            SOLVER,
        ),
        ("nonlinear contact", Rule::Said),
        ("rayleigh_damping", NOTHING),
    ])?;
    let positive = |entry: Option<Entry<'_>>, default| match entry {
        None => Ok(default),
        Some(entry) => {
            let number = usize::try_from(entry.integer()?).ok();
            let number = number.filter(|&number| number > 0);
            number.ok_or_else(|| entry.invalid("an integer above 0"))
        }
    };
    if let Some(nonlinear) = solver.get("nonlinear") {
        iterations = positive(nonlinear.get("max_iterations"), iterations)?;
        nonlinear
            .note("ignored but for `max_iterations`: the tolerance of Newton's method is a velocity here");
    }
    if let Some(contact) = solver.get("contact") {
        let ccd = "contact is decided exactly; `settings.ccd` selects another method";
        contact.check(&[
            ("CCD", Rule::Ignored(ccd)),
            ("friction_iterations", Rule::Said),
            (
                "tangential_adhesion_iterations friction_convergence_tol initial_barrier_stiffness",
                SOLVER,
            ),
            ("barrier_stiffness", Rule::Only("adaptive")),
        ])?;
        lags = positive(contact.get("friction_iterations"), lags)?;
    }
    Ok((lags, iterations))
}

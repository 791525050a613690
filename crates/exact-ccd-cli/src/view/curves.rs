//! The curves of a simulation, with a value for each time step.

use exact_ccd_sim::Energies;
use exact_ccd_view::Curve;

/// All energies that are not zero, in J. The energy of gravity is relative to its least value.
pub(crate) fn energies(steps: &[Energies]) -> Vec<Curve> {
    let lowest = steps
        .iter()
        .fold(f64::INFINITY, |least, step| least.min(step.gravity));
    let energy = |name: &str, energy: &dyn Fn(&Energies) -> f64| {
        curve(name, steps.iter().map(|step| Some(energy(step))).collect())
    };
    let curves = [
        energy("sum", &|step| step.mechanical() - lowest),
        energy("kinetic", &|step| step.kinetic),
        energy("elastic", &|step| step.elastic),
        energy("gravity", &|step| step.gravity - lowest),
        energy("barrier", &|step| step.barrier),
        energy("friction", &|step| step.friction),
    ];
    let is_there = |curve: &Curve| curve.values.iter().any(|energy| *energy != Some(0.0));
    curves.into_iter().filter(is_there).collect()
}

/// The minimal distance in m, where there are contacts, and the contact distance.
pub(crate) fn distances(minimal: Vec<Option<f64>>, contact_distance: f64) -> Vec<Curve> {
    let contact = vec![Some(contact_distance); minimal.len()];
    vec![
        curve("minimal distance", minimal),
        curve("contact distance", contact),
    ]
}

/// The curve of these values.
pub(crate) fn curve(name: &str, values: Vec<Option<f64>>) -> Curve {
    let name = name.to_owned();
    Curve { name, values }
}

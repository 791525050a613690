//! The charts of a simulation.

use exact_ccd_sim::{Energies, Statistics};
use exact_ccd_view::{Chart, Curve, History};

/// The charts of time steps: energies, minimal distance and contacts. `start` is the time of the first frame,
/// before the first of these steps; `contact_distance` is d̂, in m.
pub(super) fn of(start: f64, steps: &[Statistics], contact_distance: f64) -> History {
    let minimal = curve("minimal distance", steps, |step| step.minimal_distance);
    let has_contact = minimal.values.iter().any(Option::is_some);
    let distance = Chart {
        title: "Minimal distance".to_owned(),
        unit: "m".to_owned(),
        logarithmic: true,
        curves: vec![
            minimal,
            curve("contact distance", steps, |_| Some(contact_distance)),
        ],
    };
    let contacts = Chart {
        title: "Contacts".to_owned(),
        curves: vec![curve("contacts", steps, |step| Some(step.contacts as f64))],
        ..Chart::default()
    };
    let charts = [
        Some(energies(steps)),
        has_contact.then_some(distance),
        Some(contacts),
    ];
    History {
        times: std::iter::once(start)
            .chain(steps.iter().map(|step| step.time))
            .map(|time| time + 0.0)
            .collect(),
        charts: charts.into_iter().flatten().collect(),
    }
}

/// The curve of a value over the time steps, with none at the start.
fn curve(name: &str, steps: &[Statistics], value: impl Fn(&Statistics) -> Option<f64>) -> Curve {
    Curve {
        name: name.to_owned(),
        values: std::iter::once(None).chain(steps.iter().map(value)).collect(),
    }
}

/// The chart of all energies that are not zero. The energy of gravity is relative to its least value.
fn energies(steps: &[Statistics]) -> Chart {
    let lowest = steps
        .iter()
        .fold(f64::INFINITY, |least, step| least.min(step.energies.gravity));
    let energy = |name: &str, energy: &dyn Fn(&Energies) -> f64| {
        curve(name, steps, |step| Some(energy(&step.energies)))
    };
    let curves = vec![
        energy("sum", &|energies| energies.mechanical() - lowest),
        energy("kinetic", &|energies| energies.kinetic),
        energy("elastic", &|energies| energies.elastic),
        energy("gravity", &|energies| energies.gravity - lowest),
        energy("barrier", &|energies| energies.barrier),
        energy("friction", &|energies| energies.friction),
    ];
    let is_there = |curve: &Curve| {
        curve
            .values
            .iter()
            .any(|value| value.is_some_and(|energy| energy != 0.0))
    };
    Chart {
        title: "Energies".to_owned(),
        unit: "J".to_owned(),
        logarithmic: false,
        curves: curves.into_iter().filter(is_there).collect(),
    }
}

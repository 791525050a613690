//! The charts of a simulation.

use exact_ccd_sim::{Energies, Statistics};
use exact_ccd_view::{Chart, Curve, History};

use crate::view::curves;

/// The charts of time steps: energies, minimal distance and contacts. `start` is the time of the first frame,
/// before the first of these steps; `contact_distance` is d̂, in m.
pub(super) fn of(start: f64, steps: &[Statistics], contact_distance: f64) -> History {
    let energies: Vec<Energies> = steps.iter().map(|step| step.energies).collect();
    let minimal: Vec<_> = steps.iter().map(|step| step.minimal_distance).collect();
    let has_contact = minimal.iter().any(Option::is_some);
    let contacts = steps.iter().map(|step| Some(step.contacts as f64)).collect();
    let distances = || Chart {
        logarithmic: true,
        ..chart(
            "Minimal distance",
            "m",
            curves::distances(minimal, contact_distance),
        )
    };
    let charts = [
        Some(chart("Energies", "J", curves::energies(&energies))),
        has_contact.then(distances),
        Some(chart("Contacts", "", vec![curves::curve("contacts", contacts)])),
    ];
    History {
        times: std::iter::once(start)
            .chain(steps.iter().map(|step| step.time))
            .map(|time| time + 0.0)
            .collect(),
        charts: charts.into_iter().flatten().collect(),
    }
}

/// A chart of curves over the time steps, with no value at the start.
fn chart(title: &str, unit: &str, mut curves: Vec<Curve>) -> Chart {
    curves.iter_mut().for_each(|curve| curve.values.insert(0, None));
    Chart {
        title: title.to_owned(),
        unit: unit.to_owned(),
        logarithmic: false,
        curves,
    }
}

//! The filters of line searches, by the names of their methods.

use std::sync::Arc;

use exact_ccd::Exact;
use exact_ccd_mesh::Aabb;
use exact_ccd_methods::UnknownMethod;
use exact_ccd_methods::parity::{Displacement, RootParity};
use exact_ccd_sim::{StepFilter, System};

/// The exact decision by bisection, in place of the exact time of impact.
const BISECTION: &str = "bisection";

/// The size of the box in which parity expects a scene to stay, relative to the box of the scene at the
/// start.
const ROOM: f64 = 4.0;

/// The names of all filters.
pub(super) fn names() -> Vec<String> {
    let mut names: Vec<String> = exact_ccd_methods::names()
        .iter()
        .map(|name| name.to_lowercase())
        .collect();
    names.insert(1, BISECTION.to_owned());
    names
}

/// Checks that there is a filter of a name.
pub(super) fn check(name: &str) -> Result<(), UnknownMethod> {
    let known = names();
    if known.contains(&name.to_lowercase()) {
        return Ok(());
    }
    Err(UnknownMethod {
        name: name.to_owned(),
        known,
    })
}

/// The filter of a name, in upper or lower case, for a system.
pub(super) fn by_name(name: &str, system: &System) -> Result<StepFilter, UnknownMethod> {
    check(name)?;
    let name = name.to_lowercase();
    Ok(match name.as_str() {
        BISECTION => StepFilter::by_bisection(BISECTION, Arc::new(Exact)),
        "parity" => {
            let method = RootParity::in_scene(displacement(system));
            StepFilter::new(&name, Arc::new(method))
        }
        _ => StepFilter::new(&name, exact_ccd_methods::by_name(&name)?.into()),
    })
}

/// The displacement for the box in which a scene is expected to stay.
fn displacement(system: &System) -> Displacement {
    let bounds: Aabb = system.start().iter().copied().collect();
    if bounds == Aabb::EMPTY {
        return Displacement::default();
    }
    let margin = 0.5 * (ROOM - 1.0) * system.extent();
    let lower = bounds.lower.map(|x| x - margin);
    Displacement::of_box(lower, bounds.upper.map(|x| x + margin))
}

#[cfg(test)]
mod tests {
    use exact_ccd_mesh::{Bvh, Candidates, Step, TriangleMesh};

    use super::*;

    /// A vertex falls through a triangle at t = 3/4.
    #[test]
    fn every_method_stops_short_of_the_contact() {
        let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        let at = |height: f64| {
            [
                [0.0, 0.0, 0.0],
                [4.0, 0.0, 0.0],
                [0.0, 4.0, 0.0],
                [1.0, 1.0, height],
                [1.0, 1.2, height + 9.0],
                [1.2, 1.0, height + 9.0],
            ]
        };
        let (start, end) = (at(3.0), at(-1.0));
        let step = Step::new(&mesh, &start, &end).unwrap();
        let candidates = Candidates::new(step, &Bvh);
        let system = System::new(&[], &[]).unwrap();
        let names = names();
        assert_eq!(names[..3], ["exact", "bisection", "parity"]);
        assert!(names.len() >= 11);
        for name in names {
            let filter = by_name(&name.to_uppercase(), &system).unwrap();
            assert_eq!(filter.name(), name);
            let size = filter.free_part(&candidates, step, system.min_distance());
            assert!((0.5..=0.75).contains(&size), "{name}: {size}");
            assert!(
                !filter.is_free(&candidates, step, system.min_distance()),
                "{name}"
            );
            let middle = step.at(0.5);
            let half = Step::new(&mesh, &start, &middle).unwrap();
            assert!(filter.is_free(&candidates, half, system.min_distance()), "{name}");
            assert_eq!(
                filter.free_part(&candidates, half, system.min_distance()),
                1.0,
                "{name}"
            );
        }
        let error = by_name("luck", &system).unwrap_err();
        assert_eq!(error.known[..2], ["exact", "bisection"]);
    }
}

//! Rods that are curved at rest.

use exact_ccd_sim::{Body, BodyKind, Script, Settings, Simulation, System, Warning, shapes};

/// The warnings about a coil of two turns without a shear modulus or with one, with these edges held by
/// scripts.
fn warnings(shear: Option<f64>, held: &[u32], turns: f64) -> usize {
    let mut material = shapes::ROPE;
    material.shear = shear;
    let at = |place: u32| {
        let (sin, cos) = (turns * core::f64::consts::TAU * f64::from(place) / 32.0).sin_cos();
        [0.3 * cos, 0.1 * f64::from(place), 0.3 * sin]
    };
    let edges = (0..32).map(|place| [place, place + 1]).collect();
    let coil = Body::new((0..33).map(at).collect(), BodyKind::Rod { edges, material });
    let system = System::new(&[coil], &[Script::Fixed.on(held.iter().copied())]).unwrap();
    let simulation = Simulation::new(system, Settings::default()).unwrap();
    let warnings = simulation.warnings();
    warnings
        .iter()
        .filter(|warning| matches!(warning, Warning::Coil { .. }))
        .count()
}

/// A coil without a shear modulus has no stiffness. The warning is about rods that are curved at rest, and
/// only where a shear modulus would act: between two held edges.
#[test]
fn a_coil_without_shear_is_a_warning() {
    let ends = [0, 1, 31, 32];
    assert_eq!(warnings(None, &ends, 2.0), 1);
    for (shear, held, turns) in [
        (Some(4e5), &ends[..], 2.0),
        (None, &ends[..2], 2.0),
        (None, &ends, 0.0),
    ] {
        assert_eq!(warnings(shear, held, turns), 0, "{shear:?} {held:?} {turns}");
    }
}

//! The unit of relative lengths, and warnings about contact distances.

use exact_ccd_sim::{Designation, HalfSpace, Length, Settings, Simulation, System, Warning, shapes};

fn cube(height: f64) -> exact_ccd_sim::Body {
    shapes::solid_box([1, 1, 1], [0.3; 3]).placed(|[x, y, z]| [x + 50.0, y + height, z + 50.0])
}

/// Lengths are relative to the bodies with mass, whatever the size of an obstacle.
#[test]
fn obstacles_do_not_count() {
    let system = |size: f64| System::new(&[cube(0.01), shapes::floor([1, 1], [size; 2])], &[]).unwrap();
    for size in [100.0, 1e3] {
        let system = system(size);
        assert!(
            (system.size() - 0.3 * 3.0_f64.sqrt()).abs() < 1e-12,
            "{}",
            system.size()
        );
        assert!(system.extent() > size);
    }
    // Without a body that has an extent, the size is the extent of everything.
    let point = shapes::particles([1, 1, 1], [0.0; 3]).placed(|_| [0.5, 1.0, 0.5]);
    let system = System::new(&[point, shapes::floor([1, 1], [1.0; 2])], &[]).unwrap();
    assert_eq!(system.size(), system.extent());
    // The ball around a square of 1 m and a point 1 m above its middle.
    assert!((system.size() - 1.5).abs() < 1e-12, "{}", system.size());
}

/// A small cube above a huge floor comes to rest within the contact distance, a thousandth of its own size.
#[test]
fn a_cube_rests_on_a_huge_floor() {
    for size in [100.0, 1e3] {
        let system = System::new(&[cube(1e-3), shapes::floor([1, 1], [size; 2])], &[]).unwrap();
        let mut simulation = Simulation::new(system, Settings::default()).unwrap();
        for _ in 0..50 {
            assert!(simulation.step().unwrap().converged);
        }
        let height = simulation
            .state()
            .positions
            .iter()
            .take(8)
            .map(|x| x[1])
            .fold(1.0, f64::min);
        let distance = 1e-3 * simulation.system().size();
        assert!(0.0 < height && height < distance, "{height} m");
    }
}

#[test]
fn warnings_name_the_bodies() {
    let floor = shapes::floor([1, 1], [100.0; 2]);
    let warnings = |height: f64, distance: f64| {
        let system = System::new(&[cube(height), floor.clone()], &[]).unwrap();
        let contact_distance = Length::Absolute(distance);
        let settings = Settings {
            contact_distance,
            ..Settings::default()
        };
        Simulation::new(system, settings).unwrap().warnings()
    };
    assert_eq!(warnings(0.01, 1e-3), []);
    let near = Warning::Near {
        bodies: [0, 1].map(|place| Designation::of_body(place, "")),
        gap: 0.01,
        distance: 0.02,
    };
    assert_eq!(warnings(0.01, 0.02), std::slice::from_ref(&near));
    assert!(
        near.to_string()
            .starts_with("body[0] and body[1] start 1.000e-2 m apart, less than ")
    );
    let named = [cube(0.01).named("cube"), floor.clone()];
    let settings = Settings {
        contact_distance: Length::Absolute(0.02),
        ..Settings::default()
    };
    let named = Simulation::new(System::new(&named, &[]).unwrap(), settings).unwrap();
    let text = named.warnings()[0].to_string();
    assert!(
        text.starts_with("body `cube` and body[1] start 1.000e-2 m apart, less than "),
        "{text}"
    );
    let coarse = warnings(0.01, 0.1);
    let [Warning::ContactDistance { body, size, .. }, Warning::Near { .. }] = &coarse[..] else {
        panic!("the distance is a fifth of the cube");
    };
    assert_eq!(body.place(), 0);
    assert!((size - 0.3 * 3.0_f64.sqrt()).abs() < 1e-12);
    // A half space has no body: the vertex that is near it counts.
    let ground = HalfSpace::new([0.0, -1e-3, 0.0], [0.0, 1.0, 0.0]);
    let system = System::new(&[cube(0.0)], &[])
        .unwrap()
        .with_half_spaces(vec![ground])
        .unwrap();
    let settings = Settings {
        contact_distance: Length::Absolute(0.01),
        ..Settings::default()
    };
    let warning = &Simulation::new(system, settings).unwrap().warnings()[0];
    assert!(
        warning
            .to_string()
            .starts_with("body[0] and half-space[0] start 1.000e-3 m apart, "),
        "{warning}"
    );
}

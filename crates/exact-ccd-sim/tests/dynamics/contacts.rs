//! The contacts of a state.

use exact_ccd_sim::{Body, Formulation, HalfSpace, Settings, Simulation, System, shapes};
use nalgebra::Vector3;

fn cube() -> Body {
    shapes::solid_box([2, 2, 2], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 5e-4, z + 0.2])
}

/// The forces of all contacts of a cube at rest add up to its weight, in both formulations, on a floor of
/// triangles and on a half space.
#[test]
fn the_contact_forces_of_a_cube_at_rest_bear_its_weight() {
    let floor = shapes::floor([1, 1], [1.1, 1.2]).placed(|[x, _, z]| [x, 0.0, z]);
    let on_floor = System::new(&[cube(), floor], &[]).unwrap();
    let ground = HalfSpace::new([0.0; 3], [0.0, 3.0, 0.0]);
    let on_ground = System::new(&[cube()], &[]).unwrap();
    let on_ground = on_ground.with_half_spaces(vec![ground]).unwrap();
    for (system, formulation) in [
        (on_floor.clone(), Formulation::Sum),
        (on_floor, Formulation::Convergent),
        (on_ground, Formulation::Convergent),
    ] {
        let weight = 9.81 * system.masses().iter().sum::<f64>();
        let settings = Settings {
            formulation,
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        assert!(
            simulation
                .contacts()
                .iter()
                .all(|contact| contact.force == [0.0; 3])
        );
        for _ in 0..150 {
            assert!(simulation.step().unwrap().converged);
        }
        let contacts = simulation.contacts();
        let sum: Vector3<f64> = contacts.iter().map(|contact| Vector3::from(contact.force)).sum();
        let error = (sum - Vector3::new(0.0, weight, 0.0)).norm();
        assert!(
            error < 0.01 * weight,
            "{formulation:?}: {sum}, expected {weight} N"
        );
        for contact in &contacts {
            // The cube is the first body, the obstacle the second one.
            let [cube, obstacle] = contact.points;
            let is_cube_first = contact.bodies == [0, 1];
            assert!(is_cube_first || contact.bodies == [1, 0], "{contact:?}");
            let (above, below) = if is_cube_first {
                (cube, obstacle)
            } else {
                (obstacle, cube)
            };
            assert!(below[1].abs() < 1e-12 && above[1] > 0.0, "{contact:?}");
            let distance = (Vector3::from(above) - Vector3::from(below)).norm();
            assert!((distance - contact.distance).abs() < 1e-12, "{contact:?}");
            assert!(contact.distance < 1e-3 * 3.0_f64.sqrt(), "{contact:?}");
        }
    }
}

//! A simulation starts only where nothing meets.

use exact_ccd_sim::{Body, BodyKind, Primitive, Settings, Simulation, SimulationError, System, shapes};

/// An obstacle of one triangle in the plane of x and z, at a height.
fn triangle(height: f64) -> Body {
    Body {
        points: vec![[-1.0, height, -1.0], [3.0, height, -1.0], [-1.0, height, 3.0]],
        kind: BodyKind::Obstacle {
            faces: vec![[0, 1, 2]],
        },
        velocity: [0.0; 3],
    }
}

fn start(bodies: &[Body]) -> Result<Simulation, SimulationError> {
    Simulation::new(System::new(bodies, &[]).unwrap(), Settings::default())
}

/// What meets at the start, with its vertices.
fn meeting(bodies: &[Body]) -> [Primitive; 2] {
    match start(bodies).err().unwrap() {
        SimulationError::Start { primitives, .. } => primitives,
        other => panic!("{other}"),
    }
}

#[test]
fn what_meets_at_the_start_is_named() {
    let cube = || shapes::solid_box([2, 2, 2], [0.5; 3]);
    assert!(start(&[cube(), triangle(-0.1)]).is_ok());
    // 27 vertices, of which the one in the middle is not on the surface.
    for height in [0.0, 0.1] {
        let error = start(&[cube(), triangle(height)]).err().unwrap();
        assert!(error.to_string().contains("[27, 28, 29]"), "{error}");
        assert!(
            error.to_string().contains("meet where the simulation starts"),
            "{error}"
        );
    }
    let [Primitive::Edge(edge), Primitive::Face(face)] = meeting(&[triangle(0.1), cube()]) else {
        panic!("an edge passes through the face")
    };
    assert_eq!(face, [0, 1, 2]);
    assert!(edge.iter().all(|vertex| (3..30).contains(vertex)));
}

/// An audit would complain of them too.
#[test]
fn obstacles_do_not_meet_either() {
    let steep = triangle(0.0).placed(|[x, y, z]| [x, y + x, z]);
    let meeting = meeting(&[triangle(0.0), steep]);
    assert!(matches!(meeting, [Primitive::Edge(_), Primitive::Face(_)]));
}

#[test]
fn a_state_in_which_things_meet_is_refused() {
    let bodies = [shapes::solid_box([1, 1, 1], [0.5; 3]), triangle(-0.1)];
    let state = start(&bodies).unwrap().state().clone();
    let resume = |change: &dyn Fn(&mut exact_ccd_sim::State)| {
        let mut state = state.clone();
        change(&mut state);
        Simulation::resume(System::new(&bodies, &[]).unwrap(), Settings::default(), state).err()
    };
    assert_eq!(resume(&|_| ()), None);
    let sunk = resume(&|state| state.positions[..8].iter_mut().for_each(|x| x[1] -= 0.3));
    assert!(matches!(sunk, Some(SimulationError::Start { .. })), "{sunk:?}");
    let lost = resume(&|state| state.positions[3][1] = f64::NAN);
    assert_eq!(lost, Some(SimulationError::NotFinite { what: "positions" }));
    let fast = resume(&|state| state.velocities[3][1] = f64::INFINITY);
    assert_eq!(fast, Some(SimulationError::NotFinite { what: "velocities" }));
    let late = resume(&|state| state.step = u64::MAX);
    assert_eq!(late, Some(SimulationError::Late { step: u64::MAX }));
    let stiff = resume(&|state| state.stiffness = Some(f64::NAN));
    assert_eq!(stiff, Some(SimulationError::NotFinite { what: "stiffness" }));
}

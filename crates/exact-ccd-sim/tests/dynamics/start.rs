//! A simulation starts only without intersections.

use exact_ccd_sim::{
    Body, BodyKind, BodyPrimitive, Primitive, Settings, Simulation, SimulationError, System, shapes,
};

/// An obstacle of one triangle in the plane of x and z, at a height.
fn triangle(height: f64) -> Body {
    Body::new(
        vec![[-1.0, height, -1.0], [3.0, height, -1.0], [-1.0, height, 3.0]],
        BodyKind::Obstacle {
            faces: vec![[0, 1, 2]],
        },
    )
}

fn start(bodies: &[Body]) -> Result<Simulation, SimulationError> {
    Simulation::new(System::new(bodies, &[]).unwrap(), Settings::default())
}

/// The primitives that intersect or touch at the start.
fn primitives(bodies: &[Body]) -> [BodyPrimitive; 2] {
    match start(bodies).err().unwrap() {
        SimulationError::Start { primitives, .. } => *primitives,
        other => panic!("{other}"),
    }
}

#[test]
fn errors_name_the_primitives_that_intersect_at_the_start() {
    let cube = || shapes::solid_box([2, 2, 2], [0.5; 3]);
    assert!(start(&[cube(), triangle(-0.1)]).is_ok());
    let triangle = |height| triangle(height).named("plate");
    // One of the 27 vertices of the cube is in its interior, not on the surface.
    for height in [0.0, 0.1] {
        let error = start(&[cube(), triangle(height)]).err().unwrap();
        assert!(
            error.to_string().contains("face [0, 1, 2] of body `plate`"),
            "{error}"
        );
        assert!(
            error.to_string().contains("intersect or touch at the start"),
            "{error}"
        );
    }
    let [plate, cube] = primitives(&[triangle(0.1), cube()]);
    assert_eq!(plate.primitive, Primitive::Face([0, 1, 2]));
    assert_eq!((plate.body.place(), plate.body.name()), (0, "plate"));
    let Primitive::Edge(edge) = cube.primitive else {
        panic!("an edge passes through the face")
    };
    assert!(edge.iter().all(|vertex| (0..27).contains(vertex)));
    assert_eq!(cube.body.to_string(), "body[1]");
}

/// An audit of the motion would report them too.
#[test]
fn intersections_of_obstacles_are_errors() {
    let steep = triangle(0.0).placed(|[x, y, z]| [x + 0.5, y + x, z + 0.25]);
    let primitives = primitives(&[triangle(0.0), steep]);
    let primitives = primitives.map(|of_body| of_body.primitive);
    assert!(matches!(
        primitives,
        [Primitive::Edge(_), Primitive::Face(_)] | [Primitive::Face(_), Primitive::Edge(_)]
    ));
}

#[test]
fn an_invalid_state_is_an_error() {
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
    let field = |error: Option<SimulationError>| match error {
        Some(SimulationError::InState(number)) => number.field,
        error => panic!("{error:?}"),
    };
    assert_eq!(field(lost), "positions");
    let fast = resume(&|state| state.velocities[3][1] = f64::INFINITY);
    assert_eq!(field(fast), "velocities");
    let nowhere = resume(&|state| state.origins.extend([(3, [[f64::NAN; 3]; 3])]));
    assert_eq!(field(nowhere), "origins");
    let late = resume(&|state| state.step = u64::MAX);
    assert_eq!(field(late), "step");
    let stiff = resume(&|state| state.stiffness = Some(f64::NAN));
    assert_eq!(field(stiff), "stiffness");
}

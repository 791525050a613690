//! Bodies with offsets: rods, particles and cloth keep the sum of their offsets, exactly.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{
    Body, BodyPrimitive, Checkpoint, Designation, Friction, Integrator, Length, Primitive, Script,
    ScriptedVertices, Settings, Simulation, SimulationError, Statistics, StepFilter, System, shapes,
};
use nalgebra::Vector3;

use crate::measure::momentum;
use crate::thick_pairs::Increment;

/// The activation distance of the barrier.
const REACH: f64 = 2e-3;

fn settings() -> Settings {
    Settings {
        contact_distance: Length::Absolute(REACH),
        tolerance: Length::Absolute(1e-3),
        ..Settings::default()
    }
}

fn offsets(bodies: &[Body]) -> Vec<f64> {
    let of_body = |body: &Body| std::iter::repeat_n(body.offset, body.points.len());
    bodies.iter().flat_map(of_body).collect()
}

fn moved(body: Body, [x, y, z]: Point) -> Body {
    body.placed(|point| [point[0] + x, point[1] + y, point[2] + z])
}

/// Takes some steps. Checks the distances in each increment.
fn run(
    bodies: &[Body],
    scripts: &[ScriptedVertices],
    settings: Settings,
    steps: usize,
) -> (Simulation, Vec<Statistics>) {
    let system = System::new(bodies, scripts).unwrap();
    let offsets = offsets(bodies);
    let mut simulation = Simulation::new(system.clone(), settings).unwrap();
    let mut before = simulation.state().positions.clone();
    let mut all = Vec::new();
    for _ in 0..steps {
        let statistics = simulation.step_along(&mut |after: &[Point]| {
            let increment = Increment {
                system: &system,
                offsets: &offsets,
                before: &before,
                after,
            };
            increment.assert_thick();
            before = after.to_vec();
        });
        all.push(statistics.unwrap());
    }
    (simulation, all)
}

/// A cloth, a rod and particles fall on a sphere and on each other.
fn heap() -> Vec<Body> {
    let mut beads = moved(
        shapes::particles([2, 1, 2], [0.1, 0.0, 0.1]),
        [-0.05, 0.245, -0.05],
    )
    .with_offset(0.01);
    beads.velocity = [0.0, -2.0, 0.0];
    vec![
        moved(shapes::cloth([8, 8], [0.4, 0.4]), [-0.2, 0.185, -0.2]).with_offset(4e-3),
        moved(shapes::line(8, 0.3), [-0.15, 0.21, 0.01]).with_offset(8e-3),
        beads,
        shapes::sphere(2, 0.15).with_offset(0.01),
    ]
}

#[test]
fn no_increment_brings_surfaces_within_their_thickness() {
    let (_, all) = run(&heap(), &[], settings(), 25);
    let contacts = all.last().unwrap().contacts;
    assert!(contacts > 20, "{contacts}");
    for statistics in &all {
        assert!(statistics.converged, "{statistics:?}");
        // The distance between surfaces is that beyond the thickness.
        assert!(
            statistics
                .minimal_distance
                .is_none_or(|distance| (0.0..REACH).contains(&distance))
        );
    }
}

#[test]
fn a_resumed_heap_has_the_same_bits() {
    let settings = Settings {
        integrator: Integrator::Bdf2,
        friction: Friction {
            coefficient: 0.3,
            ..Friction::default()
        },
        ..settings()
    };
    let mut whole = Simulation::new(System::new(&heap(), &[]).unwrap(), settings.clone()).unwrap();
    let mut saved = String::new();
    let mut contacts = 0;
    for step in 0..16 {
        if step == 9 {
            saved = serde_json::to_string(&whole.checkpoint()).unwrap();
        }
        contacts += whole.step().unwrap().contacts;
    }
    assert!(contacts > 0);
    let checkpoint: Checkpoint = serde_json::from_str(&saved).unwrap();
    let system = System::new(&heap(), &[]).unwrap();
    let mut resumed = checkpoint
        .clone()
        .resume(system, settings.clone(), StepFilter::default())
        .unwrap();
    (9..16).for_each(|_| {
        resumed.step().unwrap();
    });
    let states = [&whole, &resumed].map(|simulation| serde_json::to_string(simulation.state()).unwrap());
    assert_eq!(states[0], states[1]);

    // Another offset, and another radius of the rod, are other materials; another edge is another element.
    let change = |change: &dyn Fn(&mut Vec<Body>)| {
        let mut bodies = heap();
        change(&mut bodies);
        let system = System::new(&bodies, &[]).unwrap();
        let error = checkpoint
            .clone()
            .resume(system, settings.clone(), StepFilter::default());
        match error.err() {
            Some(SimulationError::OtherSystem { what }) => what,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(change(&|bodies| bodies[2].offset = 0.009), "materials");
    assert_eq!(
        change(&|bodies| {
            if let exact_ccd_sim::BodyKind::Rod { material, .. } = &mut bodies[1].kind {
                material.radius = 0.02;
            }
        }),
        "materials"
    );
    assert_eq!(
        change(&|bodies| {
            if let exact_ccd_sim::BodyKind::Rod { edges, .. } = &mut bodies[1].kind {
                edges.pop();
            }
        }),
        "elements"
    );
}

/// A particle on a taut cloth comes to rest above it, between the thickness and the activation distance.
#[test]
fn a_particle_rests_on_a_cloth() {
    let cloth = shapes::cloth([4, 4], [0.4, 0.4]).with_offset(3e-3);
    let rim = |&vertex: &u32| {
        let [x, _, z] = cloth.points[vertex as usize];
        [x, z].into_iter().any(|x| x == 0.0 || x == 0.4)
    };
    let rim: Vec<u32> = (0..25).filter(rim).collect();
    // Between vertices: over a face.
    let bead = moved(shapes::particles([1, 1, 1], [0.0; 3]), [0.17, 0.014, 0.225]).with_offset(0.01);
    let (simulation, all) = run(&[cloth, bead], &[Script::Fixed.on(rim)], settings(), 300);
    let last = all.last().unwrap();
    let distance = last.minimal_distance.unwrap();
    assert!(
        distance > 0.0 && distance < REACH && last.contacts > 0,
        "{last:?}"
    );
    let speed = Vector3::from(simulation.state().velocities[25]).norm();
    assert!(speed < 0.02, "{speed} m/s");
    let [x, y, z] = simulation.state().positions[25];
    assert!(
        (0.1..0.3).contains(&x) && (0.1..0.3).contains(&z) && y > -0.05,
        "{x} {y} {z}"
    );
}

/// Two parallel rods have a barrier, although the barrier of parallel edges vanishes.
#[test]
fn a_rod_rests_on_parallel_rods() {
    let track = |z: f64| moved(shapes::line(2, 0.3), [-0.15, 0.0, z]).with_offset(5e-3);
    let scripts = [Script::Fixed.on(0..6)];
    let rod = moved(shapes::line(3, 0.15), [-0.08, 0.0145, 0.0]).with_offset(5e-3);
    let bodies = [track(-0.006), track(0.006), rod];
    let (simulation, all) = run(&bodies, &scripts, settings(), 60);
    let last = all.last().unwrap();
    assert!(last.converged && last.contacts > 0, "{last:?}");
    // The axis of the rod is between 10 and 12 mm from the axes of the tracks, which are 6 mm aside.
    for [_, y, z] in &simulation.state().positions[6..] {
        let distance = y.hypot(z.abs() - 0.006);
        assert!((0.01..0.012).contains(&distance) && z.abs() < 1e-6, "{y} {z}");
    }
}

/// A particle slides along two parallel rods: friction slows it by μ g / cos θ, where θ is the angle of the
/// normals to the vertical.
#[test]
fn friction_acts_between_particles_and_rods() {
    let track = |z: f64| moved(shapes::line(1, 2.0), [-1.0, 0.0, z]).with_offset(0.02);
    let scripts = [Script::Fixed.on(0..4)];
    let reach = 0.04 + 0.5 * REACH;
    let height = (reach * reach - 0.03_f64.powi(2)).sqrt();
    let mut bead = moved(shapes::particles([1, 1, 1], [0.0; 3]), [-0.5, height, 0.0]).with_offset(0.02);
    bead.velocity = [1.0, 0.0, 0.0];
    let slide = |coefficient: f64| {
        let settings = Settings {
            time_step: 2e-3,
            tolerance: Length::Absolute(1e-5),
            friction: Friction {
                coefficient,
                static_velocity: Length::Absolute(1e-3),
                lags: 3,
                ..Friction::default()
            },
            ..settings()
        };
        let (simulation, _) = run(
            &[track(-0.03), track(0.03), bead.clone()],
            &scripts,
            settings,
            150,
        );
        simulation.state().velocities[4][0]
    };
    assert!((slide(0.0) - 1.0).abs() < 1e-6);
    let expected = 0.1 * 9.81 / (height / reach) * 0.3;
    let lost = 1.0 - slide(0.1);
    assert!(
        (lost / expected - 1.0).abs() < 0.05,
        "{lost}, expected {expected}"
    );
}

/// Without gravity, the collision of particles, a rod and a cloth conserves momentum.
#[test]
fn collisions_of_rods_and_particles_conserve_momentum() {
    let mut beads = moved(shapes::particles([2, 1, 1], [0.1, 0.0, 0.0]), [0.05, 0.05, 0.1]).with_offset(0.01);
    beads.velocity = [0.3, -1.5, 0.0];
    let mut rod = moved(shapes::line(6, 0.2), [0.0, 0.02, 0.105]).with_offset(5e-3);
    rod.velocity = [0.0, -0.3, 0.1];
    // A particle that hits another one.
    let pair =
        [-0.1, -0.07].map(|x| moved(shapes::particles([1, 1, 1], [0.0; 3]), [x, 0.2, 0.0]).with_offset(0.01));
    let [mut fast, slow] = pair;
    fast.velocity = [2.0, 0.1, 0.0];
    let cloth = shapes::cloth([4, 4], [0.2, 0.2]).with_offset(3e-3);
    let settings = Settings {
        gravity: [0.0; 3],
        tolerance: Length::Absolute(1e-9),
        ..settings()
    };
    let bodies = [cloth, rod, beads, fast, slow];
    let start = Simulation::new(System::new(&bodies, &[]).unwrap(), settings.clone()).unwrap();
    let before = momentum(&start);
    let (simulation, all) = run(&bodies, &[], settings, 20);
    let contacts: usize = all.iter().map(|statistics| statistics.contacts).sum();
    assert!(contacts > 10, "{contacts}");
    let change = (momentum(&simulation) - before).norm();
    assert!(
        change < 1e-9 * before.norm().max(1e-2),
        "momentum changed by {change} of {before}"
    );
    // The slow particle has been hit.
    assert!(simulation.state().velocities.last().unwrap()[0] > 0.5);
}

#[test]
fn errors_name_the_first_pair_within_its_thickness() {
    let error = |bodies: &[Body]| Simulation::new(System::new(bodies, &[]).unwrap(), settings()).err();
    let bead = |x: f64| moved(shapes::particles([1, 1, 1], [0.0; 3]), [x, 0.0, 0.0]).with_offset(0.25);
    assert!(error(&[bead(0.0), bead(0.5_f64.next_up())]).is_none());
    // A distance that is exactly the thickness is a contact.
    let touching = error(&[bead(0.0), bead(0.5)]).unwrap();
    let of_body = |place, primitive| BodyPrimitive {
        primitive,
        body: Designation::of_body(place, ""),
    };
    let expected = SimulationError::Close {
        primitives: Box::new([0, 1].map(|place| of_body(place, Primitive::Vertex(0)))),
        thickness: 0.5,
        near: [0.0; 3],
    };
    assert_eq!(touching, expected);
    assert!(
        touching.to_string().contains(
            "vertex 0 of body[0] and vertex 0 of body[1] are within the sum of their offsets, 0.5 m"
        ),
        "{touching}"
    );
    let rod = moved(shapes::line(2, 2.0), [-1.0, 0.3, 0.0]).with_offset(0.125);
    let SimulationError::Close { primitives, .. } = error(&[rod.clone(), bead(0.5)]).unwrap() else {
        panic!("the particle is within the thickness")
    };
    assert_eq!(
        *primitives,
        [
            of_body(0, Primitive::Edge([1, 2])),
            of_body(1, Primitive::Vertex(0))
        ]
    );
    // Edges that are shorter than the thickness are within it: two edges with one between them.
    let short = shapes::line(8, 1.0).with_offset(0.1);
    assert!(matches!(error(&[short]), Some(SimulationError::Close { .. })));
    // Two particles at one place touch, without offsets too.
    let thin = bead(0.0).with_offset(0.0);
    let touching = error(&[thin.clone(), thin, bead(9.0)]);
    assert!(
        matches!(touching, Some(SimulationError::Start { .. })),
        "{touching:?}"
    );
}

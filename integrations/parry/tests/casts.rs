//! Shape casts against motions with known contacts, and against parry's own dispatcher.
#![cfg(all(feature = "f32", feature = "f64"))]

use exact_ccd_parry::{f32::ExactDispatcher as Single, f64::ExactDispatcher as Double};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{
    DefaultQueryDispatcher, NonlinearRigidMotion, QueryDispatcher, ShapeCastOptions, ShapeCastStatus,
    Unsupported,
};
use parry3d_f64::shape::{Ball, Cuboid, Polyline, Segment, TriMesh, Triangle};

fn cube(half: f64) -> TriMesh {
    let (vertices, indices) = Cuboid::new(Vector::splat(half)).to_trimesh();
    TriMesh::new(vertices, indices).expect("a cube is a mesh")
}

#[test]
fn cubes_meet_when_their_faces_do() {
    let options = ShapeCastOptions::default();
    let velocity = Vector::new(-2.0, 0.0, 0.0);
    let hit = Double.cast_shapes(
        &Pose::translation(4.0, 0.25, 0.5),
        velocity,
        &cube(1.0),
        &cube(0.5),
        options,
    );
    let hit = hit.expect("meshes are supported").expect("they meet");
    // The gap of 2.5 closes with speed 2.
    assert_eq!(hit.time_of_impact, 1.25);
    assert_eq!(hit.status, ShapeCastStatus::Converged);
    assert_eq!(hit.normal1, Vector::new(1.0, 0.0, 0.0));
    assert_eq!(hit.normal2, Vector::new(-1.0, 0.0, 0.0));
    assert_eq!((hit.witness1.x, hit.witness2.x), (1.0, -0.5));
    let shift = hit.witness1 - hit.witness2;
    assert_eq!(shift, Vector::new(1.5, 0.25, 0.5));
}

#[test]
fn a_target_distance_is_reached_earlier() {
    let options = ShapeCastOptions {
        target_distance: 0.5,
        ..ShapeCastOptions::default()
    };
    let velocity = Vector::new(-2.0, 0.0, 0.0);
    let pose = Pose::translation(4.0, 0.25, 0.5);
    let hit = Double
        .cast_shapes(&pose, velocity, &cube(1.0), &cube(0.5), options)
        .expect("supported");
    let hit = hit.expect("they come near");
    assert_eq!(hit.time_of_impact, 1.0);
    assert_eq!((hit.witness1.x, hit.witness2.x), (1.0, -0.5));
}

#[test]
fn nothing_is_hit_beside_the_way_or_after_the_last_time() {
    let velocity = Vector::new(-2.0, 0.0, 0.0);
    let beside = Pose::translation(4.0, 1.5000000000000002, 0.0);
    let touching = Pose::translation(4.0, 1.5, 0.0);
    let cast = |pose, until| {
        let options = ShapeCastOptions::with_max_time_of_impact(until);
        Double
            .cast_shapes(pose, velocity, &cube(1.0), &cube(0.5), options)
            .expect("supported")
    };
    assert!(cast(&beside, f64::MAX).is_none());
    assert_eq!(
        cast(&touching, f64::MAX).map(|hit| hit.time_of_impact),
        Some(1.25)
    );
    assert_eq!(cast(&touching, 1.25).map(|hit| hit.time_of_impact), Some(1.25));
    assert!(cast(&touching, 1.2499999999999998).is_none());
}

/// The boxes pass each other after more than the largest f64, but the surfaces meet before.
#[test]
fn the_slowest_motion_meets_too() {
    let floor = Triangle::new(
        Vector::ZERO,
        Vector::new(8.0, 0.0, 0.0),
        Vector::new(0.0, 8.0, 0.0),
    );
    let tall = Triangle::new(
        Vector::new(1.0, 1.0, 0.0),
        Vector::new(1.0, 2.0, 64.0),
        Vector::new(2.0, 1.0, 64.0),
    );
    let pose = Pose::translation(0.0, 0.0, 2.0_f64.powi(-20));
    let down = Vector::new(0.0, 0.0, -(2.0_f64.powi(-1030)));
    let below = Pose::translation(0.0, 0.0, -128.0);
    let cast = |pose, until| {
        let options = ShapeCastOptions::with_max_time_of_impact(until);
        Double.cast_shapes(pose, down, &floor, &tall, options)
    };
    let until = 2.0_f64.powi(1020);
    let hit = cast(&pose, until).expect("supported");
    assert_eq!(hit.map(|hit| hit.time_of_impact), Some(2.0_f64.powi(1010)));
    assert!(cast(&below, until).expect("supported").is_none());
}

#[test]
fn rest_touches_or_does_not() {
    let cast = |x: f64| {
        let pose = Pose::translation(x, 0.0, 0.0);
        let hit = Double.cast_shapes(
            &pose,
            Vector::ZERO,
            &cube(1.0),
            &cube(0.5),
            ShapeCastOptions::default(),
        );
        hit.expect("supported")
            .map(|hit| (hit.time_of_impact, hit.status))
    };
    let at_start = Some((0.0, ShapeCastStatus::PenetratingOrWithinTargetDist));
    assert_eq!(cast(1.5), at_start);
    assert_eq!(cast(1.25), at_start);
    assert_eq!(cast(1.5000000000000002), None);
    // A cube inside of the other: two surfaces that are apart.
    assert_eq!(cast(0.25), None);
}

#[test]
fn intersections_are_exact_and_name_the_parts() {
    let floor = Triangle::new(
        Vector::ZERO,
        Vector::new(8.0, 0.0, 0.0),
        Vector::new(0.0, 8.0, 0.0),
    );
    let line = Polyline::new(
        vec![
            Vector::new(1.0, 1.0, 3.0),
            Vector::new(1.0, 1.0, 2.0),
            Vector::new(1.0, 1.0, -1.0),
        ],
        None,
    );
    let through = Double
        .intersection_test(&Pose::IDENTITY, &floor, &line)
        .expect("supported");
    assert!(through.intersecting);
    assert_eq!((through.subshape1, through.subshape2), (0, 1));
    let turned = Double
        .intersection_test(&Pose::IDENTITY, &line, &floor)
        .expect("supported");
    assert_eq!((turned.subshape1, turned.subshape2), (1, 0));
    let above = Pose::translation(0.0, 0.0, 1.0);
    let least = Pose::translation(0.0, 0.0, 1.0000000000000002);
    assert!(
        Double
            .intersection_test(&above, &floor, &line)
            .expect("supported")
            .intersecting
    );
    assert!(
        !Double
            .intersection_test(&least, &floor, &line)
            .expect("supported")
            .intersecting
    );
}

#[test]
fn a_bar_that_turns_meets_a_post() {
    // From the x axis towards a post at y = 1, one radian per second: contact at a quarter turn.
    let bar = Segment::new(Vector::ZERO, Vector::new(2.0, 0.0, 0.0));
    let post = Segment::new(Vector::new(0.0, 1.0, -1.0), Vector::new(0.0, 1.0, 1.0));
    let turning = NonlinearRigidMotion::new(
        Pose::IDENTITY,
        Vector::ZERO,
        Vector::ZERO,
        Vector::new(0.0, 0.0, 1.0),
    );
    let still = NonlinearRigidMotion::constant_position(Pose::IDENTITY);
    for start in [0.0, 0.5] {
        let hit = Double.cast_shapes_nonlinear(&turning, &bar, &still, &post, start, 3.0, true);
        let hit = hit.expect("supported").expect("they meet");
        let error = std::f64::consts::FRAC_PI_2 - hit.time_of_impact;
        assert!((0.0..1e-5).contains(&error), "{error}");
        assert!(
            (hit.witness1 - Vector::new(1.0, 0.0, 0.0)).length() < 1e-4,
            "{}",
            hit.witness1
        );
        assert!(
            (hit.witness2 - Vector::new(0.0, 1.0, 0.0)).length() < 1e-4,
            "{}",
            hit.witness2
        );
    }
    let none = Double.cast_shapes_nonlinear(&turning, &bar, &still, &post, 0.0, 1.5, true);
    assert!(none.expect("supported").is_none());
}

#[test]
fn everything_else_is_for_the_next_dispatcher() {
    let ball = Ball::new(1.0);
    let away = Pose::translation(4.0, 0.0, 0.0);
    assert_eq!(
        Double.intersection_test(&away, &ball, &cube(1.0)).err(),
        Some(Unsupported)
    );
    assert_eq!(
        Double.distance(&away, &cube(1.0), &cube(1.0)).err(),
        Some(Unsupported)
    );
    let passing = ShapeCastOptions {
        stop_at_penetration: false,
        ..ShapeCastOptions::default()
    };
    let hit = Double.cast_shapes(&away, Vector::X, &cube(1.0), &cube(1.0), passing);
    assert_eq!(hit.err(), Some(Unsupported));
    let nowhere = Pose::translation(f64::NAN, 0.0, 0.0);
    let hit = Double.cast_shapes(
        &nowhere,
        Vector::X,
        &cube(1.0),
        &cube(1.0),
        ShapeCastOptions::default(),
    );
    assert_eq!(hit.err(), Some(Unsupported));
    let chain = Double.chain(DefaultQueryDispatcher);
    assert!(
        chain
            .intersection_test(&Pose::IDENTITY, &ball, &cube(1.0))
            .expect("parry's own")
            .intersecting
    );
}

/// The times agree with parry's up to its tolerance, for convex shapes as meshes and as solids. The time in
/// single precision is at most the time in double precision, up to the rounding of the positions.
#[test]
fn random_casts_agree_with_those_of_solids() {
    let mut random = fastrand::Rng::with_seed(11);
    let mut hits = 0;
    for _ in 0..2000 {
        let mut component = |scale: f64| scale * (2.0 * random.f64() - 1.0);
        let rotation = Vector::new(component(3.0), component(3.0), component(3.0));
        let direction = Vector::new(component(1.0), component(1.0), component(1.0));
        let pose = Pose::new(-4.0 * direction.normalize_or(Vector::X), rotation);
        let velocity = direction + Vector::new(component(0.3), component(0.3), component(0.3));
        let half = Vector::splat(1.0);
        let options = ShapeCastOptions::with_max_time_of_impact(20.0);
        let solid = Cuboid::new(half);
        let theirs =
            DefaultQueryDispatcher.cast_shapes(&pose, velocity, &solid, &Cuboid::new(half / 2.0), options);
        let ours = Double.cast_shapes(&pose, velocity, &cube(1.0), &cube(0.5), options);
        let (theirs, ours) = (theirs.expect("supported"), ours.expect("supported"));
        match (ours, theirs) {
            (Some(ours), Some(theirs)) => {
                hits += 1;
                let difference = (ours.time_of_impact - theirs.time_of_impact) * velocity.length();
                assert!(difference.abs() < 1e-3, "{difference}");
            }
            (None, None) => {}
            // Grazing: parry decides up to its tolerance.
            (Some(_), None) | (None, Some(_)) => {
                let nearest = f64::from(1e-3_f32);
                let near = ShapeCastOptions {
                    target_distance: nearest,
                    ..options
                };
                let hit = Double.cast_shapes(&pose, velocity, &cube(1.0), &cube(0.5), near);
                assert!(hit.expect("supported").is_some());
            }
        }
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn single_precision_rounds_down() {
    use parry3d::math::{Pose, Vector};
    use parry3d::query::{QueryDispatcher as _, ShapeCastOptions};
    use parry3d::shape::Triangle;
    let floor = Triangle::new(
        Vector::ZERO,
        Vector::new(8.0, 0.0, 0.0),
        Vector::new(0.0, 8.0, 0.0),
    );
    let above = Pose::translation(1.0, 1.0, 1.0);
    let velocity = Vector::new(0.0, 0.0, -3.0);
    let hit = Single.cast_shapes(&above, velocity, &floor, &floor, ShapeCastOptions::default());
    let time = hit.expect("supported").expect("it falls").time_of_impact;
    let third = 1.0_f64 / 3.0;
    assert!(
        f64::from(time) <= third && third < f64::from(time.next_up()),
        "{time}"
    );
}

//! Times that are known in closed form.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use exact_ccd::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_curved::{
    Answer, CurvedKind, End, Polynomial, Proximity, RigidMotion, RigidPoint, SearchOptions, Trajectory,
    time_of_impact,
};

use crate::{at_rest, close, timed, within};

/// A bound of the errors of the times in this file, which are f64.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn search<K: CurvedKind>(
    points: &K::Trajectories<&dyn Trajectory>,
    d: f64,
    options: &SearchOptions,
) -> Answer {
    time_of_impact::<K, _>(points, within(d), options).unwrap()
}

/// Checks a bracket of a time of contact, with a proof of contact.
fn assert_bracket(answer: &Answer, time: f64, tolerance: f64) {
    let reached = answer.within.unwrap();
    assert_eq!(
        (answer.end, reached.proximity),
        (End::Tolerance, Proximity::Contact),
        "{answer:?}"
    );
    assert!(
        answer.free_until <= time + ROUNDING && time - ROUNDING <= reached.by,
        "{time} {answer:?}"
    );
    assert!(reached.by - answer.free_until <= tolerance, "{answer:?}");
}

/// Checks an answer with a tolerance of distances.
fn assert_near(answer: &Answer, time: f64, error: f64) {
    let reached = answer.within.unwrap();
    assert_eq!(answer.end, End::Tolerance, "{answer:?}");
    assert!(answer.free_until <= time + ROUNDING, "{time} {answer:?}");
    assert!(
        time - answer.free_until <= error && (reached.by - time).abs() <= error,
        "{time} {answer:?}"
    );
}

/// A bar from the origin to (2, 0, 0) that turns about the z axis.
fn bar(angle: f64) -> [RigidPoint; 2] {
    let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3]).unwrap();
    [[0.0; 3], [2.0, 0.0, 0.0]].map(|point| motion.point(point))
}

#[test]
fn a_bar_sweeps_over_a_post() {
    let post = [-1.0, 1.0].map(|z| at_rest([0.0, 1.0, z]));
    for angle in [2.0, 3.0, 60.0] {
        let bar = bar(angle);
        for tolerance in [1e-3, 1e-6, 1e-12] {
            let answer = search::<EdgeEdge>(&[&bar[0], &bar[1], &post[0], &post[1]], 0.0, &timed(tolerance));
            assert_bracket(&answer, FRAC_PI_2 / angle, tolerance);
        }
    }
    // Half of the angle: the bar stops short.
    let bar = bar(1.5);
    let answer = search::<EdgeEdge>(&[&bar[0], &bar[1], &post[0], &post[1]], 0.0, &timed(0.0));
    assert!(answer.is_free());
}

#[test]
fn a_bar_comes_within_a_distance_of_a_point() {
    let point = at_rest([0.0, 1.0, 0.0]);
    let bar = bar(2.0);
    // The distance is cos φ.
    for tolerance in [1e-3, 1e-6, 1e-12] {
        let answer = search::<VertexEdge>(&[&point, &bar[0], &bar[1]], 0.5, &timed(tolerance));
        assert_bracket(&answer, FRAC_PI_3 / 2.0, tolerance);
    }
    for epsilon in [1e-3, 1e-6, 1e-12] {
        let answer = search::<VertexEdge>(&[&point, &bar[0], &bar[1]], 0.5, &close(epsilon));
        assert_near(&answer, FRAC_PI_3 / 2.0, epsilon);
        // Contact of a vertex and an edge is not stable, so that only nearness is proved.
        let answer = search::<VertexEdge>(&[&point, &bar[0], &bar[1]], 0.0, &close(epsilon));
        assert_near(&answer, FRAC_PI_2 / 2.0, epsilon);
        assert_eq!(answer.within.unwrap().proximity, Proximity::Near);
    }
}

#[test]
fn the_tip_of_a_bar_comes_within_a_distance_of_a_point() {
    let point = at_rest([0.0, 2.0, 0.0]);
    let tip = bar(3.0)[1];
    // The distance is 4 sin((π/2 − φ) / 2), and 2 at φ = π / 6.
    for tolerance in [1e-3, 1e-6, 1e-12] {
        let answer = search::<VertexVertex>(&[&tip, &point], 2.0, &timed(tolerance));
        assert_bracket(&answer, PI / 18.0, tolerance);
    }
}

#[test]
fn a_ball_on_a_parabola_hits_a_floor() {
    let floor = [[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 0.0]].map(at_rest);
    // z = 1 + 2 t − 8 t², from its coefficients, and z = 1 − t³.
    let ball = Polynomial::from_coefficients([[0.0, 0.0, 1.0], [1.0, 0.5, 2.0], [0.0, 0.0, -8.0]]);
    let cubic = Polynomial::new([
        [0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -7.0],
    ]);
    let times: [(&dyn Trajectory, f64); 2] = [(&ball, 0.5), (&cubic, 0.5)];
    for (ball, time) in times {
        for tolerance in [1e-3, 1e-6, 1e-12] {
            let points = [ball, &floor[0], &floor[1], &floor[2]];
            assert_bracket(
                &search::<VertexFace>(&points, 0.0, &timed(tolerance)),
                time,
                tolerance,
            );
        }
    }
    // A ball of radius 1/4: 1 + 2 t − 8 t² = 1/4 at t = (1 + √7) / 8.
    let points: [&dyn Trajectory; 4] = [&ball, &floor[0], &floor[1], &floor[2]];
    let time = (1.0 + 7.0_f64.sqrt()) / 8.0;
    assert_bracket(&search::<VertexFace>(&points, 0.25, &timed(1e-12)), time, 1e-12);
}

#[test]
fn a_screw_meets_a_wall_in_its_eighth_turn() {
    // Ten turns, and one unit along the axis: x = 1, y = 0 at t = 0, 0.1, 0.2, …
    let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 7.0], 20.0 * PI, [0.0, 0.0, 1.0]).unwrap();
    let thread = motion.point([1.0, 0.0, 0.0]);
    let wall = [[0.5, 0.0, 0.66], [1.5, 0.0, 0.66], [1.0, 0.0, 0.78]].map(at_rest);
    let points: [&dyn Trajectory; 4] = [&thread, &wall[0], &wall[1], &wall[2]];
    for tolerance in [1e-4, 1e-8, 1e-12] {
        let answer = search::<VertexFace>(&points, 0.0, &timed(tolerance));
        assert_bracket(&answer, 0.7, tolerance);
        assert!(answer.chords < 400, "{answer:?}");
    }
}

#[test]
fn a_grazing_ball_is_near_or_free() {
    let floor = [[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 0.0]].map(at_rest);
    // z = gap + (2 t − 1)².
    let arch = |gap: f64| {
        Polynomial::new([
            [0.0, 0.0, gap + 1.0],
            [0.0, 0.0, gap - 1.0],
            [0.0, 0.0, gap + 1.0],
        ])
    };
    let search = |gap: f64, options: &SearchOptions| {
        let arch = arch(gap);
        search::<VertexFace>(&[&arch, &floor[0], &floor[1], &floor[2]], 0.0, options)
    };
    // Touching cannot be told from a gap of one rounding error: the free part is certain all the same.
    let answer = search(0.0, &timed(0.0));
    assert!(
        matches!(answer.end, End::Precision | End::ChordLimit),
        "{answer:?}"
    );
    assert!(answer.free_until <= 0.5 && answer.free_until > 0.5 - 1e-6 && answer.within.is_none());
    for epsilon in [1e-2, 1e-6, 1e-10] {
        let answer = search(0.0, &close(epsilon));
        assert!(
            answer.free_until <= 0.5 && answer.free_until >= 0.5 - epsilon.sqrt(),
            "{answer:?}"
        );
        assert_eq!(
            (answer.end, answer.within.unwrap().proximity),
            (End::Tolerance, Proximity::Near)
        );
    }
    for gap in [1e-3, 1e-6, 1e-10] {
        assert!(search(gap, &timed(0.0)).is_free());
        assert!(search(gap, &close(gap / 4.0)).is_free());
        // Within ε at 4 (t − 1/2)² = 3 gap, unless the whole step is found free.
        let answer = search(gap, &close(4.0 * gap));
        let by = answer.within.map_or(1.0, |within| within.by);
        assert!(by >= 0.5 - (0.75 * gap).sqrt() - ROUNDING, "{answer:?}");
    }
}

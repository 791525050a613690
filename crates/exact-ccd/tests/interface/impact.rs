//! The earliest contact: parameters at which the primitives meet, directions of normals, and named
//! degenerate cases.

use exact_ccd::batch::Trajectories;
use exact_ccd::{CONTACT, EdgeEdge, Impact, Kind, Point, Query, Separation, VertexFace};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The accuracy that the documentation promises.
const ACCURACY: f64 = 1.0 / (1_u64 << 32) as f64;

type Points = [[Point; 4]; 2];

fn small_integers() -> impl Strategy<Value = Points> {
    let point = prop::array::uniform3((-4..=4).prop_map(f64::from));
    prop::array::uniform2(prop::array::uniform4(point))
}

fn in_general_position() -> impl Strategy<Value = Points> {
    prop::array::uniform2(prop::array::uniform4(prop::array::uniform3(-1.0..1.0)))
}

/// The points, with the first one moved so that, as a vertex against a face, they meet at t, u and v, up to
/// rounding.
fn meeting(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    (points, (1..=8, 0..=8, 0..=8)).prop_map(|(points, (t, u, v))| {
        let [t, u, v] = [t, u, v].map(|n| f64::from(n) / 8.0);
        let [start, mut end] = points;
        end[0] = core::array::from_fn(|axis| {
            let at = |i: usize| (1.0 - t) * start[i][axis] + t * end[i][axis];
            let target = (1.0 - u) * at(1) + u * ((1.0 - v) * at(2) + v * at(3));
            (target - (1.0 - t) * start[0][axis]) / t
        });
        [start, end]
    })
}

fn any() -> impl Strategy<Value = Points> {
    prop_oneof![
        small_integers(),
        meeting(small_integers()),
        in_general_position(),
        meeting(in_general_position()),
    ]
}

/// The same in a separate unit on each axis, down to subnormal coordinates and up to the largest
/// ones.
fn extreme() -> impl Strategy<Value = Points> {
    let exponent = prop_oneof![-1070..=1000, -210..=210, Just(0)];
    (any(), prop::array::uniform3(exponent)).prop_map(|(points, exponents)| {
        // In two factors, because 2⁻¹⁰⁷⁰ may be out of the range of `powi`.
        let scaled = |x: f64, exponent: i32| {
            let half = exponent / 2;
            x * 2f64.powi(half) * 2f64.powi(exponent - half)
        };
        points.map(|now| now.map(|point| core::array::from_fn(|axis| scaled(point[axis], exponents[axis]))))
    })
}

/// The points in one plane across an axis at each time.
fn flattened(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    let heights = prop::array::uniform2(-1.0..1.0);
    (points, 0..3_usize, heights).prop_map(|(mut points, axis, heights)| {
        for (now, height) in points.iter_mut().zip(heights) {
            now.iter_mut().for_each(|point| point[axis] = height);
        }
        points
    })
}

/// The points, with an end of some of them moved so that they are, up to rounding, at these places at t.
fn passing(mut points: Points, t: f64, places: &[(usize, Point)]) -> Points {
    for &(i, place) in places {
        points[1][i] = core::array::from_fn(|axis| (place[axis] - (1.0 - t) * points[0][i][axis]) / t);
    }
    points
}

/// From a towards b by s, and by a small vector beside the line.
fn beside(a: Point, b: Point, s: f64, off: Point) -> Point {
    core::array::from_fn(|axis| a[axis] + s * (b[axis] - a[axis]) + off[axis])
}

/// t, u and v; and a vector between 2⁻⁴⁰ and 1 in size.
fn meetings() -> impl Strategy<Value = ([f64; 3], Point)> {
    let eighths = prop::array::uniform3((1..=7).prop_map(|n| f64::from(n) / 8.0));
    let vector = (prop::array::uniform3(-1.0..1.0), 0..=40_i32);
    (eighths, vector).prop_map(|(times, (vector, size))| (times, vector.map(|x: f64| x * 2f64.powi(-size))))
}

/// A vertex meets a face that is nearly an edge at that time, and at no other one.
fn slivers() -> impl Strategy<Value = Points> {
    (in_general_position(), meetings()).prop_map(|(points, ([t, u, v], off))| {
        let [a, b] = [1, 2].map(|i: usize| beside(points[0][i], points[1][i], t, [0.0; 3]));
        let c = beside(a, b, v, off);
        let meeting = beside(a, beside(b, c, v, [0.0; 3]), u, [0.0; 3]);
        passing(points, t, &[(0, meeting), (3, c)])
    })
}

/// Edges meet that are nearly parallel at that time, and at no other one.
fn nearly_parallel() -> impl Strategy<Value = Points> {
    (in_general_position(), meetings()).prop_map(|(points, ([t, u, v], off))| {
        let [a, b] = [0, 1].map(|i: usize| beside(points[0][i], points[1][i], t, [0.0; 3]));
        let meeting = beside(a, b, u, [0.0; 3]);
        let c = beside(meeting, a, v, off);
        passing(points, t, &[(2, c), (3, beside(c, meeting, 1.0 / v, [0.0; 3]))])
    })
}

/// A vertex meets an edge that is short at that time, and at no other one.
fn short_edges() -> impl Strategy<Value = Points> {
    (in_general_position(), meetings()).prop_map(|(points, ([t, u, _], off))| {
        let a = beside(points[0][1], points[1][1], t, [0.0; 3]);
        let b = beside(a, a, 0.0, off);
        passing(points, t, &[(0, beside(a, b, u, [0.0; 3])), (2, b)])
    })
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Compares the numbers of two answers, each with this accuracy.
fn close(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 2.0 * ACCURACY)
}

/// The weights of the four points in F(t, u, v).
type Weights = fn([f64; 2]) -> [f64; 4];
const VERTEX_FACE: Weights = |[u, v]| [1.0, u + v - 1.0, -u, -v];
const EDGE_EDGE: Weights = |[u, v]| [1.0 - u, u, v - 1.0, -v];

fn check<K: Kind<Points = [Point; 4]>>(query: &Query<K>, weights: Weights) -> Result<(), TestCaseError> {
    let (impact, reference) = (query.impact(CONTACT), query.exactly().impact(CONTACT));
    let first = query.intervals(CONTACT).first_time();
    prop_assert_eq!(impact.map(|impact| impact.time), first);
    prop_assert_eq!(reference.map(|impact| impact.time), first);
    let (Some(impact), Some(reference)) = (impact, reference) else {
        return Ok(());
    };

    let (found, expected) = (impact.parameters, reference.parameters);
    prop_assert!(close(&found, &expected), "{found:?}, exactly {expected:?}");
    prop_assert!(found.iter().all(|x| (0.0..=1.0).contains(x)));

    let (found, expected) = (impact.normal, reference.normal);
    prop_assert_eq!(found.is_some(), expected.is_some());
    if let (Some(found), Some(expected)) = (found, expected) {
        prop_assert!((dot(found, found) - 1.0).abs() <= 4.0 * f64::EPSILON);
        prop_assert!(close(&found, &expected), "{found:?}, exactly {expected:?}");
    }

    let [start, end] = query.points();
    let (t, weights) = (impact.time.lower(), weights(impact.parameters));
    for axis in 0..3 {
        let points = query.points().as_flattened();
        let size = points
            .iter()
            .fold(0.0, |size: f64, point| size.max(point[axis].abs()));
        let at = |i: usize| (1.0 - t) * start[i][axis] + t * end[i][axis];
        let distance: f64 = (0..4).map(|i| weights[i] * at(i)).sum();
        prop_assert!(
            distance.abs() <= 8.0 * ACCURACY * size + 64.0 * f64::from_bits(1),
            "{distance} apart on axis {axis}"
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 4000,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    })]

    #[test]
    fn vertex_and_face_meet_at_the_parameters(points in any()) {
        check(&Query::<VertexFace>::new(points[0], points[1]).unwrap(), VERTEX_FACE)?;
    }

    #[test]
    fn edges_meet_at_the_parameters(points in any()) {
        check(&Query::<EdgeEdge>::new(points[0], points[1]).unwrap(), EDGE_EDGE)?;
    }

    #[test]
    fn vertex_and_face_of_extreme_size_meet_at_the_parameters(points in extreme()) {
        check(&Query::<VertexFace>::new(points[0], points[1]).unwrap(), VERTEX_FACE)?;
    }

    #[test]
    fn edges_of_extreme_size_meet_at_the_parameters(points in extreme()) {
        check(&Query::<EdgeEdge>::new(points[0], points[1]).unwrap(), EDGE_EDGE)?;
    }

    #[test]
    fn vertex_and_face_in_a_plane_meet_at_the_parameters(points in flattened(any())) {
        check(&Query::<VertexFace>::new(points[0], points[1]).unwrap(), VERTEX_FACE)?;
    }

    #[test]
    fn edges_in_a_plane_meet_at_the_parameters(points in flattened(any())) {
        check(&Query::<EdgeEdge>::new(points[0], points[1]).unwrap(), EDGE_EDGE)?;
    }

    #[test]
    fn a_vertex_and_a_sliver_meet_at_the_parameters(points in slivers()) {
        check(&Query::<VertexFace>::new(points[0], points[1]).unwrap(), VERTEX_FACE)?;
    }

    #[test]
    fn nearly_parallel_edges_meet_at_the_parameters(points in nearly_parallel()) {
        check(&Query::<EdgeEdge>::new(points[0], points[1]).unwrap(), EDGE_EDGE)?;
    }

    #[test]
    fn a_vertex_and_a_short_edge_in_a_plane_meet_at_the_parameters(points in flattened(short_edges())) {
        check(&Query::<VertexFace>::new(points[0], points[1]).unwrap(), VERTEX_FACE)?;
    }

    #[test]
    fn the_normal_of_a_face_at_rest_faces_the_incoming_vertex(points in any()) {
        let [[from, a, b, c], [to, ..]] = points;
        let query = Query::<VertexFace>::new([from, a, b, c], [to, a, b, c]).unwrap();
        let motion: Point = core::array::from_fn(|axis| to[axis] - from[axis]);
        if let Some(Impact { normal: Some(normal), .. }) = query.impact(CONTACT) {
            prop_assert!(dot(normal, motion) <= 4.0 * ACCURACY * dot(motion, motion).sqrt());
        }
    }

    #[test]
    fn swapped_edges_swap_the_answer([start, end] in meeting(in_general_position())) {
        let swap = |[a0, a1, b0, b1]: [Point; 4]| [b0, b1, a0, a1];
        let impact = Query::<EdgeEdge>::new(start, end).unwrap().impact(CONTACT);
        let swapped = Query::<EdgeEdge>::new(swap(start), swap(end)).unwrap().impact(CONTACT);
        prop_assert_eq!(impact.map(|impact| impact.time), swapped.map(|impact| impact.time));
        if let (Some(impact), Some(swapped)) = (impact, swapped) {
            let [u, v] = swapped.parameters;
            prop_assert!(close(&impact.parameters, &[v, u]));
            let (found, expected) = (impact.normal.unwrap(), swapped.normal.unwrap());
            prop_assert!(close(&found, &expected.map(|x| -x)), "{found:?} and {expected:?}");
        }
    }
}

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

#[track_caller]
fn on_face(from: Point, to: Point) -> Impact {
    let [a, b, c] = FACE;
    let query = Query::<VertexFace>::new([from, a, b, c], [to, a, b, c]).unwrap();
    query.impact(CONTACT).unwrap()
}

#[test]
fn a_vertex_falls_on_a_face() {
    let impact = on_face([1.0, 2.0, 1.0], [1.0, 2.0, -1.0]);
    assert_eq!(impact.time.lower(), 0.5);
    assert_eq!(impact.parameters, [0.25, 0.5]);
    assert_eq!(impact.normal, Some([0.0, 0.0, 1.0]));
    assert!(!impact.touching_at_start());
}

#[test]
fn a_vertex_rises_to_a_face() {
    let impact = on_face([1.0, 2.0, -3.0], [1.0, 2.0, 1.0]);
    assert_eq!(impact.time.lower(), 0.75);
    assert_eq!(impact.normal, Some([0.0, 0.0, -1.0]));
}

#[test]
fn a_face_turns_up_to_a_vertex() {
    // The corner at (4, 0) rises by 4. The face reaches the vertex at (1, 1) at the end of the motion.
    let start = [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let end = [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [4.0, 0.0, 4.0], [0.0, 4.0, 0.0]];
    let query = Query::<VertexFace>::new(start, end).unwrap();
    let impact = query.impact(CONTACT).unwrap();
    assert_eq!(impact.time.lower(), 1.0);
    assert!(close(
        &impact.normal.unwrap(),
        &[-0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()]
    ));
}

#[test]
fn at_the_start_the_normal_opposes_the_motion() {
    let leaving = on_face([1.0, 2.0, 0.0], [1.0, 2.0, 1.0]);
    assert!(leaving.touching_at_start());
    assert_eq!(leaving.normal, Some([0.0, 0.0, -1.0]));
    let entering = on_face([1.0, 2.0, 0.0], [1.0, 2.0, -1.0]);
    assert!(entering.touching_at_start());
    assert_eq!(entering.normal, Some([0.0, 0.0, 1.0]));
}

#[test]
fn a_vertex_in_the_plane_of_a_face_reaches_an_edge() {
    let impact = on_face([1.0, -1.0, 0.0], [3.0, 3.0, 0.0]);
    assert_eq!(impact.time.lower(), 0.25);
    assert_eq!(impact.parameters, [0.375, 0.0]);
    assert_eq!(impact.normal, Some([0.0, -1.0, 0.0]));
}

#[test]
fn a_vertex_in_the_plane_of_a_face_starts_inside() {
    let impact = on_face([1.0, 1.0, 0.0], [2.0, 1.0, 0.0]);
    assert!(impact.touching_at_start());
    assert_eq!(impact.parameters, [0.25, 0.25]);
    assert_eq!(impact.normal, Some([0.0, 0.0, 1.0]));
}

#[test]
fn a_flat_face_is_its_edges() {
    let [a, b] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let query = Query::<VertexFace>::new([[1.0, 1.0, 2.0], a, b, b], [[1.0, -1.0, -2.0], a, b, b]).unwrap();
    let impact = query.impact(CONTACT).unwrap();
    assert_eq!(impact.time.lower(), 0.5);
    assert_eq!(impact.parameters, [0.25, 0.0]);
    assert!(close(
        &impact.normal.unwrap(),
        &[0.0, 0.2_f64.sqrt(), 0.8_f64.sqrt()]
    ));
}

#[test]
fn parallel_edges_meet() {
    let [b0, b1] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let [start, end] = [2.0, -2.0].map(|z| [[1.0, 0.0, z], [2.0, 0.0, z], b0, b1]);
    let impact = Query::<EdgeEdge>::new(start, end)
        .unwrap()
        .impact(CONTACT)
        .unwrap();
    assert_eq!(impact.time.lower(), 0.5);
    assert_eq!(impact.parameters, [0.0, 0.25]);
    assert_eq!(impact.normal, Some([0.0, 0.0, 1.0]));
}

#[test]
fn an_end_of_the_second_edge_meets_the_first() {
    // In the plane y = 0 at all times: b₀ falls on a.
    let [start, end] = [2.0, -2.0].map(|z| {
        [
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [1.0, 0.0, z],
            [1.0, 0.0, z + 3.0],
        ]
    });
    let impact = Query::<EdgeEdge>::new(start, end)
        .unwrap()
        .impact(CONTACT)
        .unwrap();
    assert_eq!(impact.time.lower(), 0.5);
    assert_eq!(impact.parameters, [0.25, 0.0]);
    assert_eq!(impact.normal, Some([0.0, 0.0, -1.0]));
}

#[test]
fn points_meet() {
    let still = [0.0; 3];
    let [start, end] = [[2.0, 1.0, 2.0], [-2.0, -1.0, -2.0]].map(|p: Point| [p, still, still, still]);
    let impact = Query::<VertexFace>::new(start, end)
        .unwrap()
        .impact(CONTACT)
        .unwrap();
    assert_eq!(impact.time.lower(), 0.5);
    assert_eq!(impact.parameters, [0.0, 0.0]);
    assert!(close(&impact.normal.unwrap(), &[2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0]));
}

#[test]
fn edges_at_rest_have_no_normal() {
    let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 3.0]];
    let impact = Query::<EdgeEdge>::new(points, points)
        .unwrap()
        .impact(CONTACT)
        .unwrap();
    assert!(impact.touching_at_start());
    assert_eq!(impact.parameters, [0.25, 0.0]);
    assert_eq!(impact.normal, None);
}

#[test]
fn lengths_of_very_different_size() {
    let (tiny, huge) = (1e-300, 1e300);
    let [a, b, c] = [[0.0, 0.0, 0.0], [tiny, 0.0, 0.0], [0.0, huge, 0.0]];
    let [start, end] = [1.0, -1.0].map(|z| [[tiny / 4.0, huge / 2.0, z], a, b, c]);
    let impact = Query::<VertexFace>::new(start, end)
        .unwrap()
        .impact(CONTACT)
        .unwrap();
    assert_eq!(impact.time.lower(), 0.5);
    assert!(close(&impact.parameters, &[0.25, 0.5]));
    assert_eq!(impact.normal, Some([0.0, 0.0, 1.0]));
}

#[test]
fn no_contact_no_impact() {
    let [a, b, c] = FACE;
    let query = Query::<VertexFace>::new([[1.0, 1.0, 1.0], a, b, c], [[1.0, 1.0, 0.5], a, b, c]).unwrap();
    assert_eq!(query.impact(CONTACT), None);
    assert_eq!(query.exactly().impact(CONTACT), None);
}

/// The end b0 of one edge meets the other edge, at v = 0: by itself and in a batch, for each reflection and
/// order of the points. A zero has no sign.
#[test]
fn zeros_of_parameters_are_positive() {
    let start = [
        [221.0, 60.0, -1.0],
        [220.00001, 60.0, 0.0],
        [220.1, 60.0, 0.1],
        [220.00001, 59.3, 0.0],
    ];
    let raised = |[x, y, z]: Point| [x, y, z + 0.25];
    let end = [raised(start[0]), raised(start[1]), start[2], start[3]];
    let mut zeros = 0;
    let mut check = |impact: Impact| {
        let parameters = impact.parameters;
        zeros += parameters.into_iter().filter(|u| *u == 0.0).count();
        assert!(parameters.into_iter().all(f64::is_sign_positive), "{impact:?}");
    };
    for flip in 0..8 {
        let reflect = |[x, y, z]: Point| {
            let sign = |bit: u8| if flip >> bit & 1 == 0 { 1.0 } else { -1.0 };
            [sign(0) * x, sign(1) * y, sign(2) * z]
        };
        for order in [
            [0, 1, 2, 3],
            [1, 0, 2, 3],
            [0, 1, 3, 2],
            [2, 3, 0, 1],
            [3, 2, 1, 0],
        ] {
            let [start, end] = [start, end].map(|points| order.map(|i: usize| reflect(points[i])));
            check(
                Query::<EdgeEdge>::new(start, end)
                    .unwrap()
                    .impact(CONTACT)
                    .unwrap(),
            );
            let batch = Trajectories::new(&start, &end).unwrap();
            let found = batch.collisions::<EdgeEdge>(&[[0, 1, 2, 3]; 8], CONTACT, |_, collision| {
                check(collision.impact());
            });
            found.unwrap();
        }
    }
    assert!(zeros > 0);
}

/// Cross products of the sides of a sliver cancel, and the differences of a fast vertex too. The accuracy
/// of the documentation holds nevertheless.
#[test]
fn a_sliver_and_a_fast_vertex_have_accurate_parameters() {
    let height = 2f64.powi(-25);
    let sliver = [[0.0; 3], [1.0, 1.0, 0.0], [0.5, 0.5 + height, 0.0]];
    let far = 2f64.powi(30);
    for (face, at, along, parameters) in [
        (sliver, [0.5, 0.5 + 0.5 * height], 0.0, [0.25, 0.5]),
        (FACE, [1.0, 1.0], far, [0.25, 0.25]),
    ] {
        let [a, b, c] = face;
        let vertex = |s: f64| [at[0] + s * along, at[1], -s];
        let query = Query::<VertexFace>::new([vertex(-1.0), a, b, c], [vertex(1.0), a, b, c]).unwrap();
        let impact = query.impact(CONTACT).unwrap();
        assert_eq!((impact.time.lower(), impact.time.is_exact()), (0.5, true));
        assert!(close(&impact.parameters, &parameters), "{impact:?}");
        assert_eq!(impact.normal.map(|[_, _, z]| z), Some(1.0));
    }
}

/// The vertex is at the distance 1/4 at t = 1/2 exactly.
#[test]
fn within_a_distance_at_a_time_that_is_a_number() {
    let [a, b, c] = FACE;
    let query = Query::<VertexFace>::new([[1.0, 1.0, 1.0], a, b, c], [[1.0, 1.0, -0.5], a, b, c]).unwrap();
    let quarter = Separation::new(0.25).unwrap();
    for impact in [query.impact(quarter), query.exactly().impact(quarter)].map(Option::unwrap) {
        assert_eq!((impact.time.lower(), impact.time.is_exact()), (0.5, true));
        assert!(close(&impact.parameters, &[0.25, 0.25]), "{impact:?}");
        assert_eq!(impact.normal, Some([0.0, 0.0, 1.0]));
    }
}

/// Parameters and normals that change fast: an f64 next to the time does not determine them. The points are
/// functions of the time since the contact.
#[test]
fn impacts_that_change_fast_are_accurate() {
    type Motion<'a> = &'a dyn Fn(f64) -> [Point; 4];
    let power = |exponent: i32| 2f64.powi(exponent);
    for index in 1..60_u32 {
        let (t, v) = (0.5 + f64::from(index) / 123.0, 1.0 + f64::from(index) / 97.0);
        let sliding = |s: f64| {
            let (z, y, turn) = (-v * s, power(18) * s - power(-11), power(-10) - 2.0 * s);
            [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, y, 0.0], [1.0, y + turn, 0.0]]
        };
        let turning = |s: f64| {
            let (z, y) = (2.0 * v * s, 0.5 * power(-26));
            [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, -y, 0.0], [1.0, y, s]]
        };
        let turning_in_plane = |s: f64| {
            let fast = power(26) * s;
            let vertex = [0.5, (0.1 * v + 0.5) * fast, 0.0];
            [vertex, [0.0; 3], [1.0, fast, 0.0], [0.0, 1.0, 0.0]]
        };
        let sliding_in_plane = |s: f64| {
            let vertex = [0.5 + 5.5e6 * s, v * s, 0.0];
            [vertex, [0.0; 3], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0]]
        };
        for (exponent, rotation) in [(0, 0), (40, 1), (-40, 2)] {
            let ends = |at: Motion<'_>| {
                [at(-t), at(1.0 - t)].map(|now| {
                    now.map(|mut point| {
                        point.rotate_right(rotation);
                        point.map(|x| x * power(exponent))
                    })
                })
            };
            for motion in [&sliding as Motion<'_>, &turning] {
                let [start, end] = ends(motion);
                check(&Query::<EdgeEdge>::new(start, end).unwrap(), EDGE_EDGE).unwrap();
            }
            for motion in [&turning_in_plane as Motion<'_>, &sliding_in_plane] {
                let [start, end] = ends(motion);
                check(&Query::<VertexFace>::new(start, end).unwrap(), VERTEX_FACE).unwrap();
            }
        }
    }
}

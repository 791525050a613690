//! The methods in Bernstein form: their guarantees and their known errors.

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_methods::{BernsteinSignClassification, TightCcd};
use proptest::array::{uniform3, uniform4};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

type Points = [[Point; 4]; 2];

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(0),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Coordinates from few numbers, so that many of the signs are zero, or 1e-15 and more away from
/// these, scaled.
fn near_degenerate(exponents: std::ops::Range<i32>) -> impl Strategy<Value = Points> {
    let coordinate = (
        -1..=1i8,
        prop_oneof![6 => Just(0.0), 1 => -1e-15..1e-15, 1 => -1e-8..1e-8, 1 => -1.0..1.0],
    )
        .prop_map(|(x, error)| f64::from(x) + error);
    let frame = uniform4(uniform3(coordinate));
    (frame.clone(), frame, exponents).prop_map(|(start, end, exponent)| {
        [start, end].map(|points| points.map(|point| point.map(|x| x * 2f64.powi(exponent))))
    })
}

/// Two primitives at coordinates without accidental coincidences. The one with the first `moving` points
/// translates.
fn translation(moving: usize) -> impl Strategy<Value = Points> {
    let coordinate = -1_000_000..=1_000_000i32;
    let velocity = uniform3(-2_000_000..=2_000_000i32);
    (uniform4(uniform3(coordinate)), velocity).prop_map(move |(start, velocity)| {
        let mut end = start;
        for point in &mut end[..moving] {
            *point = [0, 1, 2].map(|axis| point[axis] + velocity[axis]);
        }
        [start, end].map(|points| points.map(|point| point.map(f64::from)))
    })
}

fn vertex_face([start, end]: Points) -> Query<VertexFace> {
    Query::<VertexFace>::new(start, end).unwrap()
}

fn edge_edge([start, end]: Points) -> Query<EdgeEdge> {
    Query::<EdgeEdge>::new(start, end).unwrap()
}

/// The decisions of a method on a vertex and a face, and on two edges.
fn both(method: &impl Ccd, points: Points) -> [bool; 2] {
    [
        method.collides(&vertex_face(points)),
        method.collides(&edge_edge(points)),
    ]
}

fn truth(points: Points) -> [bool; 2] {
    [
        vertex_face(points).collides(CONTACT),
        edge_edge(points).collides(CONTACT),
    ]
}

fn assert_tight_ccd_misses_nothing(points: Points) -> Result<(), TestCaseError> {
    for (answer, collides) in both(&TightCcd, points).into_iter().zip(truth(points)) {
        prop_assert!(answer || !collides);
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn tight_ccd_has_no_false_negatives(points in near_degenerate(-60..60)) {
        assert_tight_ccd_misses_nothing(points)?;
    }

    #[test]
    fn tight_ccd_has_no_false_negatives_where_products_underflow_or_overflow(points in near_degenerate(-1020..1020)) {
        assert_tight_ccd_misses_nothing(points)?;
    }

    /// The cubic is linear.
    #[test]
    fn sign_classification_is_right_about_a_translation(face in translation(1), edge in translation(2)) {
        let method = BernsteinSignClassification::default();
        let vertex_face = vertex_face(face);
        prop_assert_eq!(method.collides(&vertex_face), vertex_face.collides(CONTACT));
        let edge_edge = edge_edge(edge);
        prop_assert_eq!(method.collides(&edge_edge), edge_edge.collides(CONTACT));
    }
}

proptest! {
    #![proptest_config(config(100))]

    /// The methods terminate without a panic, and TCCD has no false negatives.
    #[test]
    fn any_finite_coordinates_are_fine(
        start in uniform4(uniform3(any::<f64>())),
        end in uniform4(uniform3(any::<f64>())),
    ) {
        prop_assume!([start, end].as_flattened().as_flattened().iter().all(|x| x.is_finite()));
        assert_tight_ccd_misses_nothing([start, end])?;
        both(&BernsteinSignClassification::default(), [start, end]);
    }
}

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A vertex against [`FACE`].
fn against_face(start: Point, end: Point) -> Query<VertexFace> {
    let [a, b, c] = FACE;
    vertex_face([[start, a, b, c], [end, a, b, c]])
}

#[test]
fn a_vertex_falls_through_a_face() {
    let query = against_face([0.25, 0.25, 1.0], [0.25, 0.25, -1.0]);
    assert!(TightCcd.collides(&query));
    assert!(BernsteinSignClassification::default().collides(&query));
}

#[test]
fn a_vertex_stays_above_a_face() {
    let query = against_face([0.25, 0.25, 2.0], [0.25, 0.25, 1.0]);
    assert!(!TightCcd.collides(&query));
    assert!(!BernsteinSignClassification::default().collides(&query));
}

#[test]
fn tight_ccd_invents_a_contact_where_the_cubic_is_linear() {
    let query = against_face([5.0, 5.0, 1.0], [5.0, 5.0, -1.0]);
    assert!(TightCcd.collides(&query));
    assert!(!BernsteinSignClassification::default().collides(&query));
    // Only the first coefficient has its sign.
    let query = against_face([5.0, 5.0, 1.0], [5.0, 5.0, -4.0]);
    assert!(!TightCcd.collides(&query));
}

/// The product of a linear height and a quadratic area, with coefficients 2, 1, −1, −2.
/// After a cut at the inflection point, it evaluates polynomials of degree 288 in the coordinates.
#[test]
fn tight_ccd_depends_on_the_unit() {
    let points = [
        [
            [-3.0, 1.0, 1.0],
            [4.0, -4.0, -4.0],
            [0.0, 3.0, -1.0],
            [2.0, -4.0, -2.0],
        ],
        [
            [3.0, -1.0, -3.0],
            [-2.0, 3.0, 0.0],
            [4.0, 0.0, -4.0],
            [-3.0, 4.0, 0.0],
        ],
    ];
    for (unit, is_reported) in [(1.0 / 64.0, true), (1.0 / 4.0, false), (64.0, true)] {
        let query = vertex_face(points.map(|points| points.map(|point| point.map(|x| x * unit))));
        assert!(!query.collides(CONTACT));
        assert_eq!(TightCcd.collides(&query), is_reported);
    }
}

#[test]
fn sign_classification_gives_up_on_an_inflection_point() {
    let query = vertex_face([
        [[9.0, 9.0, 1.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
        [[9.0, 9.0, -1.0], [0.0; 3], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    ]);
    assert!(!query.collides(CONTACT));
    assert!(BernsteinSignClassification::default().collides(&query));
}

#[test]
fn sign_classification_misses_contacts_of_coplanar_motion() {
    let method = BernsteinSignClassification::default();
    let slides_in = against_face([2.0, 0.25, 0.0], [0.25, 0.25, 0.0]);
    assert!(slides_in.collides(CONTACT));
    assert!(!method.collides(&slides_in));
    assert!(TightCcd.collides(&slides_in));

    let [a0, a1] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let crosses = edge_edge([
        [a0, a1, [2.0, -1.0, 0.0], [2.0, 1.0, 0.0]],
        [a0, a1, [0.5, -1.0, 0.0], [0.5, 1.0, 0.0]],
    ]);
    assert!(crosses.collides(CONTACT));
    assert!(!method.collides(&crosses));
    assert!(TightCcd.collides(&crosses));
}

#[test]
fn both_invent_a_contact_where_a_vertex_reaches_the_line_of_an_edge() {
    let [a0, a1] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let query = edge_edge([
        [a0, a1, [9.0, 0.0, 1.0], [9.0, 1.0, 1.0]],
        [a0, a1, [9.0, 0.0, -4.0], [9.0, 1.0, -4.0]],
    ]);
    assert!(!query.collides(CONTACT));
    assert!(TightCcd.collides(&query));
    assert!(BernsteinSignClassification::default().collides(&query));
}

#[test]
fn sign_classification_culls_contacts_at_large_coordinates() {
    let face = [
        [98290.8, 47166.5, 11239.5],
        [22618.100000000002, 158961.1, 138427.7],
        [68297.1, 187725.1, 83741.90000000001],
    ];
    let [x, y] = [63068.666666666664, 131284.23333333334];
    let [low, high] = [77803.03333333333, 77803.03333333335];
    let [a, b, c] = face;
    let query = vertex_face([[[x, y, low], a, b, c], [[x, y, high], a, b, c]]);
    assert!(query.collides(CONTACT));
    assert!(!BernsteinSignClassification::default().collides(&query));
    let careful = BernsteinSignClassification {
        culling_bound: f64::INFINITY,
    };
    assert!(careful.collides(&query));
    assert!(TightCcd.collides(&query));
}

//! Meshes whose vertices move on Bézier curves: contacts against all pairs in integers, and against straight
//! motion.

use exact_ccd::motion::{Bezier, CurvedQuery};
use exact_ccd::{CONTACT, Impact, Kind, Options, Separation, with_kind};
use exact_ccd_mesh::{
    CanCollide, Contact, CurveDetector, CurvesError, Detector, Pair, PairKind, Point, PositionsError,
    TriangleMesh,
};
use fastrand::Rng;

/// Two tetrahedra, a rod and two points.
fn mesh() -> TriangleMesh {
    let tetrahedron = |i: u32| {
        [
            [i, i + 1, i + 2],
            [i, i + 1, i + 3],
            [i, i + 2, i + 3],
            [i + 1, i + 2, i + 3],
        ]
    };
    let faces = [tetrahedron(0), tetrahedron(4)].concat();
    TriangleMesh::with_edges(13, faces, &[[8, 9], [9, 10]]).unwrap()
}

fn positions(random: &mut Rng, factor: f64) -> Vec<Point> {
    let point = || [(); 3].map(|()| factor * f64::from(random.i32(-3..=3)));
    std::iter::repeat_with(point).take(13).collect()
}

fn slices(control: &[Vec<Point>]) -> Vec<&[Point]> {
    control.iter().map(Vec::as_slice).collect()
}

fn exactly<K: Kind>(mesh: &TriangleMesh, control: &[Vec<Point>], pair: Pair, d: f64) -> Option<Impact> {
    let vertices = K::vertices(mesh, pair.ids()).unwrap();
    let sets = control.iter().map(|set| {
        let mut points = K::Points::default();
        for (point, &vertex) in points.as_mut().iter_mut().zip(vertices.as_ref()) {
            *point = set[vertex as usize];
        }
        points
    });
    let query: CurvedQuery<K> = Bezier::new(&sets.collect::<Vec<_>>()).unwrap().into();
    let d = if K::are_connected(mesh, &vertices) { 0.0 } else { d };
    query.exactly().impact(Separation::new(d).unwrap())
}

#[test]
fn contacts_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(1);
    let mesh = mesh();
    // All pairs are within such a distance at rest, except connected primitives.
    let rest = positions(&mut random, 1.0);
    let far = Options::within(Separation::new(1e3).unwrap());
    let at_rest = Detector::new(mesh.clone()).collisions(&rest, &rest, far).unwrap();
    let pairs: Vec<Pair> = at_rest.iter().map(|contact| contact.pair).collect();
    for case in 0..6 {
        let degree = [2, 3, 4][case % 3];
        let control: Vec<_> = (0..=degree).map(|_| positions(&mut random, 1.0)).collect();
        let d = [0.0, 0.25][case / 3];
        let contact = |&pair: &Pair| {
            let impact = with_kind!(pair.kind(), K => exactly::<K>(&mesh, &control, pair, d))?;
            Some((impact.time, pair, impact))
        };
        let mut expected: Vec<_> = pairs.iter().filter_map(contact).collect();
        expected.sort_by_key(|(time, pair, _)| (*time, *pair));
        let detector = CurveDetector::new(mesh.clone());
        let options = Options::within(Separation::new(d).unwrap());
        let found = detector.collisions(&slices(&control), options).unwrap();
        let found = found.iter().filter(|contact| pairs.contains(&contact.pair));
        let found: Vec<_> = found
            .map(|contact| (contact.impact.time, contact.pair, contact.impact))
            .collect();
        assert_eq!(found, expected, "{case}");
        assert!(!expected.is_empty(), "{case}");
    }
}

/// With the mean of both ends between them, the same motion has degree 2.
#[test]
fn answers_to_straight_motion_are_those_of_a_detector() {
    let mut random = Rng::with_seed(2);
    let mesh = mesh();
    for case in 0..24 {
        let [start, end] = [(); 2].map(|()| positions(&mut random, 2.0));
        let both = start.iter().zip(&end);
        let middle = both.map(|(a, b)| [0, 1, 2].map(|axis: usize| 0.5 * (a[axis] + b[axis])));
        let control = if case % 2 == 0 {
            vec![start.clone(), end.clone()]
        } else {
            vec![start.clone(), middle.collect(), end.clone()]
        };
        let control = slices(&control);
        let d = Separation::new([0.0, 0.5][case % 4 / 2]).unwrap();
        let options = Options::within(d).until([1.0, 0.25][case / 12]);
        let mut straight = Detector::new(mesh.clone());
        let curved = CurveDetector::new(mesh.clone());
        // Parameters and normals are rounded in another way.
        let key = |contact: &Contact| (contact.impact.time, contact.pair);
        let contacts = straight.collisions(&start, &end, options).unwrap();
        let contacts: Vec<_> = contacts.iter().map(key).collect();
        let first = contacts.first().copied();
        let found = curved.collisions(&control, options).unwrap();
        assert_eq!(found.iter().map(key).collect::<Vec<_>>(), contacts, "{case}");
        let earliest = curved.collision(&control, options).unwrap();
        assert_eq!(earliest.as_ref().map(key), first, "{case}");
        assert_eq!(
            curved.collides(&control, options).unwrap(),
            first.is_some(),
            "{case}"
        );
        let report = curved.step(&control, options).unwrap();
        assert_eq!(report.earliest.as_ref().map(key), first, "{case}");
        assert_eq!(report.colliding.total(), contacts.len(), "{case}");
        assert!(report.candidates.total() >= contacts.len(), "{case}");
    }
}

#[test]
fn pairs_that_cannot_collide_do_not() {
    let mut random = Rng::with_seed(3);
    let control: Vec<_> = (0..3).map(|_| positions(&mut random, 1.0)).collect();
    let detector = CurveDetector::new(mesh());
    assert!(detector.collides(&slices(&control), CONTACT).unwrap());
    let none = detector.with_can_collide(CanCollide::new(|_, _| false));
    assert!(!none.collides(&slices(&control), CONTACT).unwrap());
}

#[test]
fn wrong_control_points_are_refused() {
    let detector = CurveDetector::new(TriangleMesh::new(1, Vec::new()).unwrap());
    let (good, long, bad) = ([[0.0; 3]; 1], [[0.0; 3]; 2], [[0.0, f64::NAN, 0.0]; 1]);
    let refused = |control: &[&[Point]]| detector.collides(control, CONTACT).unwrap_err();
    assert_eq!(refused(&[&good]), CurvesError::Degree { count: 1 });
    assert_eq!(
        refused(&[&good[..]; 10]).to_string(),
        "10 sets of control points; expected 2 to 9, for degrees 1 to 8"
    );
    assert_eq!(
        refused(&[&good, &long]),
        CurvesError::Positions {
            control: 1,
            error: PositionsError::Count {
                positions: 2,
                vertex_count: 1
            }
        }
    );
    assert_eq!(
        refused(&[&good, &bad, &good]).to_string(),
        "control set 1: vertex 0 has y = NaN, expected a finite number"
    );
    let late = detector
        .collides(&[&good, &good], CONTACT.until(1.5))
        .unwrap_err();
    assert!(matches!(late, CurvesError::Time(_)));
}

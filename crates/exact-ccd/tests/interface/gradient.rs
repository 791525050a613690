//! Derivatives against differences of exact times and distances.

use exact_ccd::{
    CONTACT, EdgeEdge, Gradient, Impact, Kind, NotDifferentiable, Point, Query, Separation, VertexEdge,
    VertexFace, VertexVertex,
};
use fastrand::Rng;

fn random_points<K: Kind>(random: &mut Rng) -> K::Points {
    let mut points = K::Points::default();
    for coordinate in points.as_mut().as_flattened_mut() {
        *coordinate = random.f64();
    }
    points
}

/// The points moved by `size` in a direction.
fn moved<K: Kind>(points: &K::Points, direction: &K::Points, size: f64) -> K::Points {
    let mut moved = *points;
    let direction = direction.as_ref().as_flattened();
    for (x, d) in moved.as_mut().as_flattened_mut().iter_mut().zip(direction) {
        *x += size * d;
    }
    moved
}

/// The derivative along a direction of both ends.
fn along<K: Kind>(gradient: &Gradient<K>, directions: &[K::Points; 2]) -> f64 {
    let ends = gradient.points.iter().zip(directions);
    ends.map(|(g, d)| {
        let (g, d) = (g.as_ref().as_flattened(), d.as_ref().as_flattened());
        g.iter().zip(d).map(|(g, d)| g * d).sum::<f64>()
    })
    .sum()
}

/// The largest derivative.
fn largest<K: Kind>(gradient: &Gradient<K>) -> f64 {
    let values = gradient
        .points
        .iter()
        .flat_map(|points| points.as_ref().as_flattened());
    values.fold(0.0, |most, value| most.max(value.abs()))
}

/// The steps of differences.
const STEP: f64 = 1.0 / (1 << 14) as f64;

/// The derivative of a value of queries along directions by central differences of fourth order.
fn difference<K: Kind>(
    query: &Query<K>,
    directions: &[K::Points; 2],
    h: f64,
    value: impl Fn(&Query<K>) -> Option<f64>,
) -> Option<f64> {
    let at = |size: f64| {
        let [x0, x1] = query.points();
        let [d0, d1] = directions;
        value(&Query::new(moved::<K>(x0, d0, size), moved::<K>(x1, d1, size)).unwrap())
    };
    Some((8.0 * (at(h)? - at(-h)?) - (at(2.0 * h)? - at(-2.0 * h)?)) / (12.0 * h))
}

/// The distances of the parameters from the boundary of their domain, of a square or of a triangle.
fn margins(impact: &Impact) -> [f64; 5] {
    let [u, v] = impact.parameters;
    [u, v, 1.0 - u, 1.0 - v, (1.0 - u - v).abs()]
}

fn is_zero(x: f64) -> bool {
    x < 1e-9
}

/// Compares derivatives of the time of impact with differences of exact times, for contacts that are not
/// nearly tangent or nearly on a boundary, where the differences themselves have large errors.
fn check_times<K: Kind>(seed: u64, separation: f64, count: usize) {
    let mut random = Rng::with_seed(seed);
    let separation = Separation::new(separation).unwrap();
    let mut compared = 0;
    while compared < count {
        let query =
            Query::<K>::new(random_points::<K>(&mut random), random_points::<K>(&mut random)).unwrap();
        let directions = [random_points::<K>(&mut random), random_points::<K>(&mut random)];
        let Ok(gradient) = query.time_gradient(separation) else {
            continue;
        };
        let impact = query.impact(separation).unwrap();
        let margins = margins(&impact);
        let is_generic = margins
            .iter()
            .all(|&x| x > 0.02 || (is_zero(x) && !separation.is_zero()));
        if largest(&gradient) > 2.0 || !is_generic {
            continue;
        }
        // The same features are closest in all of the queries.
        let time = |query: &Query<K>| {
            let impact = query.impact(separation)?;
            let same = self::margins(&impact).map(is_zero) == margins.map(is_zero);
            same.then_some(impact.time.lower())
        };
        let differences = [STEP, STEP / 2.0].map(|h| difference(&query, &directions, h, time));
        let [Some(coarse), Some(difference)] = differences else {
            continue;
        };
        let derivative = along(&gradient, &directions);
        let scale = largest(&gradient).max(derivative.abs());
        if (coarse - difference).abs() > 1e-6 * scale {
            // The differences have not converged.
            continue;
        }
        assert!(
            (derivative - difference).abs() <= 1e-6 * scale,
            "{query:?} {derivative} {difference}"
        );
        compared += 1;
    }
}

#[test]
fn times_of_contact() {
    check_times::<VertexFace>(70, 0.0, 10_000);
    check_times::<EdgeEdge>(71, 0.0, 10_000);
}

#[test]
fn times_within_a_distance() {
    check_times::<VertexFace>(72, 0.05, 10_000);
    check_times::<EdgeEdge>(73, 0.05, 10_000);
    check_times::<VertexEdge>(74, 0.1, 10_000);
    check_times::<VertexVertex>(75, 0.2, 10_000);
}

fn check_distances<K: Kind>(seed: u64) {
    let mut random = Rng::with_seed(seed);
    let mut compared = 0;
    while compared < 300 {
        let query =
            Query::<K>::new(random_points::<K>(&mut random), random_points::<K>(&mut random)).unwrap();
        let directions = [random_points::<K>(&mut random), random_points::<K>(&mut random)];
        let t = random.f64();
        let bounds = query.distance_at(t).unwrap();
        let Ok(gradient) = query.distance_gradient(t) else {
            continue;
        };
        if bounds.lower < 0.1 {
            continue;
        }
        let value = |query: &Query<K>| query.distance_at(t).ok().map(|bounds| bounds.lower);
        let difference = difference(&query, &directions, STEP, value).unwrap();
        let derivative = along(&gradient, &directions);
        // A change of features between the differences changes the second derivative.
        compared += usize::from((derivative - difference).abs() <= 1e-6);
        assert!(
            (derivative - difference).abs() <= 1e-3,
            "{query:?} {t} {derivative} {difference}"
        );
    }
}

#[test]
fn distances() {
    check_distances::<VertexFace>(76);
    check_distances::<EdgeEdge>(77);
    check_distances::<VertexEdge>(78);
    check_distances::<VertexVertex>(79);
}

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A vertex that moves against a face at rest.
fn falling(from: Point, to: Point) -> Query<VertexFace> {
    let at = |p: Point| [p, FACE[0], FACE[1], FACE[2]];
    Query::new(at(from), at(to)).unwrap()
}

#[test]
fn undefined_derivatives_have_their_reason() {
    let time = |query: Query<VertexFace>| query.time_gradient(CONTACT).unwrap_err();
    let above = [0.25, 0.25, 1.0];
    assert_eq!(time(falling(above, above)), NotDifferentiable::Free);
    assert_eq!(time(falling([0.25, 0.25, 0.0], above)), NotDifferentiable::Start);
    assert_eq!(time(falling(above, [0.25, 0.25, 0.0])), NotDifferentiable::End);
    // On the side, and on a corner.
    assert_eq!(
        time(falling([0.5, 0.5, 1.0], [0.5, 0.5, -1.0])),
        NotDifferentiable::Features
    );
    assert_eq!(
        time(falling([0.0, 0.0, 1.0], [0.0, 0.0, -1.0])),
        NotDifferentiable::Features
    );
    // In the plane.
    assert_eq!(
        time(falling([-1.0, 0.25, 0.0], [1.0, 0.25, 0.0])),
        NotDifferentiable::Features
    );
    let within = |d: f64, query: Query<EdgeEdge>| query.time_gradient(Separation::new(d).unwrap());
    // Parallel edges have many closest points.
    let parallel = |z: f64| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let query = Query::new(parallel(1.0), parallel(-1.0)).unwrap();
    assert_eq!(within(0.25, query), Err(NotDifferentiable::Features));
    let across = |z: f64| [[0.0, -1.0, z], [0.0, 1.0, z], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let query = Query::new(across(1.0), across(-1.0)).unwrap();
    assert!(within(0.25, query).is_ok());
    // Vertices that pass each other at the distance 1.
    let passing =
        Query::<VertexVertex>::new([[-1.0, 1.0, 0.0], [0.0; 3]], [[1.0, 1.0, 0.0], [0.0; 3]]).unwrap();
    let tangent = passing.time_gradient(Separation::new(1.0).unwrap());
    assert_eq!(tangent, Err(NotDifferentiable::Tangent));
    // Two vertices meet by coincidence.
    let meeting =
        Query::<VertexVertex>::new([[-1.0, 0.0, 0.0], [0.0; 3]], [[1.0, 0.0, 0.0], [0.0; 3]]).unwrap();
    assert_eq!(meeting.time_gradient(CONTACT), Err(NotDifferentiable::Features));
    assert_eq!(meeting.distance_gradient(0.5), Err(NotDifferentiable::Touching));
    assert!(meeting.distance_gradient(0.25).is_ok());
    assert!(matches!(
        meeting.distance_gradient(2.0),
        Err(NotDifferentiable::Time(_))
    ));
}

/// 2ᵏ.
fn power(k: i32) -> f64 {
    2f64.powi(k)
}

/// The derivative of the time at which a vertex falls through a face, in a unit of length.
fn in_units(unit: f64) -> Result<(), NotDifferentiable> {
    let at = |z: f64| [[0.25, 0.25, z], FACE[0], FACE[1], FACE[2]].map(|point| point.map(|x| x * unit));
    let query = Query::<VertexFace>::new(at(1.0), at(-1.0)).unwrap();
    query.time_gradient(CONTACT).map(|_| ())
}

#[test]
fn derivatives_that_roundings_could_change_have_none() {
    // A vertex that moves nearly in the plane of the face.
    let grazing = |height: f64| {
        let query = falling([0.125, 0.25, height], [0.375, 0.25, -height]);
        query.time_gradient(CONTACT).map(|_| ())
    };
    assert_eq!(grazing(power(-32)), Err(NotDifferentiable::Tangent));
    assert_eq!(grazing(power(-24)), Ok(()));
    // The same in motion that is long compared with the face, and in small units.
    let passing = |height: f64| {
        let far = power(20);
        let query = falling([0.25 - far, 0.25, height], [0.25 + far, 0.25, -height]);
        query.time_gradient(CONTACT).map(|_| ())
    };
    assert_eq!(passing(power(-10)), Err(NotDifferentiable::Tangent));
    assert_eq!(passing(1.0), Ok(()));
    assert_eq!(in_units(power(-60)), Ok(()));
    // Two vertices near each other, in a large motion, in one frame and at t = 0.
    let apart = |gap: f64| {
        let query =
            Query::<VertexVertex>::new([[0.0; 3], [0.0, gap, 0.0]], [[0.0; 3], [1.0, 0.0, 0.0]]).unwrap();
        query.distance_gradient(0.0).map(|_| ())
    };
    assert_eq!(apart(power(-26)), Err(NotDifferentiable::Touching));
    assert_eq!(apart(power(-24)), Ok(()));
    // Edges that meet at an end, or almost: in the first or the second one.
    let meeting = |u: f64, v: f64| {
        let at = |z: f64| {
            [
                [-u, 0.0, z],
                [1.0 - u, 0.0, z],
                [0.0, -v, 0.0],
                [0.0, 1.0 - v, 0.0],
            ]
        };
        let query = Query::<EdgeEdge>::new(at(1.0), at(-1.0)).unwrap();
        query.time_gradient(CONTACT).map(|_| ())
    };
    for near in [0.0, power(-36)] {
        for [u, v] in [[near, 0.5], [1.0 - near, 0.5], [0.5, near], [0.5, 1.0 - near]] {
            assert_eq!(meeting(u, v), Err(NotDifferentiable::Features), "{u} {v}");
        }
    }
    for [u, v] in [
        [power(-20), 0.5],
        [1.0 - power(-20), 0.5],
        [0.5, power(-20)],
        [0.5, 1.0 - power(-20)],
    ] {
        assert_eq!(meeting(u, v), Ok(()), "{u} {v}");
    }
    // Edges that are parallel at the time of impact only: one turns.
    let turning = |[x, y]: [f64; 2], z: f64| [[-1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-x, -y, z], [x, y, z]];
    let query = Query::<EdgeEdge>::new(turning([1.0, 0.0], 1.0), turning([0.0, 1.0], 0.0)).unwrap();
    let half = Separation::new(0.5).unwrap();
    assert_eq!(query.impact(half).map(|impact| impact.time.lower()), Some(0.5));
    assert_eq!(
        query.time_gradient(half).map(|_| ()),
        Err(NotDifferentiable::Features)
    );
}

#[test]
fn derivatives_beyond_the_largest_numbers_have_none() {
    let time = falling([0.25, 0.25, f64::MAX], [0.25, 0.25, -f64::MAX]).time_gradient(CONTACT);
    assert_eq!(time.map(|_| ()), Err(NotDifferentiable::Overflow));
    // The derivatives are of the order of 2¹⁰⁴⁰.
    assert_eq!(
        in_units(f64::from_bits(1 << 34)),
        Err(NotDifferentiable::Overflow)
    );
    let [p, q] = [[f64::MAX, 0.0, 0.0], [-f64::MAX, 0.0, 0.0]];
    let query = Query::<VertexVertex>::new([p, q], [p, q]).unwrap();
    assert_eq!(
        query.distance_gradient(0.5).map(|_| ()),
        Err(NotDifferentiable::Overflow)
    );
}

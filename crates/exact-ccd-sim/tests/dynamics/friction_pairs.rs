//! Friction coefficients of pairs of bodies.

use exact_ccd_sim::{Body, Friction, FrictionPair, HalfSpace, Settings, Simulation, System, shapes};

const DEGREES: f64 = 20.0;

fn pair(a: &str, b: &str, coefficient: f64) -> FrictionPair {
    let between = [a, b].map(str::to_owned);
    FrictionPair { between, coefficient }
}

fn block(name: &str, z: f64) -> Body {
    let block = shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.4]);
    block.placed(|[x, y, w]| [x + 1.0, y + 3e-4, w + z]).named(name)
}

fn settings(pairs: Vec<FrictionPair>) -> Settings {
    let angle = DEGREES.to_radians();
    Settings {
        gravity: [9.81 * angle.sin(), -9.81 * angle.cos(), 0.0],
        friction: Friction {
            coefficient: 0.1,
            pairs,
            ..Friction::default()
        },
        ..Settings::default()
    }
}

/// The accelerations along x of the bodies of a system, after they have settled. They start within the
/// contact distance, and the barrier pushes them off the slope, so that they slide at first. With a
/// coefficient of 1.02 tan α, a block then slows down by 0.02 g sin α only: it sticks after 0.6 s.
fn accelerations(system: System, settings: Settings, bodies: &[Body]) -> Vec<f64> {
    let ranges = System::ranges(bodies);
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut at = |steps: u32| -> Vec<f64> {
        (0..steps).for_each(|_| assert!(simulation.step().unwrap().converged));
        let of = |range: &std::ops::Range<u32>| {
            let vertices = range.start as usize..range.end as usize;
            let count = vertices.len() as f64;
            simulation.state().positions[vertices]
                .iter()
                .map(|x| x[0])
                .sum::<f64>()
                / count
        };
        ranges.iter().map(of).collect()
    };
    let [start, middle, end] = [at(80), at(40), at(40)];
    let places = 0..bodies.len();
    places
        .map(|body| (end[body] - 2.0 * middle[body] + start[body]) / 0.16)
        .collect()
}

/// Three blocks on one slope: two have coefficients to the slope by their names, the third has the default.
/// One of the two sticks. The order of the names in a pair does not matter.
#[test]
fn blocks_on_one_slope_have_coefficients_of_their_own() {
    let angle = DEGREES.to_radians();
    let pairs = vec![
        pair("rough", "slope", 9.0),
        pair("slope", "smooth", 0.3),
        pair("rough", "slope", 1.02 * angle.tan()),
    ];
    let blocks = [block("rough", 0.2), block("smooth", 0.8), block("", 1.4)];
    let slope = |x: f64| 9.81 * (angle.sin() - x * angle.cos());
    let expected = [0.0, slope(0.3), slope(0.1)];
    let check = |system: System, what: &str| {
        let found = accelerations(system, settings(pairs.clone()), &blocks);
        assert!(found[0].abs() < 1e-3, "{what}: {found:?}");
        for (found, expected) in found.iter().zip(expected).skip(1) {
            assert!(
                (found / expected - 1.0).abs() < 0.02,
                "{what}: {found}, expected {expected}"
            );
        }
    };
    let mut bodies = blocks.to_vec();
    bodies.push(shapes::floor([1, 1], [9.0, 2.0]).named("slope"));
    check(System::new(&bodies, &[]).unwrap(), "triangles");
    let ground = HalfSpace::new([0.0; 3], [0.0, 1.0, 0.0]).named("slope");
    let system = System::new(&blocks, &[]).unwrap();
    check(system.with_half_spaces(vec![ground]).unwrap(), "half space");
}

#[test]
fn names_that_no_body_has_and_negative_coefficients_are_errors() {
    let error = |pairs: Vec<FrictionPair>| {
        let system = System::new(&[block("block", 0.0), block("", 1.0)], &[]).unwrap();
        Simulation::new(system, settings(pairs))
            .err()
            .unwrap()
            .to_string()
    };
    let right = pair("block", "block", 0.1);
    assert_eq!(
        error(vec![right.clone(), pair("block", "slope", 0.1)]),
        "friction pair 1: `between` is `slope`, expected names of bodies and half spaces: `block`"
    );
    assert_eq!(
        error(vec![right, pair("block", "block", -0.1)]),
        "friction pair 1: `coefficient` is -0.1, expected a number not below 0"
    );
}

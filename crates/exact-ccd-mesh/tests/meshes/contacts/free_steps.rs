//! Steps of vertices against a loop over all pairs: in integers, and by rounds that search all pairs.

use std::collections::BTreeSet;

use exact_ccd::{CONTACT, EdgeEdge, Options, Separation, Thickness, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{
    Detector, FreeStepOptions, FreeSteps, MinDistance, Pair, PairKind, Point, Step, TriangleMesh,
};
use fastrand::Rng;

use super::scene::{Scene, allowed, contacts_within, on_threads, touching};

/// A small scene of one of several families, and its scale.
fn scene(random: &mut Rng) -> (Scene, f64) {
    match random.usize(..7) {
        0 => Scene::pieces(random),
        1 => Scene::mixed(random),
        2 => (Scene::sheets(random, 1, 0.0, 2.0), 1.0),
        3 => (Scene::sheets(random, 1, 1e14, 2.0), 1.0),
        4 => on_grid(random, 3),
        5 => on_grid(random, 2),
        _ => two(random),
    }
}

/// Vertices on a grid in `dimension` dimensions, at both ends: coplanar motion, parallel edges, flat faces,
/// contact at the start and at the end.
fn on_grid(random: &mut Rng, dimension: usize) -> (Scene, f64) {
    let count = random.u32(4..9);
    let vertex = |random: &mut Rng| random.u32(..count);
    let faces = (0..random.usize(1..4))
        .map(|_| [(); 3].map(|()| vertex(random)))
        .collect();
    let rods: Vec<[u32; 2]> = (0..random.usize(..3))
        .map(|_| [(); 2].map(|()| vertex(random)))
        .collect();
    let rods: Vec<_> = rods.into_iter().filter(|[a, b]| a != b).collect();
    let mesh = TriangleMesh::with_edges(count as usize, faces, &rods).unwrap();
    let mut place = || -> Point {
        [0, 1, 2].map(|axis| {
            if axis < dimension {
                f64::from(random.u32(..5))
            } else {
                0.0
            }
        })
    };
    let x0 = (0..count).map(|_| place()).collect();
    let x1 = (0..count).map(|_| place()).collect();
    (Scene { mesh, x0, x1 }, 1.0)
}

/// Two primitives in random motion.
fn two(random: &mut Rng) -> (Scene, f64) {
    let faces = [vec![[0, 1, 2]], Vec::new()][random.usize(..2)].clone();
    let rods: &[[u32; 2]] = if faces.is_empty() { &[[0, 1], [2, 3]] } else { &[] };
    let mesh = TriangleMesh::with_edges(4, faces, rods).unwrap();
    let mut place = || [0; 3].map(|_| random.f64());
    let x0 = (0..4).map(|_| place()).collect();
    let x1 = (0..4).map(|_| place()).collect();
    (Scene { mesh, x0, x1 }, 1.0)
}

/// Contact, a distance, thicknesses, or a distance with an inner one.
fn min_distance(random: &mut Rng, scene: &Scene, scale: f64) -> MinDistance {
    let mut distance = || Separation::new(scale * [1e-3, 0.05, 0.25][random.usize(..3)]).unwrap();
    let uniform = MinDistance::uniform(distance());
    let inner = distance();
    let mut thickness = |_| scale * [0.0, 0.01, 0.1][random.usize(..3)];
    let thickness: Vec<f64> = (0..scene.x0.len()).map(&mut thickness).collect();
    match random.usize(..8) {
        0 => uniform,
        1 => MinDistance::thickness(Thickness::new(&thickness).unwrap()),
        2 => uniform.with_inner(inner),
        _ => MinDistance::default(),
    }
}

/// True if a pair touches on the way to the end, in integers.
fn touches<K: PairKind>(step: Step<'_>, ids: [u32; 2], min_distance: &MinDistance) -> bool {
    let query = step.query::<K>(ids).unwrap();
    query.exactly().collides(allowed::<K>(step, ids, min_distance))
}

fn touches_in(step: Step<'_>, pair: Pair, min_distance: &MinDistance) -> bool {
    match pair {
        Pair::VertexFace { vertex, face } => touches::<VertexFace>(step, [vertex, face], min_distance),
        Pair::EdgeEdge { a, b } => touches::<EdgeEdge>(step, [a, b], min_distance),
        Pair::VertexEdge { vertex, edge } => touches::<VertexEdge>(step, [vertex, edge], min_distance),
        Pair::VertexVertex { a, b } => touches::<VertexVertex>(step, [a, b], min_distance),
    }
}

/// Checks the promises about steps of vertices, in integers, for every pair.
fn check(scene: &Scene, min_distance: &MinDistance, pinned: &[u32], common: f64, found: &FreeSteps) {
    let [x0, end] = [&scene.x0, &found.positions];
    let taken = Step::new(&scene.mesh, x0, end).unwrap();
    let blocked: BTreeSet<Pair> = found.blocked.iter().copied().collect();
    assert_eq!(blocked.len(), found.blocked.len());
    for pair in scene.pairs().pairs() {
        assert_eq!(
            touches_in(taken, pair, min_distance),
            blocked.contains(&pair),
            "{pair:?}"
        );
    }
    for (vertex, &size) in found.sizes.iter().enumerate() {
        assert!((0.0..=1.0).contains(&size));
        assert_eq!(found.positions[vertex], scene.step().at(size)[vertex]);
        if pinned.contains(&(vertex as u32)) {
            assert_eq!(size, 1.0);
        } else if pinned.is_empty() {
            assert!(size >= common, "{size} {common}");
        }
    }
    assert!(blocked.is_subset(&scene.pairs().pairs().collect()));
    for pair in &found.blocked {
        for vertex in pair.vertices(&scene.mesh).unwrap() {
            let size = found.sizes[vertex as usize];
            assert!(
                size == 0.0 || pinned.contains(&vertex),
                "{pair:?} {vertex} {size}"
            );
        }
    }
    let starts_in_contact: BTreeSet<Pair> = touching(
        scene.step(),
        &scene.pairs(),
        &min_distance.clone().with_inner(Separation::default()),
    )
    .filter(|&pair| {
        min_distance.inner().is_none() || {
            let rest = Step::new(&scene.mesh, x0, x0).unwrap();
            touches_in(rest, pair, min_distance)
        }
    })
    .collect();
    if pinned.is_empty() {
        // Without pinned vertices, only pairs that touch at the start are blocked.
        assert_eq!(blocked, starts_in_contact);
    } else {
        assert!(blocked.is_superset(&starts_in_contact));
    }
}

fn check_random_steps(seed: u64, count: usize) {
    let mut random = Rng::with_seed(seed);
    let (mut partial, mut common_is_less, mut blocked, mut most_rounds) = (0, 0, 0, 0);
    for _ in 0..count {
        let (scene, scale) = scene(&mut random);
        let min_distance = min_distance(&mut random, &scene, scale);
        let keep = [0.9, 0.5, 1.0][random.usize(..3)];
        let options = FreeStepOptions::default().with_keep(keep);
        let options = options.with_min_distance(min_distance.clone());
        let pinned: Vec<u32> = match random.usize(..3) {
            0 => (0..random.u32(1..4)).collect(),
            _ => Vec::new(),
        };
        let mut detector = Detector::new(scene.mesh.clone());
        let found = detector
            .free_steps(&scene.x0, &scene.x1, &pinned, &options)
            .unwrap();
        let common = detector.free_step(&scene.x0, &scene.x1, &options).unwrap().size;
        check(&scene, &min_distance, &pinned, common, &found);
        partial += usize::from(found.sizes.iter().any(|&size| 0.0 < size && size < 1.0));
        common_is_less += usize::from(common < 1.0 && found.sizes.contains(&1.0));
        blocked += usize::from(!found.blocked.is_empty());
        most_rounds = most_rounds.max(found.rounds);
    }
    assert!(partial > count / 10 && common_is_less > count / 10 && blocked > count / 50);
    assert!(most_rounds > 4, "{most_rounds}");
}

#[test]
fn random_and_degenerate_steps_are_free_in_integers() {
    check_random_steps(60, 800);
}

#[test]
#[ignore = "100,000 steps take minutes: run it with --release -- --ignored"]
fn a_hundred_thousand_steps_are_free_in_integers() {
    check_random_steps(61, 100_000);
}

/// The rounds as documented, with a search of all pairs in each: the sizes of all vertices.
fn rounds(scene: &Scene, min_distance: &MinDistance, keep: f64, common: f64) -> (Vec<f64>, usize) {
    let mut sizes = vec![1.0; scene.x0.len()];
    let (mut kept, mut least) = (1.0, None);
    for round in 1.. {
        let at = |(vertex, &size): (usize, &f64)| scene.step().at(size)[vertex];
        let end: Vec<Point> = sizes.iter().enumerate().map(at).collect();
        let taken = Step::new(&scene.mesh, &scene.x0, &end).unwrap();
        let contacts = contacts_within(taken, &scene.pairs(), min_distance);
        if contacts.is_empty() {
            return (sizes, round);
        }
        let least = *least.get_or_insert(keep * contacts[0].impact.time.lower());
        assert!(
            common == least,
            "the common step is smaller for rounding, which this loop does not know"
        );
        kept = if round < 32 { kept * keep } else { 0.0 };
        let before = sizes.clone();
        for contact in contacts {
            let (impact, vertices) = (contact.impact, contact.pair.vertices(&scene.mesh).unwrap());
            let can_retreat = |vertex: u32| before[vertex as usize] > least;
            let approaching = approaching(
                &vertices,
                contact.pair.kind().sizes()[0],
                &impact,
                [&scene.x0, &end],
            );
            let approaching: Vec<u32> = approaching.into_iter().filter(|&v| can_retreat(v)).collect();
            let held_back = if approaching.is_empty() {
                vertices
            } else {
                approaching
            };
            for vertex in held_back.into_iter().filter(|&vertex| can_retreat(vertex)) {
                let vertex = vertex as usize;
                let size: f64 = kept * impact.time.lower() * before[vertex];
                sizes[vertex] = size.min(before[vertex].next_down()).min(sizes[vertex]).max(least);
            }
        }
    }
    unreachable!("a round has no contact")
}

/// The vertices that approach the other primitive of a contact; none without a normal.
fn approaching(
    vertices: &[u32],
    first: usize,
    impact: &exact_ccd::Impact,
    [x0, x1]: [&[Point]; 2],
) -> Vec<u32> {
    let Some(normal) = impact.normal else {
        return Vec::new();
    };
    let [u, v] = impact.parameters;
    let weights = match (first, vertices.len()) {
        (1, 4) => vec![1.0, -(1.0 - u - v), -u, -v],
        (2, 4) => vec![1.0 - u, u, -(1.0 - v), -v],
        (1, 3) => vec![1.0, -(1.0 - v), -v],
        _ => vec![1.0, -1.0],
    };
    let changes: Vec<f64> = weights
        .iter()
        .zip(vertices)
        .map(|(weight, &vertex)| {
            let [a, b] = [x0[vertex as usize], x1[vertex as usize]];
            let [x, y, z] = [0, 1, 2].map(|axis: usize| normal[axis] * (b[axis] - a[axis]));
            weight * (x + y + z)
        })
        .collect();
    let sum: f64 = changes.iter().sum();
    let of_sum = vertices
        .iter()
        .zip(changes)
        .filter(|(_, change)| change * sum > 0.0);
    of_sum.map(|(&vertex, _)| vertex).collect()
}

/// A search of the pairs with a vertex that has been held back finds all that has changed, and a vertex
/// without contact in any round goes all the way.
#[test]
fn rounds_are_those_that_search_all_pairs() {
    let mut random = Rng::with_seed(62);
    let mut compared = 0;
    for _ in 0..600 {
        let (scene, scale) = scene(&mut random);
        let min_distance = min_distance(&mut random, &scene, scale);
        let options = FreeStepOptions::default().with_min_distance(min_distance.clone());
        let mut detector = Detector::new(scene.mesh.clone());
        let common = detector.free_step(&scene.x0, &scene.x1, &options).unwrap();
        let full = options.keep * common.contact.map_or(1.0, |contact| contact.impact.time.lower());
        if common.size < full || common.size == 0.0 {
            continue;
        }
        let found = detector.free_steps(&scene.x0, &scene.x1, &[], &options).unwrap();
        assert_eq!(
            (found.sizes, found.rounds),
            rounds(&scene, &min_distance, 0.9, full)
        );
        compared += 1;
    }
    assert!(compared > 200, "{compared}");
}

/// Points in a row that move by 1: the first one is held back by a point at rest, and each of the others by
/// the one before it, a round later. A face at rest, far away, may be so large that the step counts as short.
fn row(keep: f64, size_of_face: f64, rounds: usize) -> Scene {
    let least = 0.02 * keep;
    let (mut x0, mut size, mut kept) = (vec![[0.02, 0.0, 0.0]], least, keep);
    for round in 2..rounds {
        // It would pass the one before it by a little, and no other one.
        let gap = 0.999 - size;
        kept = if round < 32 { kept * keep } else { 0.0 };
        size = (kept * gap / (1.0 - size)).max(least);
        x0.push([x0[round - 2][0] + gap, 0.0, 0.0]);
    }
    let mut x1: Vec<Point> = x0.iter().map(|[x, y, z]| [x - 1.0, *y, *z]).collect();
    let at_rest = [
        [0.0; 3],
        [0.0, 0.0, 500.0],
        [0.0, size_of_face, 500.0],
        [size_of_face, 0.0, 500.0],
    ];
    x0.extend(at_rest);
    x1.extend(at_rest);
    let first = rounds as u32;
    let mesh = TriangleMesh::new(rounds + 3, vec![[first, first + 1, first + 2]]).unwrap();
    Scene { mesh, x0, x1 }
}

/// From round 64 on, a contact brings all vertices to the least size: not one round for each vertex.
#[test]
fn rounds_end_in_long_rows() {
    let options = FreeStepOptions::default();
    let scene = row(options.keep, 0.1, 300);
    let mut detector = Detector::new(scene.mesh.clone());
    let found = detector.free_steps(&scene.x0, &scene.x1, &[], &options).unwrap();
    assert!((65..70).contains(&found.rounds), "{}", found.rounds);
    assert_eq!(found.blocked, []);
    let common = detector.free_step(&scene.x0, &scene.x1, &options).unwrap().size;
    assert!(found.sizes.iter().all(|&size| size == common));
    assert_eq!(detector.collides(&scene.x0, &found.positions, CONTACT), Ok(false));
}

/// From round 32 on, contacts bring vertices to the least size. Boxes of a long step before are not used.
#[test]
fn late_rounds_bring_vertices_to_the_least_size() {
    let options = FreeStepOptions::default();
    for size_of_face in [0.1, 10.0] {
        let scene = row(options.keep, size_of_face, 40);
        let mut detector = Detector::new(scene.mesh.clone());
        let common = detector.free_step(&scene.x0, &scene.x1, &options).unwrap().size;
        let expected = rounds(&scene, &options.min_distance, options.keep, common);
        assert_eq!(expected.1, 40);
        let far: Vec<Point> = scene.x0.iter().map(|[x, y, z]| [*x, *y, z + 100.0]).collect();
        assert_eq!(detector.collides(&scene.x0, &far, CONTACT), Ok(false));
        let found = detector.free_steps(&scene.x0, &scene.x1, &[], &options).unwrap();
        assert_eq!((found.sizes, found.rounds), expected);
    }
}

#[test]
fn sizes_do_not_depend_on_threads_or_on_steps_before() {
    let mut random = Rng::with_seed(63);
    let scene = Scene::sheets(&mut random, 12, 0.0, 2.0);
    let options = FreeStepOptions::default();
    let mut detector = Detector::new(scene.mesh.clone());
    let found = detector.free_steps(&scene.x0, &scene.x1, &[], &options).unwrap();
    assert!(found.rounds > 2 && found.sizes.iter().any(|&size| size < 1.0));
    for threads in [1, 2, 3, 8] {
        let again = on_threads(threads, || {
            let mut detector = detector.clone();
            detector.free_steps(&scene.x0, &scene.x1, &[], &options)
        });
        assert_eq!(again, Ok(found.clone()));
    }
}

/// The first contact of each vertex, from a loop over all pairs.
#[test]
fn first_contacts_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(64);
    let mut found = 0;
    for _ in 0..100 {
        let (scene, scale) = scene(&mut random);
        let min_distance = min_distance(&mut random, &scene, scale);
        let contacts = contacts_within(scene.step(), &scene.pairs(), &min_distance);
        let mut expected = vec![f64::INFINITY; scene.x0.len()];
        for contact in &contacts {
            for vertex in contact.pair.vertices(&scene.mesh).unwrap() {
                let first = &mut expected[vertex as usize];
                *first = first.min(contact.impact.time.lower());
            }
        }
        let mut detector = Detector::new(scene.mesh.clone());
        let options = Options::within(min_distance);
        let first = detector.first_contacts(&scene.x0, &scene.x1, options).unwrap();
        assert_eq!(first.times(), expected);
        assert_eq!(first.contacts.len(), contacts.len());
        found += usize::from(!contacts.is_empty());
    }
    assert!(found > 30, "{found}");
}

/// The bits of a step for every vertex of 60 triangles; the Python tests have the same number.
#[test]
fn sizes_and_positions_have_the_bits_of_other_languages() {
    let mut state: u64 = 1;
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut x0, mut x1): (Vec<Point>, Vec<Point>) = Default::default();
    for _ in 0..60 {
        let center: Point = [0; 3].map(|_| 1.5 * next());
        for _ in 0..3 {
            let start = center.map(|coordinate| coordinate + 0.5 * next());
            x0.push(start);
            x1.push(start.map(|coordinate| coordinate + (next() - 0.5)));
        }
    }
    let faces = (0..60)
        .map(|face| [3 * face, 3 * face + 1, 3 * face + 2])
        .collect();
    let mesh = TriangleMesh::new(180, faces).unwrap();
    let options = FreeStepOptions::default();
    let steps = Detector::new(mesh).free_steps(&x0, &x1, &[], &options).unwrap();
    let numbers = steps.sizes.iter().chain(steps.positions.as_flattened());
    let fnv_1a = numbers.fold(0xcbf2_9ce4_8422_2325_u64, |hash, number| {
        (hash ^ number.to_bits()).wrapping_mul(0x0100_0000_01b3)
    });
    assert_eq!((fnv_1a, steps.rounds), (16825418621938942653, 4));
}

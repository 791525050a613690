//! Repairs of generated meshes: the result is free by the crate's own search, and by brute force over all
//! pairs.

mod cases;
mod recordings;
mod shapes;

use std::sync::Arc;

use exact_ccd::predicates::EdgeFace;
use exact_ccd::{CONTACT, EdgeEdge, Options, Query, Separation, VertexFace};
use exact_ccd_mesh::{
    Bvh, CanCollide, Detector, IntersectionOptions, Point, PositionsError, TriangleMesh, intersections,
};
use exact_ccd_repair::{
    Outcome, Phase, Reason, RepairError, RepairOptions, Repaired, Unrepaired, repair, repair_in_f32,
};
use shapes::{Body, boxed, flattened, grid, joined, klein_bottle, limb, sphere, torus, twisted_strip};

fn repaired(body: &Body, options: &RepairOptions<'_>) -> Repaired {
    match repair(&body.mesh, &body.positions, options).expect("the positions fit the mesh") {
        Outcome::Repaired(repaired) => repaired,
        Outcome::Unrepaired(Unrepaired {
            reason,
            crossings,
            contacts,
            ..
        }) => {
            panic!(
                "{reason:?}: {} crossings and {} contacts remain",
                crossings.len(),
                contacts.len()
            )
        }
    }
}

fn unrepaired(body: &Body, options: &RepairOptions<'_>) -> Unrepaired {
    match repair(&body.mesh, &body.positions, options).expect("the positions fit the mesh") {
        Outcome::Repaired(repaired) => panic!("it was repaired: {:?}", repaired.change),
        Outcome::Unrepaired(unrepaired) => unrepaired,
    }
}

/// Positions in which no edge meets a face and no two primitives are within a distance.
fn is_free(mesh: &Arc<TriangleMesh>, x: &[Point], distance: Separation) -> bool {
    let found = intersections(mesh, x, &Bvh, &IntersectionOptions::default()).expect("the positions fit");
    let collides = Detector::new(mesh.clone())
        .collides(x, x, Options::within(distance))
        .expect("the positions fit");
    found.is_empty() && !collides
}

/// The same over all pairs, without a broad phase: of edges and faces, vertices and faces, and two edges.
fn is_free_by_brute_force(mesh: &TriangleMesh, x: &[Point], distance: Separation) -> bool {
    let at = |vertex: u32| x[vertex as usize];
    let apart = |a: &[u32], b: &[u32]| a.iter().all(|vertex| !b.contains(vertex));
    let vertex_face = |vertex: u32, face: &[u32; 3]| {
        let [a, b, c] = face.map(at);
        let points = [at(vertex), a, b, c];
        Query::<VertexFace>::new(points, points)
            .expect("they are finite")
            .collides(distance)
    };
    let edge_edge = |a: &[u32; 2], b: &[u32; 2]| {
        let ([a0, a1], [b0, b1]) = (a.map(at), b.map(at));
        let points = [a0, a1, b0, b1];
        Query::<EdgeEdge>::new(points, points)
            .expect("they are finite")
            .collides(distance)
    };
    let faces = mesh.faces().iter();
    let no_face_meets = faces.clone().all(|face| {
        let edges = mesh.edges().iter().filter(|edge| apart(&edge[..], face));
        let meets = |edge: &[u32; 2]| {
            EdgeFace::new(edge.map(at), face.map(at))
                .expect("they are finite")
                .intersects()
        };
        let vertices = (0..mesh.vertex_count() as u32).filter(|vertex| !face.contains(vertex));
        !edges.clone().any(meets) && !vertices.clone().any(|vertex| vertex_face(vertex, face))
    });
    let edges = mesh.edges();
    let pairs = edges
        .iter()
        .enumerate()
        .flat_map(|(i, a)| edges[..i].iter().map(move |b| (a, b)));
    no_face_meets
        && pairs
            .filter(|(a, b)| apart(&a[..], &b[..]))
            .all(|(a, b)| !edge_edge(a, b))
}

/// Meshes that intersect and have free positions nearby, with their names.
fn tangled() -> Vec<(&'static str, Body)> {
    let at = |body: Body, x: f64, y: f64, z: f64| body.moved([x, y, z]);
    vec![
        (
            "boxes through each other",
            joined([boxed(4, 1.0), at(boxed(4, 1.0), 0.7, 0.33, 0.21)]),
        ),
        (
            "a box through a corner",
            joined([boxed(4, 1.0), at(boxed(4, 0.5), 0.7, 0.72, 0.74)]),
        ),
        (
            "boxes that touch in a side",
            joined([boxed(3, 1.0), at(boxed(3, 1.0), 1.0, 0.0, 0.0)]),
        ),
        (
            "boxes that touch in a part of a side",
            joined([boxed(3, 1.0), at(boxed(3, 1.0), 1.0, 0.25, 0.125)]),
        ),
        ("a sheet exported twice", joined([grid(8, 1.0), grid(8, 1.0)])),
        (
            "a sheet exported twice, turned over",
            joined([grid(8, 1.0), grid(8, 1.0).reversed()]),
        ),
        ("a box exported twice", joined([boxed(3, 1.0), boxed(3, 1.0)])),
        (
            "crossing sheets",
            joined([grid(10, 1.0), at(grid(10, 1.0).tilted(0.2), 0.03, 0.02, -0.1)]),
        ),
        (
            "a sheet through a ball",
            joined([sphere(12, 0.4), at(grid(16, 2.0), -0.93, -0.97, 0.31)]),
        ),
        (
            "balls",
            joined([sphere(10, 0.5), at(sphere(10, 0.5), 0.8, 0.1, 0.05)]),
        ),
        (
            "three balls",
            joined([
                sphere(8, 0.5),
                at(sphere(8, 0.5), 0.9, 0.0, 0.1),
                at(sphere(8, 0.5), 0.4, 0.8, 0.0),
            ]),
        ),
        (
            "rings that overlap",
            joined([torus(24, 8, 1.0, 0.3), at(torus(24, 8, 1.0, 0.3), 0.1, 0.2, 0.45)]),
        ),
        (
            "a stack of sheets",
            joined([
                grid(8, 1.0),
                at(grid(8, 1.0).tilted(0.05), 0.01, 0.02, -0.025),
                at(grid(8, 1.0).tilted(-0.05), 0.03, 0.0, 0.03),
            ]),
        ),
        ("a strip through itself", twisted_strip(60, 6, 1.0, 0.35)),
        ("a wide strip through itself", twisted_strip(80, 6, 2.0, 0.5)),
        (
            "a vertex on a face",
            joined([grid(4, 1.0), at(flattened(sphere(6, 0.2)), 0.5, 0.5, 0.2)]),
        ),
    ]
}

#[test]
fn tangled_meshes_are_free_afterwards_also_by_brute_force() {
    for (name, body) in tangled() {
        assert!(
            !is_free(&body.mesh, &body.positions, CONTACT.separation),
            "{name} is free before"
        );
        let result = repaired(&body, &RepairOptions::default());
        assert!(
            is_free(&body.mesh, &result.positions, CONTACT.separation),
            "{name}"
        );
        assert!(
            is_free_by_brute_force(&body.mesh, &result.positions, CONTACT.separation),
            "{name}"
        );
        assert!(result.change.moved > 0, "{name}");
        assert!(
            result.change.mean_displacement < 0.15,
            "{name}: {:?}",
            result.change
        );
    }
}

#[test]
fn a_minimum_distance_is_reached() {
    let distance = Separation::new(0.01).expect("it is finite");
    let options = RepairOptions::default().with_min_distance(distance);
    for (name, body) in tangled().into_iter().take(3) {
        let result = repaired(&body, &options);
        assert!(
            is_free_by_brute_force(&body.mesh, &result.positions, distance),
            "{name}"
        );
    }
    // Free of contact, but too near.
    let near = joined([grid(6, 1.0), grid(6, 1.0).moved([0.0, 0.0, 0.005])]);
    assert!(is_free(&near.mesh, &near.positions, CONTACT.separation));
    let result = repaired(&near, &options);
    assert!(is_free_by_brute_force(&near.mesh, &result.positions, distance));
}

#[test]
fn pinned_vertices_keep_their_bits() {
    let (body, sleeve) = (limb(24, 10), torus(24, 10, 0.34, 0.12).moved([0.0, 0.0, 1.0]));
    let pinned: Vec<u32> = (0..body.positions.len() as u32).collect();
    let dressed = joined([body, sleeve]);
    let options = RepairOptions::default().with_pinned(pinned.clone());
    let result = repaired(&dressed, &options);
    assert!(is_free(&dressed.mesh, &result.positions, CONTACT.separation));
    for vertex in pinned {
        let bits = |x: &[Point]| x[vertex as usize].map(f64::to_bits);
        assert_eq!(bits(&result.positions), bits(&dressed.positions));
    }
}

#[test]
fn pinned_vertices_that_intersect_are_named() {
    let both = joined([boxed(2, 1.0), boxed(2, 1.0).moved([0.7, 0.33, 0.21])]);
    let all: Vec<u32> = (0..both.positions.len() as u32).collect();
    let result = unrepaired(&both, &RepairOptions::default().with_pinned(all));
    assert_eq!(result.reason, Reason::Pinned);
    let touching = IntersectionOptions::default();
    let expected = intersections(&both.mesh, &both.positions, &Bvh, &touching).expect("the positions fit");
    assert!(!result.crossings.is_empty());
    assert!(result.crossings.iter().all(|pair| expected.contains(pair)));
}

#[test]
fn a_free_mesh_keeps_its_bits() {
    let apart = joined([boxed(3, 1.0), boxed(3, 1.0).moved([1.25, 0.0, 0.0])]);
    let result = repaired(&apart, &RepairOptions::default());
    assert_eq!(result.positions, apart.positions);
    assert_eq!(
        (result.crossings, result.change.moved, result.change.max_stretch),
        (0, 0, 1.0)
    );
}

#[test]
fn pairs_that_may_intersect_are_left() {
    let both = joined([boxed(3, 1.0), boxed(3, 1.0).moved([0.7, 0.33, 0.21])]);
    let count = boxed(3, 1.0).positions.len() as u32;
    let same = CanCollide::any_vertices(move |a, b| (a < count) == (b < count));
    let result = repaired(&both, &RepairOptions::default().with_can_collide(same));
    assert_eq!(result.positions, both.positions);
}

#[test]
fn a_surface_that_does_not_embed_is_not_repaired() {
    let bottle = klein_bottle(24, 12);
    let result = unrepaired(&bottle, &RepairOptions::default());
    assert_eq!(result.reason, Reason::OneSided { face: 0 });
    assert_eq!(result.positions, bottle.positions);
    assert!(!result.crossings.is_empty());
    // In part of the pairs, it may be free.
    let none = CanCollide::any_vertices(|_, _| false);
    let options = RepairOptions::default().with_can_collide(none);
    assert_eq!(repaired(&bottle, &options).positions, bottle.positions);
}

#[test]
fn a_pinned_loop_through_a_sheet_with_a_pinned_border_is_not_repaired() {
    let sheet = grid(6, 1.0);
    let count = sheet.positions.len();
    let is_inner = |&[x, y, _]: &Point| x.min(y) > 0.0 && x.max(y) < 1.0;
    // The ring passes through the sheet once, and around its border.
    let linked = joined([
        sheet,
        torus(12, 3, 0.6, 0.05).tilted(1.5).moved([1.0, 0.45, 0.03]),
    ]);
    let rests = |vertex: usize| vertex >= count || !is_inner(&linked.positions[vertex]);
    let pinned: Vec<u32> = (0..linked.positions.len())
        .filter(|&vertex| rests(vertex))
        .map(|v| v as u32)
        .collect();
    let options = RepairOptions::default();
    let result = unrepaired(&linked, &options.clone().with_pinned(pinned));
    assert!(
        matches!(result.reason, Reason::Linked { .. }),
        "{:?}",
        result.reason
    );
    assert_eq!(result.positions, linked.positions);
    let ring = (count as u32..linked.positions.len() as u32).collect();
    let result = repaired(&linked, &options.with_pinned(ring));
    assert!(is_free(&linked.mesh, &result.positions, CONTACT.separation));
}

#[test]
fn a_mesh_that_does_not_come_loose_ends_early() {
    // With a hole, a Klein bottle has free positions, but none near these.
    let body = klein_bottle(24, 12).with_hole();
    let result = unrepaired(&body, &RepairOptions::default().with_max_rounds(100_000));
    assert_eq!(result.reason, Reason::Stalled);
    assert!(!result.crossings.is_empty());
}

#[test]
fn an_unrepaired_mesh_is_in_its_best_state() {
    let body = twisted_strip(80, 6, 2.0, 0.5);
    let fewest = std::sync::Mutex::new(usize::MAX);
    let stop = |progress: exact_ccd_repair::Progress| {
        let mut fewest = fewest.lock().expect("no thread panics");
        *fewest = progress.pairs.min(*fewest);
        progress.round == 2
    };
    let result = unrepaired(&body, &RepairOptions::default().with_stop(&stop));
    assert_eq!(
        result.crossings.len(),
        fewest.into_inner().expect("no thread panics")
    );
}

#[test]
fn a_stop_ends_the_phase() {
    let both = joined([boxed(3, 1.0), boxed(3, 1.0).moved([0.7, 0.33, 0.21])]);
    let result = unrepaired(
        &both,
        &RepairOptions::default().with_stop(&|progress| progress.phase == Phase::Loosen),
    );
    assert_eq!(result.reason, Reason::Stopped(Phase::Loosen));
    // A stop in the return leaves free positions.
    let stop = |progress: exact_ccd_repair::Progress| progress.phase == Phase::Return && progress.round == 2;
    let result = repaired(&both, &RepairOptions::default().with_stop(&stop));
    assert!(is_free(&both.mesh, &result.positions, CONTACT.separation));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let both = joined([sphere(10, 0.5), sphere(10, 0.5).moved([0.8, 0.1, 0.05])]);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads start");
        pool.install(|| repaired(&both, &RepairOptions::default()).positions)
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn hostile_input_is_an_error_or_an_outcome() {
    let mesh = Arc::new(TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]]).expect("the indices are in range"));
    let x = [[0.0; 3]; 6];
    let options = RepairOptions::default().with_max_rounds(20);
    assert!(matches!(repair(&mesh, &x, &options), Err(RepairError::Size(0.0))));
    let huge = [
        [1e300, 0.0, 0.0],
        [0.0, 1e300, 0.0],
        [0.0; 3],
        [1e300, 1.0, 0.0],
        [0.0; 3],
        [0.0; 3],
    ];
    assert!(matches!(
        repair(&mesh, &huge, &options),
        Err(RepairError::Size(_))
    ));
    let mut infinite = x;
    infinite[2][1] = f64::INFINITY;
    let error = repair(&mesh, &infinite, &options);
    assert!(
        matches!(
            error,
            Err(RepairError::Positions(PositionsError::NotFinite { .. }))
        ),
        "{error:?}"
    );
    let error = repair(&mesh, &x, &options.clone().with_pinned(vec![6]));
    assert_eq!(
        error,
        Err(RepairError::Pinned {
            vertex: 6,
            vertex_count: 6
        })
    );
    let none = Arc::new(TriangleMesh::new(0, Vec::new()).expect("there are no indices"));
    assert!(repair(&none, &[], &options).is_ok());
    // Flat faces, and vertices in one point.
    let flat = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.5, 0.0, 0.0],
        [0.5, 0.0, 0.0],
        [1.5, 0.0, 0.0],
    ];
    assert!(repair(&mesh, &flat, &options).is_ok());
}

#[test]
fn positions_in_single_precision_are_free_as_they_are_rounded() {
    // Far from the origin, where rounding to f32 is coarse.
    let body = joined([sphere(8, 0.3), boxed(2, 0.4).moved([0.03, 0.05, 0.07])]).moved([1000.3; 3]);
    for distance in [0.0, 1e-3] {
        let distance = Separation::new(distance).expect("it is finite");
        let options = RepairOptions::default().with_min_distance(distance);
        let repaired = match repair_in_f32(&body.mesh, &body.positions, &options).expect("they fit") {
            Outcome::Repaired(repaired) => repaired,
            Outcome::Unrepaired(unrepaired) => panic!("{}", unrepaired.reason),
        };
        let is_single = |x: &f64| f64::from(*x as f32).to_bits() == x.to_bits();
        assert!(repaired.positions.as_flattened().iter().all(is_single));
        assert!(repaired.crossings > 0);
        assert!(is_free(&body.mesh, &repaired.positions, distance));
    }
}

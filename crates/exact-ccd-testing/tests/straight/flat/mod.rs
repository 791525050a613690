//! Where primitives are flat, parallel and in touch, the filters agree with the exact path.

mod random;

use std::collections::BTreeSet;

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Impact, Kind, Point, Query, Stage, VertexFace};

use exact_ccd_testing::meshes::flat::{Scene, scenes};
use exact_ccd_testing::meshes::general::general_scenes;
use random::{Random, families};

/// The accuracy of parameters and normals that the documentation promises.
const ACCURACY: f64 = 1.0 / (1_u64 << 32) as f64;

fn is_near(a: &Impact, b: &Impact) -> bool {
    let pairs = a.parameters.into_iter().zip(b.parameters);
    let normals = a.normal.into_iter().flatten().zip(b.normal.into_iter().flatten());
    a.time == b.time
        && a.normal.is_some() == b.normal.is_some()
        && pairs.chain(normals).all(|(x, y)| (x - y).abs() <= ACCURACY)
}

/// Compares all answers to a query with the exact path, and returns the stage that decided.
fn checked_stage<K: Kind>(query: &Query<K>) -> Stage {
    let (collision, stage) = query.decide(CONTACT);
    let intervals = query.exactly().intervals(CONTACT);
    assert_eq!(
        collision.is_some(),
        query.exactly().collides(CONTACT),
        "{stage:?} {query:?}"
    );
    assert_eq!(query.intervals(CONTACT), intervals, "{stage:?} {query:?}");
    let first = intervals.first_time();
    assert_eq!(collision.map(|c| c.time()), first, "{stage:?} {query:?}");
    // The last time that counts may be next to the contact, or its time.
    let last = first.map_or(1.0, ContactTime::upper);
    for until in [1.0, last, last.next_down(), 0.5] {
        let options = CONTACT.until(until);
        assert_eq!(
            query.intervals(options),
            query.exactly().intervals(options),
            "{until} {query:?}"
        );
        match (query.impact(options), query.exactly().impact(options)) {
            (None, None) => {}
            (Some(a), Some(b)) if is_near(&a, &b) => {}
            (a, b) => panic!("{a:?}, exactly {b:?}: {until} {query:?}"),
        }
    }
    stage
}

/// Queries of pairs from two lists of primitives, if their boxes over the step meet: at most about `count`,
/// from all parts of the lists.
fn queries<K: Kind<Points = [Point; 4]>>(
    scene: &Scene,
    first: &[Vec<u32>],
    second: &[Vec<u32>],
    count: usize,
) -> Vec<Query<K>> {
    let sides = |vertices: &[u32], axis: usize| {
        let at = |end: &Vec<Point>, v: u32| end[v as usize][axis];
        let all = || {
            scene
                .ends
                .iter()
                .flat_map(|end| vertices.iter().map(move |&v| at(end, v)))
        };
        [all().fold(f64::MAX, f64::min), all().fold(f64::MIN, f64::max)]
    };
    let boxes = |all: &[Vec<u32>]| -> Vec<[[f64; 2]; 3]> {
        all.iter()
            .map(|vertices| [0, 1, 2].map(|axis: usize| sides(vertices, axis)))
            .collect()
    };
    let (a_boxes, b_boxes) = (boxes(first), boxes(second));
    let mut found = Vec::new();
    for (i, a) in first.iter().enumerate() {
        for (j, b) in second.iter().enumerate() {
            let overlap = (0..3).all(|axis| {
                let ([a_low, a_high], [b_low, b_high]) = (a_boxes[i][axis], b_boxes[j][axis]);
                a_low <= b_high && b_low <= a_high
            });
            let is_twin = std::ptr::eq(first, second) && j <= i;
            if overlap && !is_twin && a.iter().all(|v| !b.contains(v)) {
                let ids: Vec<u32> = a.iter().chain(b).copied().collect();
                let at = |end: &Vec<Point>| [0, 1, 2, 3].map(|k: usize| end[ids[k] as usize]);
                found.push(Query::new(at(&scene.ends[0]), at(&scene.ends[1])).unwrap());
            }
        }
    }
    let stride = found.len() / count + 1;
    found.into_iter().step_by(stride).collect()
}

/// The stages that decide the queries of a scene.
fn stages(scene: &Scene) -> Vec<Stage> {
    const COUNT: usize = 600;
    let vertices: Vec<_> = (0..scene.ends[0].len() as u32).map(|v| vec![v]).collect();
    let faces: Vec<_> = scene.faces.iter().map(|face| face.to_vec()).collect();
    let sides = |face: &[u32; 3]| [[face[0], face[1]], [face[1], face[2]], [face[2], face[0]]];
    let edges: BTreeSet<_> = scene
        .faces
        .iter()
        .flat_map(sides)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    let edges: Vec<_> = edges.into_iter().map(|edge| edge.to_vec()).collect();
    let by_face = queries::<VertexFace>(scene, &vertices, &faces, COUNT);
    let by_edge = queries::<EdgeEdge>(scene, &edges, &edges, COUNT);
    assert!(!by_face.is_empty() && !by_edge.is_empty(), "{}", scene.name);
    let by_face = by_face.iter().map(checked_stage);
    by_face.chain(by_edge.iter().map(checked_stage)).collect()
}

#[test]
fn scenes_are_decided_as_by_the_exact_path() {
    for scene in scenes(4) {
        stages(&scene);
    }
}

/// The numbers whose signs decide have few bits there.
#[test]
fn scenes_along_the_axes_do_not_need_the_exact_path() {
    for scene in scenes(4).into_iter().step_by(2) {
        assert!(!stages(&scene).contains(&Stage::Exact), "{}", scene.name);
    }
}

/// Coordinates have all bits. In the last scene, the sphere thrown through its centre, coordinates also
/// differ in size by many bits, and many cubics have roots closer together than the narrowest window.
#[test]
fn scenes_with_general_coordinates_hardly_need_the_exact_path() {
    let scenes = general_scenes(4);
    let (sphere, sheets) = scenes.split_last().unwrap();
    for (scene, parts) in sheets.iter().map(|sheets| (sheets, 1000)).chain([(sphere, 100)]) {
        let stages = stages(scene);
        let exact = stages.iter().filter(|stage| **stage == Stage::Exact).count();
        assert!(
            parts * exact <= stages.len(),
            "{}: {exact} of {}",
            scene.name,
            stages.len()
        );
    }
}

fn families_agree<K: Kind<Points = [Point; 4]>>() {
    const COUNT: usize = 1500;
    let mut settled = 0;
    for (name, family) in families() {
        let mut random = Random(1);
        let mut colliding = 0;
        for _ in 0..COUNT {
            let [start, end] = family(&mut random);
            let query = Query::<K>::new(start, end).unwrap();
            settled += usize::from(checked_stage(&query) == Stage::FixedWidth);
            colliding += usize::from(query.collides(CONTACT));
        }
        assert!(colliding > 0, "{name}");
    }
    assert!(settled > 100, "{settled}");
}

#[test]
fn a_vertex_and_a_face_are_decided_as_by_the_exact_path() {
    families_agree::<VertexFace>();
}

#[test]
fn two_edges_are_decided_as_by_the_exact_path() {
    families_agree::<EdgeEdge>();
}

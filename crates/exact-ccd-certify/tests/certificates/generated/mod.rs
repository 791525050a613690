//! Certificates of generated meshes, and of false statements about them.

mod mutations;

use crate::proof::{Scene, certify, verify};
use exact_ccd::{Options, Point, Separation};
use exact_ccd_check::Kind;
use exact_ccd_check::certificate::MAGIC;
use exact_ccd_check::check::Proved;
use exact_ccd_mesh::{
    AllPairs, Bvh, CandidateOptions, Candidates, Contact, MinDistance, Pair, PairKind, Step,
};

/// Numbers that look random and are the same everywhere.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn real(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// Triangles, a rod of two edges, and points. Each moves as a whole; its vertices deviate a little from
/// that motion.
fn scene(random: &mut Random, is_lattice: bool, is_flat: bool) -> Scene {
    let faces = [[0, 1, 2], [1, 2, 3], [4, 5, 6]];
    let edges = [[7, 8], [8, 9], [10, 11]];
    let mut coordinate = |scale: f64| {
        if is_lattice {
            random.below(7) as f64 - 3.0
        } else {
            scale * (random.real() - 0.5)
        }
    };
    let (mut x0, mut x1): (Vec<Point>, Vec<Point>) = Default::default();
    for group in [0..4, 4..7, 7..10, 10..12, 12..13, 13..14] {
        let place = [0; 3].map(|_| coordinate(6.0));
        let motion = [0; 3].map(|_| coordinate(6.0));
        for _ in group {
            let start = place.map(|x| x + coordinate(2.0));
            let mut end = [0, 1, 2].map(|axis: usize| start[axis] + motion[axis] + 0.25 * coordinate(1.0));
            let mut start = start;
            if is_flat {
                (start[2], end[2]) = (0.0, 0.0);
            }
            x0.push(start);
            x1.push(end);
        }
    }
    Scene::new(&faces, &edges, [x0, x1])
}

/// Two points of a lattice meet at the time 1 / (1 + `factor`).
fn let_points_meet(scene: &mut Scene, factor: f64) {
    let [start, end] = scene.frames.each_mut().map(|frame| &mut frame.positions);
    for axis in 0..3 {
        let apart = (axis + 1) as f64;
        start[13][axis] = start[12][axis] + apart;
        end[13][axis] = end[12][axis] - factor * apart;
    }
}

fn options(d: f64) -> CandidateOptions {
    CandidateOptions::default().with_min_distance(MinDistance::uniform(Separation::new(d).unwrap()))
}

/// The kind of a pair, as the checker names it.
fn kind(pair: Pair) -> Kind {
    match pair {
        Pair::VertexFace { .. } => Kind::VertexFace,
        Pair::EdgeEdge { .. } => Kind::EdgeEdge,
        Pair::VertexEdge { .. } => Kind::VertexEdge,
        Pair::VertexVertex { .. } => Kind::VertexVertex,
    }
}

/// All contacts, by the exact kernel on all pairs.
fn contacts(scene: &Scene, d: f64) -> Vec<Contact> {
    let [x0, x1] = scene.positions();
    let step = Step::new(&scene.mesh, x0, x1).unwrap();
    Candidates::with_options(step, &AllPairs, &options(d))
        .unwrap()
        .collisions(step, Options::within(Separation::new(d).unwrap()))
}

/// Returns true if all statements are true, by the exact kernel.
fn are_true(scene: &Scene, proved: &Proved) -> bool {
    let contacts = contacts(scene, proved.distance);
    proved.steps.iter().all(|step| {
        let crosses = || scene.is_pierced();
        let is_free = |until: f64| {
            contacts
                .iter()
                .all(|contact| !contact.impact.time.is_at_most(until))
        };
        let named = |pair: Pair| step.contact == Some((kind(pair), pair.ids()));
        let touches = |until: f64| {
            let mut contacts = contacts.iter().filter(|contact| named(contact.pair));
            contacts.any(|contact| contact.impact.time.is_at_most(until))
        };
        !(step.head.rest && crosses())
            && step.head.free.is_none_or(is_free)
            && step.head.contact.is_none_or(touches)
    })
}

#[test]
fn generated_meshes_have_certificates() {
    let mut random = Random(1);
    let mut counts = [[0; 2]; 2];
    let mut kinds = [0; 4];
    for round in 0..600 {
        let (is_lattice, is_flat, d) = (round % 2 == 1, round % 3 == 2, [0.0, 0.0, 0.125][round / 2 % 3]);
        let mut scene = scene(&mut random, is_lattice, is_flat);
        if round % 12 == 1 {
            let_points_meet(&mut scene, 1.0 + (round / 12 % 2) as f64);
        }
        let contact = scene.earliest(d);
        if let Some(contact) = &contact {
            kinds[kind(contact.pair) as usize] += 1;
        }
        match certify(&scene, d) {
            Ok(certificate) => {
                let proved = verify(&scene, &certificate).unwrap();
                assert!(are_true(&scene, &proved), "{proved}");
                assert_eq!(proved.steps[0].contact.is_some(), contact.is_some());
                counts[usize::from(is_lattice)][0] += 1;
            }
            Err(uncertified) => {
                println!("round {round}, lattice {is_lattice}, flat {is_flat}, d = {d}: {uncertified}");
                counts[usize::from(is_lattice)][1] += 1;
            }
        }
    }
    println!("certified and not, of reals and of a lattice: {counts:?}; contacts by kind {kinds:?}");
    assert_eq!(counts.map(|[_, missing]| missing), [0, 0]);
    assert!(kinds.iter().all(|&count| count > 0), "{kinds:?}");
}

#[test]
fn no_bytes_cause_a_panic() {
    let mut random = Random(9);
    let scene = scene(&mut random, false, false);
    for round in 0..20_000 {
        let mut bytes = if round % 2 == 0 {
            MAGIC.to_vec()
        } else {
            b"ply\nformat ascii 1.0\nelement ".to_vec()
        };
        let words = [
            "vertex 3\n",
            "face 1\n",
            "edge 2\n",
            "property float x\n",
            "property double y\n",
            "property float z\n",
            "property list uchar int vertex_indices\n",
            "property int vertex1\n",
            "end_header\n",
            "3 0 1 2\n",
            "-1 ",
            "1e400 ",
            "99999999999999999999 ",
            "\n",
            "nan ",
            "format binary_little_endian 1.0\n",
            "element ",
        ];
        for _ in 0..random.below(40) {
            if round % 4 == 1 {
                bytes.extend(words[random.below(words.len() as u64) as usize].as_bytes());
            } else {
                bytes.push(random.below(if round % 3 == 0 { 256 } else { 8 }) as u8);
            }
        }
        if let Ok(proved) = verify(&scene, &bytes) {
            assert!(are_true(&scene, &proved), "{proved}");
        }
        let _ = exact_ccd_check::ply::read(&bytes);
    }
}

#[test]
fn all_pairs_of_the_detector_are_pairs_of_the_checker() {
    let mut random = Random(10);
    for _ in 0..20 {
        let scene = scene(&mut random, true, false);
        let [x0, x1] = scene.positions();
        let step = Step::new(&scene.mesh, x0, x1).unwrap();
        let all = Candidates::with_options(step, &Bvh, &options(1e6)).unwrap();
        let ours: Vec<(Kind, [u32; 2])> = all.pairs().map(|pair| (kind(pair), pair.ids())).collect();
        let mesh = &scene.frames[0].mesh;
        let mut theirs = Vec::new();
        for kind in Kind::ALL.into_iter().take(4) {
            for a in 0..14 {
                theirs.extend(
                    (0..14)
                        .map(|b| [a, b])
                        .filter(|ids| mesh.pair(kind, ids).is_some())
                        .map(|ids| (kind, ids)),
                );
            }
        }
        assert_eq!(ours, theirs);
        for edge in 0..6 {
            for vertex in 0..14 {
                let ids = [vertex, edge];
                let pair = mesh.pair(Kind::VertexEdge, &ids);
                if let Some(pair) = pair {
                    let vertices: Vec<u32> = pair.vertices().collect();
                    let vertices: [u32; 3] = vertices.try_into().unwrap();
                    let are_connected = exact_ccd::VertexEdge::are_connected(&scene.mesh, &vertices);
                    assert_eq!(pair.has_distance, !are_connected);
                }
            }
        }
    }
}

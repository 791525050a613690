//! Certificates of generated meshes, and of false statements about them.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod mutations;
#[path = "../proof/mod.rs"]
mod proof;

use exact_ccd::{Options, Point, Separation};
use exact_ccd_check::certificate::MAGIC;
use exact_ccd_check::check::Proved;
use exact_ccd_mesh::{AllPairs, Bvh, CandidateOptions, Candidates, Contact, MinDistance, Pair, PairKind};
use proof::{Scene, certify, verify};

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

/// Triangles, a rod of two edges and points, of which each moves along, with a part of its own.
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

fn options(d: f64) -> CandidateOptions {
    CandidateOptions::default().with_min_distance(MinDistance::uniform(Separation::new(d).unwrap()))
}

/// All contacts, by the exact kernel on all pairs.
fn contacts(scene: &Scene, d: f64) -> Vec<Contact> {
    let motion = exact_ccd_mesh::Motion {
        mesh: scene.mesh.clone(),
        x0: scene.positions()[0].to_vec(),
        x1: scene.positions()[1].to_vec(),
    };
    let step = motion.step().unwrap();
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
        let named = |pair: Pair| match (pair, step.contact) {
            (pair, Some((kind, ids))) => {
                pair.ids() == ids && {
                    let names = match pair {
                        Pair::VertexFace { .. } => ["vertex", "face"],
                        Pair::EdgeEdge { .. } => ["edge", "edge"],
                        Pair::VertexEdge { .. } => ["vertex", "edge"],
                        Pair::VertexVertex { .. } => ["vertex", "vertex"],
                    };
                    kind.names() == names
                }
            }
            _ => false,
        };
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
        let scene = scene(&mut random, is_lattice, is_flat);
        let contact = scene.earliest(d);
        if let Some(contact) = &contact {
            kinds[match contact.pair {
                Pair::VertexFace { .. } => 0,
                Pair::EdgeEdge { .. } => 1,
                Pair::VertexEdge { .. } => 2,
                Pair::VertexVertex { .. } => 3,
            }] += 1;
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
    assert!(kinds[..2].iter().all(|&count| count > 0));
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
        let motion = exact_ccd_mesh::Motion {
            mesh: scene.mesh.clone(),
            x0: scene.positions()[0].to_vec(),
            x1: scene.positions()[1].to_vec(),
        };
        let all = Candidates::with_options(motion.step().unwrap(), &Bvh, &options(1e6)).unwrap();
        let ours: Vec<(usize, [u32; 2])> = all
            .pairs()
            .map(|pair| match pair {
                Pair::VertexFace { .. } => (0, pair.ids()),
                Pair::EdgeEdge { .. } => (1, pair.ids()),
                Pair::VertexEdge { .. } => (2, pair.ids()),
                Pair::VertexVertex { .. } => (3, pair.ids()),
            })
            .collect();
        let mesh = &scene.frames[0].mesh;
        let mut theirs = Vec::new();
        for (number, kind) in exact_ccd_check::Kind::ALL.into_iter().take(4).enumerate() {
            for a in 0..14 {
                theirs.extend(
                    (0..14)
                        .map(|b| [a, b])
                        .filter(|ids| mesh.pair(kind, ids).is_some())
                        .map(|ids| (number, ids)),
                );
            }
        }
        assert_eq!(ours, theirs);
        for edge in 0..6 {
            for vertex in 0..14 {
                let ids = [vertex, edge];
                let pair = mesh.pair(exact_ccd_check::Kind::VertexEdge, &ids);
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

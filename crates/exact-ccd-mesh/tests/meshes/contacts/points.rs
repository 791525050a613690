//! The points of contacts: as far apart as the primitives are.

use exact_ccd::{Options, Separation};
use exact_ccd_mesh::{Detector, MinDistance, Point, TriangleMesh, contact_points, step};
use fastrand::Rng;

use super::scene::Scene;

fn distance([p, q]: [Point; 2]) -> f64 {
    (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn points_of_contacts_are_at_the_distance_of_contact() {
    let mut random = Rng::with_seed(82);
    // By the number of vertices of both primitives.
    let mut kinds = std::collections::BTreeMap::new();
    for _ in 0..2000 {
        let (scene, scale) = Scene::mixed(&mut random);
        let d = scale * [0.0, 0.05][random.usize(..2)];
        let options = Options::within(MinDistance::from(Separation::new(d).unwrap()));
        let mut detector = Detector::new(scene.mesh.clone());
        let positions = [&scene.x0[..], &scene.x1];
        for contact in detector.collisions(&scene.x0, &scene.x1, options).unwrap() {
            let vertices = contact.pair.vertices(&scene.mesh).unwrap();
            let (first, second) = vertices.split_at(contact.pair.kind().sizes()[0]);
            let points = contact_points([first, second], positions, &contact.impact).unwrap();
            let found = distance(points);
            assert!(found <= d + 1e-8 * scale, "{contact:?} {found} {d}");
            if contact.impact.time.lower() > 0.0 {
                assert!(found >= d - 1e-8 * scale, "{contact:?} {found} {d}");
                *kinds.entry((first.len(), second.len(), d > 0.0)).or_insert(0) += 1;
            }
            assert_eq!(
                contact_points([first, second], [&positions[0][..1]; 2], &contact.impact),
                None
            );
            assert_eq!(contact_points([first, &[0; 4]], positions, &contact.impact), None);
        }
    }
    // Two vertices are rare, and the points are theirs.
    for kind in [
        (1, 3, false),
        (2, 2, false),
        (1, 3, true),
        (2, 2, true),
        (1, 2, true),
    ] {
        assert!(kinds.get(&kind) > Some(&10), "{kind:?} {kinds:?}");
    }
}

/// A point on a face, at other times than the middle and with three different weights; and two edges.
#[test]
fn points_of_contacts_are_means_by_the_weights() {
    let assert_at = |mesh: &TriangleMesh, x0: &[Point], x1: &[Point], expected: Point| {
        let contact = step(mesh, x0, x1).unwrap().earliest.unwrap();
        let vertices = contact.pair.vertices(mesh).unwrap();
        let (first, second) = vertices.split_at(contact.pair.kind().sizes()[0]);
        let points = contact_points([first, second], [x0, x1], &contact.impact).unwrap();
        for point in points {
            assert!(distance([point, expected]) < 1e-9, "{points:?} {expected:?}");
        }
    };
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let at = |x: f64, z: f64| [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [x, 4.0, z]];
    assert_at(&mesh, &at(0.5, 1.0), &at(2.5, -3.0), [1.0, 4.0, 0.0]);
    let mesh = TriangleMesh::with_edges(4, Vec::new(), &[[0, 1], [2, 3]]).unwrap();
    let at = |z: f64| [[-1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, -3.0, z], [0.0, 1.0, z]];
    assert_at(&mesh, &at(1.0), &at(-3.0), [0.0; 3]);
    let mesh = TriangleMesh::with_edges(3, Vec::new(), &[[0, 1]]).unwrap();
    let at = |z: f64| [[-1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, z]];
    assert_at(&mesh, &at(1.0), &at(-3.0), [0.0; 3]);
}

//! Certificates of the example of the README: the sheet that drapes onto a sphere.

use std::path::PathBuf;

use crate::proof::{Scene, certify, verify};
use exact_ccd_check::ply;

fn scene(end: &str) -> Scene {
    let file = |name: &str| -> PathBuf {
        [env!("CARGO_MANIFEST_DIR"), "../../examples", name]
            .iter()
            .collect()
    };
    Scene::of(["drape_start.ply", end].map(|name| ply::read(&std::fs::read(file(name)).unwrap()).unwrap()))
}

#[test]
fn the_example_has_a_certificate() {
    for (end, d) in [
        ("drape_free.ply", 0.0),
        ("drape_contact.ply", 0.0),
        ("drape_contact.ply", 0.001),
    ] {
        let scene = scene(end);
        let certificate = certify(&scene, d).unwrap();
        let proved = verify(&scene, &certificate).unwrap();
        let [step] = proved.steps[..] else {
            panic!("one step")
        };
        println!(
            "{end} {d}: {} bytes, {} pairs\n{proved}",
            certificate.len(),
            step.pairs
        );
        assert!(step.head.rest);
        assert_eq!(step.contact.is_some(), end == "drape_contact.ply");
        assert!(certificate.len() <= 8 * step.pairs + 1000);
    }
}

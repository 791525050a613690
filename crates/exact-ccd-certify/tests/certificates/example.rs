//! The certificate in docs/certificates.md, byte by byte.

use crate::proof::{Scene, certify, verify};
use exact_ccd_check::check;

#[test]
fn the_certificate_of_the_documentation() {
    let at = |z: f64| vec![[0.0, 0.0, 0.0], [8.0, 0.0, 8.0], [0.0, 8.0, 0.0], [1.0, 1.0, z]];
    let scene = Scene::new(&[[0, 1, 2]], &[], [at(4.0), at(0.0)]);
    let certificate = certify(&scene, 0.0).unwrap();
    let table = include_str!("../../../../docs/certificates.md")
        .split("| bytes | meaning |")
        .nth(1)
        .unwrap();
    let rows = table.lines().skip(3).take_while(|line| line.starts_with('|'));
    // All hexadecimal bytes of the first column, but for the first line of the certificate.
    let bytes = rows.flat_map(|row| {
        row.split('|')
            .nth(1)
            .unwrap()
            .split(['`', ' ', ','])
            .map(str::to_owned)
    });
    let bytes = bytes
        .filter(|word| !word.is_empty())
        .map(|word| u8::from_str_radix(&word, 16).unwrap());
    let expected: Vec<u8> = b"exact-ccd certificate 1\n"
        .iter()
        .copied()
        .chain(bytes)
        .collect();
    assert_eq!(certificate, expected);
    let proved = verify(&scene, &certificate).unwrap();
    assert_eq!(
        proved.to_string(),
        "step from frame 0 to frame 1 (pairs next to each other: 1):\n  \
         No edge pierces a face at t = 0.\n  \
         No two primitives that count are in contact at any time of [0, 0.7499999999999999].\n  \
         Then vertex 3 and face 0 are in contact, at a time after 0.7499999999999999 and not after 0.75.\n"
    );
    // Three frames have two steps.
    let [start, end] = scene.frames.clone();
    assert!(check(&certificate, [start, end.clone(), end].map(Ok)).is_err());
}

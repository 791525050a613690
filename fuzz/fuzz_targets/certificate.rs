//! Certificates: no bytes make the checker panic, and none prove a false statement.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::Separation;
use exact_ccd_check::{Mesh, check, ply::Frame};
use exact_ccd_fuzz::positions;
use exact_ccd_mesh::{Detector, Options, TriangleMesh};
use libfuzzer_sys::fuzz_target;

const MAGIC: &[u8] = b"exact-ccd certificate 1\n";
const FACES: [[u32; 3]; 2] = [[0, 1, 2], [3, 4, 5]];
const VERTICES: usize = 7;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no certificate.
    let _ = decide(Unstructured::new(bytes));
});

fn decide(mut bytes: Unstructured) -> Result<()> {
    let [x0, x1] = positions(&mut bytes, VERTICES)?;
    let d = f64::from(bytes.int_in_range(0..=2)?) / 2.0;
    let mesh = Mesh::new(VERTICES, FACES.to_vec(), &[]).expect("all vertices exist");
    let frame = |positions: &[_]| {
        Ok(Frame {
            mesh: mesh.clone(),
            positions: positions.to_vec(),
        })
    };
    let certificate = [MAGIC, &d.to_le_bytes(), bytes.take_rest()].concat();
    let Ok(proved) = check(&certificate, [frame(&x0), frame(&x1)]) else {
        return Ok(());
    };
    let mut detector =
        Detector::new(TriangleMesh::new(VERTICES, FACES.to_vec()).expect("all vertices exist"));
    let options = Options::within(Separation::new(d).expect("it is a distance"));
    for step in &proved.steps {
        let Some(until) = step.head.free else {
            continue;
        };
        let contact = detector
            .collision(&x0, &x1, options.until(until))
            .expect("the positions are finite");
        assert_eq!(contact, None, "{proved:?}: {x0:?}, {x1:?}");
    }
    Ok(())
}

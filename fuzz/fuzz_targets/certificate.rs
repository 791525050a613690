//! Certificates: no bytes make the checker panic, and none prove a false statement.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::Separation;
use exact_ccd_check::{Mesh, check, ply::Frame};
use exact_ccd_fuzz::positions;
use exact_ccd_mesh::{Bvh, Detector, IntersectionOptions, Meeting, Options, TriangleMesh, intersections};
use libfuzzer_sys::fuzz_target;

const MAGIC: &[u8] = b"exact-ccd certificate 1\n";
const FACES: [[u32; 3]; 2] = [[0, 1, 2], [3, 4, 5]];
const RODS: [[u32; 2]; 1] = [[6, 7]];
const VERTICES: usize = 9;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no certificate.
    let _ = decide(Unstructured::new(bytes));
});

fn decide(mut bytes: Unstructured) -> Result<()> {
    let [x0, x1] = positions(&mut bytes, VERTICES)?;
    let d = f64::from(bytes.int_in_range(0..=2)?) / 2.0;
    let mesh = Mesh::new(VERTICES, FACES.to_vec(), &RODS).expect("all vertices exist");
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
    let mesh = TriangleMesh::with_edges(VERTICES, FACES.to_vec(), &RODS).expect("all vertices exist");
    let mut detector = Detector::new(mesh);
    let options = Options::within(Separation::new(d).expect("it is a distance"));
    for step in &proved.steps {
        if let Some(until) = step.head.free {
            let collides = detector.collides(&x0, &x1, options.until(until));
            assert_eq!(collides, Ok(false), "{proved:?}: {x0:?}, {x1:?}");
        }
        if let Some(until) = step.head.contact {
            let collides = detector.collides(&x0, &x1, options.until(until));
            assert_eq!(collides, Ok(true), "{proved:?}: {x0:?}, {x1:?}");
        }
        if step.head.rest {
            let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
            let found = intersections(detector.mesh(), &x0, &Bvh, &crossing);
            assert_eq!(found, Ok(Vec::new()), "{proved:?}: {x0:?}, {x1:?}");
        }
    }
    Ok(())
}

//! Certificates: no bytes make the checker panic, and none prove a false statement.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::Separation;
use exact_ccd_check::{Kind, Mesh, check, ply::Frame};
use exact_ccd_fuzz::positions;
use exact_ccd_mesh::{
    Bvh, Detector, IntersectionOptions, Meeting, Options, Pair, TriangleMesh, intersections,
};
use libfuzzer_sys::fuzz_target;

const MAGIC: &[u8] = b"exact-ccd certificate 1\n";
const FACES: [[u32; 3]; 2] = [[0, 1, 2], [3, 4, 5]];
/// A rod and a loose vertex, or two connected rods.
const RODS: [&[[u32; 2]]; 2] = [&[[6, 7]], &[[6, 7], [7, 8]]];
const VERTICES: usize = 9;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no certificate.
    let _ = decide(Unstructured::new(bytes));
});

fn decide(mut bytes: Unstructured) -> Result<()> {
    let [x0, x1] = positions(&mut bytes, VERTICES)?;
    let halves = bytes.int_in_range(0..=2)?;
    let (d, rods) = (f64::from(halves) / 2.0, RODS[usize::from(halves == 2)]);
    let mesh = Mesh::new(VERTICES, FACES.to_vec(), rods).expect("all vertices exist");
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
    let mesh = TriangleMesh::with_edges(VERTICES, FACES.to_vec(), rods).expect("all vertices exist");
    let mut detector = Detector::new(mesh);
    let options = Options::within(Separation::new(d).expect("it is a distance"));
    for step in &proved.steps {
        if let Some(until) = step.head.free {
            let collides = detector.collides(&x0, &x1, options.until(until));
            assert_eq!(collides, Ok(false), "{proved:?}: {x0:?}, {x1:?}");
        }
        if let (Some(until), Some(named)) = (step.head.contact, step.contact) {
            let found = detector
                .collisions(&x0, &x1, options.until(until))
                .expect("they are positions");
            let is_found = found.iter().any(|contact| name(contact.pair) == named);
            assert!(is_found, "{proved:?}: {x0:?}, {x1:?}");
        }
        if step.head.rest {
            let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
            let found = intersections(detector.mesh(), &x0, &Bvh, &crossing);
            assert_eq!(found, Ok(Vec::new()), "{proved:?}: {x0:?}, {x1:?}");
        }
    }
    Ok(())
}

/// The name of a pair in certificates.
fn name(pair: Pair) -> (Kind, [u32; 2]) {
    let kind = match pair {
        Pair::VertexFace { .. } => Kind::VertexFace,
        Pair::EdgeEdge { .. } => Kind::EdgeEdge,
        Pair::VertexEdge { .. } => Kind::VertexEdge,
        Pair::VertexVertex { .. } => Kind::VertexVertex,
    };
    (kind, pair.ids())
}

//! Steps of meshes with faces, rods and points: the detector finds what every pair, tested alone, has; a
//! step that it certifies is free of contact.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::Separation;
use exact_ccd_fuzz::{coordinate, positions};
use exact_ccd_mesh::{
    AllPairs, Bvh, CandidateOptions, Candidates, Detector, FreeStepOptions, MinDistance, Options, Step,
    Sweep, TriangleMesh,
};
use libfuzzer_sys::fuzz_target;

const VERTICES: usize = 8;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no mesh.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let mut vertex = || bytes.int_in_range(0..=VERTICES as u32);
    let faces = [[(); 3]; 3].map(|face| face.map(|()| vertex().unwrap_or_default()));
    let edges = [[(); 2]; 2].map(|edge| edge.map(|()| vertex().unwrap_or_default()));
    let d = Separation::new(coordinate(bytes)?.abs()).unwrap_or(Separation::ZERO);
    let [x0, x1] = positions(bytes, VERTICES)?;
    // Faces with a vertex twice, and vertices that do not exist, are errors.
    let Ok(mesh) = TriangleMesh::with_edges(VERTICES, faces.to_vec(), &edges) else {
        return Ok(());
    };
    let Ok(step) = Step::new(&mesh, &x0, &x1) else {
        return Ok(());
    };
    let options = Options::within(d);
    let near = CandidateOptions::default().with_min_distance(MinDistance::from(d));
    let all = Candidates::with_options(step, &AllPairs, &near).expect("the options fit the mesh");
    let expected = all.collisions(step, options);
    for found in [
        Candidates::with_options(step, &Bvh, &near).map(|candidates| candidates.collisions(step, options)),
        Candidates::with_options(step, &Sweep, &near).map(|candidates| candidates.collisions(step, options)),
    ] {
        assert_eq!(
            found.expect("the options fit the mesh"),
            expected,
            "{step:?}, {d:?}"
        );
    }
    let mut detector = Detector::new(mesh.clone());
    let found = detector
        .collisions(&x0, &x1, options)
        .expect("the positions fit the mesh");
    assert_eq!(found, expected, "{step:?}, {d:?}");
    let first = detector
        .collision(&x0, &x1, options)
        .expect("the positions fit the mesh");
    assert_eq!(first.as_ref(), expected.first(), "{step:?}, {d:?}");

    let free = detector.free_step(&x0, &x1, &FreeStepOptions::default().with_min_distance(d));
    if let Ok(free) = free
        && free.size > 0.0
    {
        let contact = detector
            .collision(&x0, &free.positions, options)
            .expect("the positions fit the mesh");
        assert_eq!(contact, None, "{step:?}, {d:?}, {free:?}");
    }
    Ok(())
}

//! Steps of meshes with faces, rods and points: the detector finds the same contacts as a test of every pair
//! alone. A step that it certifies is free of contact.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::{CONTACT, Separation, Thickness};
use exact_ccd_fuzz::{coordinate, positions};
use exact_ccd_mesh::{
    AllPairs, Bvh, CanCollide, CandidateOptions, Candidates, Detector, FreeStepOptions, MinDistance, Options,
    Step, Sweep, TriangleMesh,
};
use libfuzzer_sys::fuzz_target;

/// Enough for several blocks of boxes.
const VERTICES: usize = 24;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no mesh.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let mut vertex = || bytes.int_in_range(0..=VERTICES as u32 - 1);
    let faces = [[(); 3]; 12].map(|face| face.map(|()| vertex().unwrap_or_default()));
    let edges = [[(); 2]; 4].map(|edge| edge.map(|()| vertex().unwrap_or_default()));
    let min_distance = min_distance(bytes)?;
    let until = [1.0, 0.5, coordinate(bytes)?.abs().min(1.0)][bytes.choose_index(3)?];
    let can_collide = if bytes.arbitrary()? {
        let groups: Result<Vec<u32>> = (0..VERTICES).map(|_| bytes.int_in_range(0..=2)).collect();
        CanCollide::different_groups(groups?)
    } else {
        CanCollide::all()
    };
    let [x0, x1] = positions(bytes, VERTICES)?;
    // Edges with a vertex twice are errors.
    let Ok(mesh) = TriangleMesh::with_edges(VERTICES, faces.to_vec(), &edges) else {
        return Ok(());
    };
    let Ok(step) = Step::new(&mesh, &x0, &x1) else {
        return Ok(());
    };
    let options = Options::within(min_distance.clone()).until(until);
    let near = CandidateOptions::default()
        .with_min_distance(min_distance.clone())
        .with_can_collide(can_collide.clone());
    let all = Candidates::with_options(step, &AllPairs, &near).expect("the options fit the mesh");
    let expected = all.collisions(step, options.clone());
    for found in [
        Candidates::with_options(step, &Bvh, &near),
        Candidates::with_options(step, &Sweep, &near),
    ] {
        let found = found.expect("the options fit the mesh");
        let found = found.collisions(step, options.clone());
        assert_eq!(found, expected, "{step:?}, {options:?}");
    }
    let mut detector = Detector::new(mesh.clone()).with_can_collide(can_collide);
    let found = detector.collisions(&x0, &x1, options.clone());
    assert_eq!(found.as_ref(), Ok(&expected), "{step:?}, {options:?}");
    let first = detector.collision(&x0, &x1, options.clone());
    assert_eq!(first, Ok(expected.first().copied()), "{step:?}, {options:?}");
    let any = detector.collides(&x0, &x1, options);
    assert_eq!(any, Ok(!expected.is_empty()), "{step:?}");

    let within = FreeStepOptions::default().with_min_distance(min_distance.clone());
    let options = Options::within(min_distance);
    let free = detector.free_step(&x0, &x1, &within).expect("the step is sound");
    if free.size > 0.0 {
        let collides = detector.collides(&x0, &free.positions, options.clone());
        assert_eq!(collides, Ok(false), "{step:?}, {options:?}, {free:?}");
    }
    let free = detector
        .free_steps(&x0, &x1, &[], &within)
        .expect("the step is sound");
    if free.blocked.is_empty() {
        let collides = detector.collides(&x0, &free.positions, options.clone());
        assert_eq!(collides, Ok(false), "{step:?}, {options:?}, {free:?}");
    }
    let far = Separation::new(4.0).expect("not negative");
    let clearances = detector.clearances(&x0, far).expect("the positions fit the mesh");
    if clearances.iter().all(|&clearance| clearance > 0.0) {
        assert_eq!(detector.collides(&x0, &x0, CONTACT), Ok(false), "{step:?}");
    }
    Ok(())
}

/// A distance, one for each vertex, or one with an inner distance.
fn min_distance(bytes: &mut Unstructured) -> Result<MinDistance> {
    let mut distance = || Ok(Separation::new(coordinate(bytes)?.abs()).unwrap_or(Separation::ZERO));
    let (d, inner): (Separation, Separation) = (distance()?, distance()?);
    let thin = Thickness::new(&[[d, inner].map(Separation::get); VERTICES / 2].concat());
    Ok(match (bytes.int_in_range(0..=3)?, thin) {
        (0, Ok(thickness)) => MinDistance::thickness(thickness),
        (1, _) => MinDistance::from(d).with_inner(inner),
        _ => MinDistance::from(d),
    })
}

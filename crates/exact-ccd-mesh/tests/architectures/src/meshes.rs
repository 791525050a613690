//! The answers to steps of meshes, on several threads.

use exact_ccd::Separation;
use exact_ccd_mesh::{
    Bvh, CONTACT, Contact, Detector, FreeStepOptions, IntersectionOptions, Options, Point, Step,
    TriangleMesh, intersections,
};

use exact_ccd_testing::hard_cases::digest::Digest;
use exact_ccd_testing::meshes::cloth::Cloth;

/// The numbers of threads: WebAssembly has one.
pub(crate) const THREADS: std::ops::RangeInclusive<usize> = if cfg!(target_family = "wasm") {
    1..=1
} else {
    1..=8
};

pub(crate) fn digest(threads: usize) -> u64 {
    if cfg!(target_family = "wasm") {
        return of_steps();
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_or(0, |pool| pool.install(of_steps))
}

fn of_steps() -> u64 {
    let mut digest = Digest::default();
    for nearest in [0.5, 0.1, -0.2] {
        let cloth = Cloth::new(9, nearest);
        let mesh = TriangleMesh::new(cloth.x0.len(), cloth.faces);
        let mesh = mesh.expect("all vertices of faces are there");
        let step = Step::new(&mesh, &cloth.x0, &cloth.x1);
        add_step(
            &mut digest,
            step.expect("there are as many positions as vertices, and all are finite"),
        );
    }
    digest.0
}

fn add_step(digest: &mut Digest, step: Step<'_>) {
    let [x0, x1] = step.positions();
    let mut detector = Detector::new(step.mesh().clone());
    add_contact(
        digest,
        detector.collision(x0, x1, CONTACT).unwrap_or_default().as_ref(),
    );
    for d in [0.0, 0.05] {
        let d = Separation::new(d).unwrap_or(Separation::ZERO);
        let contacts = detector
            .collisions(x0, x1, Options::within(d))
            .unwrap_or_default();
        digest.add(contacts.len() as u64);
        contacts
            .iter()
            .for_each(|contact| add_contact(digest, Some(contact)));
    }
    let options = FreeStepOptions::default();
    if let Ok(free) = detector.free_step(x0, x1, &options) {
        digest.add_number(free.size);
        add_positions(digest, &free.positions);
    }
    if let Ok(free) = detector.free_steps(x0, x1, &[], &options) {
        free.sizes.iter().for_each(|&size| digest.add_number(size));
        add_positions(digest, &free.positions);
        digest.add(free.rounds as u64);
    }
    let cut_off = Separation::new(0.5).unwrap_or(Separation::ZERO);
    let clearances = detector.clearances(x1, cut_off).unwrap_or_default();
    clearances.iter().for_each(|&x| digest.add_number(x));
    let met = intersections(step.mesh(), x1, &Bvh, &IntersectionOptions::default()).unwrap_or_default();
    digest.add(met.len() as u64);
}

fn add_contact(digest: &mut Digest, contact: Option<&Contact>) {
    digest.add(contact.is_some().into());
    if let Some(Contact {
        pair,
        impact,
        distance,
        ..
    }) = contact
    {
        pair.ids().into_iter().for_each(|id| digest.add(id.into()));
        digest.add_impact(Some(*impact));
        digest.add_number(distance.lower);
        digest.add_number(distance.upper);
    }
}

fn add_positions(digest: &mut Digest, positions: &[Point]) {
    positions
        .as_flattened()
        .iter()
        .for_each(|&x| digest.add_number(x));
}

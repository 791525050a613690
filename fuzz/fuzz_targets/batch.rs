//! Batches of all kinds: every set of vector instructions finds the collisions of single queries, in order.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::batch::{Instructions, Queries, Trajectories};
use exact_ccd::{AnyKind, ContactTime, Kind, Options, Query, Separation, with_kind};
use exact_ccd_fuzz::{coordinate, positions};
use libfuzzer_sys::fuzz_target;

const VERTICES: usize = 6;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no batch.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let d = Separation::new(coordinate(bytes)?.abs()).unwrap_or(Separation::ZERO);
    let until = f64::from(bytes.int_in_range(0..=9)?) / 8.0;
    let options = Options::within(d).until(until);
    let [x0, x1] = positions(bytes, VERTICES)?;
    let Ok(trajectories) = Trajectories::new(&x0, &x1) else {
        assert!(![x0, x1].concat().as_flattened().iter().all(|x| x.is_finite()));
        return Ok(());
    };
    let mut kinds = AnyKind::ALL.iter();
    kinds.try_for_each(|&kind| with_kind!(kind, K => check_kind::<K>(&trajectories, bytes, options)))
}

fn check_kind<K: Kind>(
    trajectories: &Trajectories,
    bytes: &mut Unstructured,
    options: Options,
) -> Result<()> {
    // More than the lanes of a vector, and more than one vector.
    let mut queries = vec![K::Vertices::default(); bytes.int_in_range(0..=20)?];
    for vertex in queries.iter_mut().flat_map(AsMut::as_mut) {
        *vertex = bytes.int_in_range(0..=VERTICES as u32 - 1)?;
    }
    let single: Vec<Query<K>> = queries
        .iter()
        .filter_map(|vertices| trajectories.query(*vertices))
        .collect();
    assert_eq!(single.len(), queries.len(), "all vertices exist");
    let expected: Vec<(usize, ContactTime)> = (single.iter().enumerate())
        .filter_map(|(index, query)| Some((index, query.collision(options)?.time())))
        .collect();
    let points: Vec<[K::Points; 2]> = single.iter().map(|query| *query.points()).collect();
    for instructions in Instructions::available() {
        let mut found = Vec::new();
        let batch = trajectories.clone().with_instructions(instructions);
        let done = batch.collisions::<K>(&queries, options, |index, collision| {
            found.push((index, collision.time()));
        });
        done.expect("all vertices exist");
        assert_eq!(found, expected, "{instructions:?}, {options:?}: {single:?}");

        let mut found = Vec::new();
        let batch = Queries::<K>::new(&points).with_instructions(instructions);
        let done = batch.collisions(options, |index, collision| found.push((index, collision.time())));
        done.expect("all coordinates are finite");
        assert_eq!(found, expected, "{instructions:?}, {options:?}: {single:?}");
    }
    Ok(())
}

//! Curved motion: straight lines get the answers of exact queries, and no motion makes a panic.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::{ContactTime, EdgeEdge, Query, Separation, VertexFace};
use exact_ccd_curved::{Answer, Polynomial, SearchOptions, Trajectory, time_of_impact};
use exact_ccd_fuzz::{coordinate, positions};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no motion.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let d = Separation::new(coordinate(bytes)?.abs()).unwrap_or(Separation::ZERO);
    let options = SearchOptions::default()
        .with_time_tolerance(1e-3)
        .with_chord_limit(200);
    let [x0, x1] = positions(bytes, 4)?;
    let [middle, _] = positions(bytes, 4)?;
    let curves = [0, 1, 2, 3].map(|i: usize| Polynomial::new([x0[i], middle[i], x1[i]]));
    let curves = curves.each_ref().map(|curve| curve as &dyn Trajectory);
    for answer in [
        time_of_impact::<VertexFace, _>(&curves, d, &options),
        time_of_impact::<EdgeEdge, _>(&curves, d, &options),
    ]
    .into_iter()
    .flatten()
    {
        assert_ordered(&answer);
    }

    let lines = [0, 1, 2, 3].map(|i: usize| Polynomial::new([x0[i], x1[i]]));
    let lines = lines.each_ref().map(|line| line as &dyn Trajectory);
    let four = |x: &[_]| [x[0], x[1], x[2], x[3]];
    if let Ok(query) = Query::<VertexFace>::new(four(&x0), four(&x1))
        && let Ok(answer) = time_of_impact::<VertexFace, _>(&lines, d, &options)
    {
        assert_exact(&answer, query.collision(d).map(|collision| collision.time()));
    }
    if let Ok(query) = Query::<EdgeEdge>::new(four(&x0), four(&x1))
        && let Ok(answer) = time_of_impact::<EdgeEdge, _>(&lines, d, &options)
    {
        assert_exact(&answer, query.collision(d).map(|collision| collision.time()));
    }
    Ok(())
}

fn assert_ordered(answer: &Answer) {
    assert!((0.0..=1.0).contains(&answer.free_until), "{answer:?}");
    assert!(
        answer.within.is_none_or(|within| answer.free_until <= within.by),
        "{answer:?}"
    );
}

/// Checks that the free times of an answer are free by the exact query, and that its contact is one.
fn assert_exact(answer: &Answer, first: Option<ContactTime>) {
    assert_ordered(answer);
    match first {
        Some(first) => assert!(
            !answer.is_free()
                && answer.free_until <= first.upper()
                && answer.within.is_none_or(|within| first.lower() <= within.by),
            "{answer:?}, {first:?}"
        ),
        None => assert_eq!(answer.within, None, "{answer:?}"),
    }
}

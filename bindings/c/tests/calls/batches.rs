//! Batches: the times are the same as for single queries.

use arbitrary::{Result, Unstructured};
use exact_ccd_c::{
    Kind, exact_ccd_batch_time_of_impact, exact_ccd_batch_time_of_impact_thick, exact_ccd_time_of_impact,
};

use super::{input, succeeds};

const UNWRITTEN: f64 = -7.0;

pub(super) fn check(bytes: &mut Unstructured<'_>) -> Result<()> {
    let (kind, points) = input::kind(bytes)?;
    let vertices = bytes.int_in_range(0..=8)?;
    let (x0, x1) = (input::points(bytes, vertices)?, input::points(bytes, vertices)?);
    let count = bytes.int_in_range(0..=6)?;
    let queries = input::indices(bytes, points * count, vertices)?;
    let d = input::distance(bytes)?;
    let mut times = vec![UNWRITTEN; count];
    // SAFETY: the arrays have the lengths that are passed on, or are null.
    let status = unsafe {
        let (x0, x1) = (input::pointer(bytes, &x0)?, input::pointer(bytes, &x1)?);
        let queries = input::pointer(bytes, &queries)?;
        exact_ccd_batch_time_of_impact(
            kind,
            x0,
            x1,
            vertices,
            queries,
            count,
            d,
            1.0,
            0,
            times.as_mut_ptr(),
        )
    };
    if succeeds(status) {
        for (query, time) in queries.chunks(points).zip(&times) {
            assert_eq!(
                single(kind, &x0, &x1, query, d).to_bits(),
                time.to_bits(),
                "{query:?}"
            );
        }
    } else {
        assert!(times.iter().all(|&time| time == UNWRITTEN));
    }

    let thickness: Vec<f64> = (0..vertices)
        .map(|_| input::distance(bytes))
        .collect::<Result<_>>()?;
    times.fill(UNWRITTEN);
    // SAFETY: the arrays have the lengths that are passed on.
    let status = unsafe {
        let (x0, x1, thickness) = (x0.as_ptr(), x1.as_ptr(), thickness.as_ptr());
        let queries = queries.as_ptr();
        exact_ccd_batch_time_of_impact_thick(
            kind,
            x0,
            x1,
            vertices,
            queries,
            count,
            thickness,
            1.0,
            0,
            times.as_mut_ptr(),
        )
    };
    if succeeds(status) {
        for (query, time) in queries.chunks(points).zip(&times) {
            let first = if kind == Kind::EdgeEdge as u32 { 2 } else { 1 };
            let thickest = |vertices: &[u32]| {
                let thicknesses = vertices.iter().map(|&vertex| thickness[vertex as usize]);
                thicknesses.fold(0.0, f64::max)
            };
            let (a, b) = query.split_at(first);
            let d = sum_rounded_up(thickest(a), thickest(b));
            assert_eq!(
                single(kind, &x0, &x1, query, d).to_bits(),
                time.to_bits(),
                "{query:?}"
            );
        }
    }
    Ok(())
}

/// The least f64 that is not below the sum of two numbers of at least 0.
fn sum_rounded_up(a: f64, b: f64) -> f64 {
    let (large, small) = (a.max(b), a.min(b));
    let sum = large + small;
    // Exact, because `sum` is near `large` or both are multiples of the same small number (Dekker 1971).
    if sum - large < small { sum.next_up() } else { sum }
}

/// The time of one query of a batch that has one.
fn single(kind: u32, x0: &[f64], x1: &[f64], query: &[u32], d: f64) -> f64 {
    let points = |x: &[f64]| -> Vec<f64> {
        let point = |&vertex: &u32| x[3 * vertex as usize..][..3].iter().copied();
        query.iter().flat_map(point).collect()
    };
    let (t0, t1) = (points(x0), points(x1));
    let mut time = 0.0;
    // SAFETY: the arrays have the points of the kind.
    let status = unsafe { exact_ccd_time_of_impact(kind, t0.as_ptr(), t1.as_ptr(), d, 1.0, &raw mut time) };
    assert!(succeeds(status));
    time
}

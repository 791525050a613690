//! Many queries about the same vertices.

use core::mem::MaybeUninit;

use exact_ccd::batch::Trajectories;
use exact_ccd::{Kind, Options, Separations, Thickness, with_kind};
use rayon::prelude::*;

use crate::border::call;
use crate::error::{Error, Status};
use crate::kind::query_kind;
use crate::pointers::{array, ends, places};
use crate::query::options;
use crate::threads::Threads;

/// The number of queries that a thread answers at a time.
const GRAIN: usize = 4096;

/// `exact_ccd_time_of_impact` of each of `query_count` queries.
///
/// `x0` and `x1` are the positions of `vertex_count` vertices at t = 0 and t = 1. `vertices` has the
/// indices of the vertices of each query, as many as the kind has points, in its order. `separation`
/// and `until` are as in `exact_ccd_collides`. `threads` is the number of threads of this call: from 1
/// to 1024, or 0 for the number that `exact_ccd_set_threads` has set. `times` has room for
/// `query_count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_batch_time_of_impact(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    vertices: *const u32,
    query_count: usize,
    separation: f64,
    until: f64,
    threads: u32,
    times: *mut f64,
) -> Status {
    call(|| {
        let options = options(separation, until)?.into();
        let threads = Threads::new(threads)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let trajectories = trajectories(x0, x1, vertex_count)?;
            let times = places("times", times, query_count)?;
            with_kind!(query_kind(kind)?, K => {
                let vertices = array("vertices", vertices.cast::<<K as Kind>::Vertices>(), query_count)?;
                threads.run(|| first_times::<K>(&trajectories, vertices, options, times))
            })
        }
    })
}

/// `exact_ccd_batch_time_of_impact` for vertices of different thickness: a number for each of the
/// `vertex_count` vertices. A primitive has the largest thickness of its vertices. The separation of a query
/// is the sum of its two thicknesses, rounded up.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_batch_time_of_impact_thick(
    kind: u32,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    vertices: *const u32,
    query_count: usize,
    thickness: *const f64,
    until: f64,
    threads: u32,
    times: *mut f64,
) -> Status {
    call(|| {
        let Options { until, .. } = options(0.0, until)?;
        let threads = Threads::new(threads)?;
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let thickness = Thickness::new(array("thickness", thickness, vertex_count)?)?;
            let options = Options::from(&thickness).until(until);
            let trajectories = trajectories(x0, x1, vertex_count)?;
            let times = places("times", times, query_count)?;
            with_kind!(query_kind(kind)?, K => {
                let vertices = array("vertices", vertices.cast::<<K as Kind>::Vertices>(), query_count)?;
                threads.run(|| first_times::<K>(&trajectories, vertices, options, times))
            })
        }
    })
}

/// # Safety
/// As for [`ends`].
unsafe fn trajectories(x0: *const f64, x1: *const f64, count: usize) -> Result<Trajectories, Error> {
    // SAFETY: the caller's promise.
    let [x0, x1] = unsafe { ends(x0, x1, count)? };
    Ok(Trajectories::new(x0, x1)?)
}

/// Writes the times after all queries have been answered, and none if one of them is wrong.
fn first_times<K: Kind + Send + Sync>(
    trajectories: &Trajectories,
    queries: &[K::Vertices],
    options: Options<Separations<'_>>,
    times: &mut [MaybeUninit<f64>],
) -> Result<(), Error> {
    let answer = |(chunk, queries): (usize, &[K::Vertices])| {
        let first = chunk * GRAIN;
        let mut found = Vec::new();
        let answered = trajectories.collisions::<K>(queries, options, |index, collision| {
            found.push((first + index, collision.time_of_impact()));
        });
        answered.map_err(|error| Error::of_batch(error, first))?;
        Ok(found)
    };
    let chunks = queries.par_chunks(GRAIN).enumerate();
    let found: Vec<Result<Vec<_>, Error>> = chunks.map(answer).collect();
    // The first error in the list belongs to the first wrong query.
    let found = found.into_iter().collect::<Result<Vec<_>, Error>>()?;
    times.fill(MaybeUninit::new(f64::NAN));
    for (index, time) in found.into_iter().flatten() {
        times[index].write(time);
    }
    Ok(())
}

//! The answers to the queries of a file: for each 26 little-endian f64, which are the kind (0 for a vertex
//! and a face, 1 for two edges), the distance, and the coordinates of the four points at t = 0 and at t =
//! 1.
//!
//! The example `raw_queries` of `exact-ccd-bench` writes such files of the published queries.

use std::fs;
use std::io;

use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexFace};

use crate::kernel::{add_answers, add_stage};
use exact_ccd_testing::hard_cases::digest::Digest;

const BYTES: usize = 26 * size_of::<f64>();

pub(crate) fn digest(path: &str) -> io::Result<u64> {
    let file = fs::read(path)?;
    let mut digest = Digest::default();
    for record in file.chunks_exact(BYTES) {
        let mut numbers = record
            .chunks_exact(size_of::<f64>())
            .map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap_or_default()));
        let mut next = || numbers.next().unwrap_or_default();
        let (kind, d) = (next(), Separation::new(next()).unwrap_or(Separation::ZERO));
        let mut points = [[Point::default(); 4]; 2];
        points.as_flattened_mut().as_flattened_mut().fill_with(next);
        if kind == 0.0 {
            add_query::<VertexFace>(&mut digest, points, d);
        } else {
            add_query::<EdgeEdge>(&mut digest, points, d);
        }
    }
    Ok(digest.0)
}

fn add_query<K: Kind<Points = [Point; 4]>>(
    digest: &mut Digest,
    [start, end]: [[Point; 4]; 2],
    d: Separation,
) {
    if let Ok(query) = Query::<K>::new(start, end) {
        add_stage(digest, &query, d);
        add_answers(digest, &query, d);
    }
}

//! The hard cases as a Parquet file, with their exact answers.
//!
//! `cargo run --release -p exact-ccd-bench --example hard_cases -- OUT.parquet [COUNT]`
//!
//! COUNT queries of each family and kind are about contact, and as many about a distance; 40 is the
//! default. The integers of `Query::exactly` compute the answers. Before a row is written, an independent
//! implementation of the definition, in rational arithmetic, has to find the same. docs/hard-cases.md
//! describes the columns.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod table;

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

use exact_ccd::{EdgeEdge, Point, VertexEdge, VertexFace, VertexVertex};
use rayon::prelude::*;

use exact_ccd_testing::definition;
use exact_ccd_testing::hard_cases::hard::Hard;
use exact_ccd_testing::hard_cases::{Case, cases};
use table::Row;

const COUNT: usize = 40;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("expected the name of the file to write")?;
    let count = arguments.next().map_or(Ok(COUNT), |count| count.parse())?;
    let rows = [
        rows::<VertexFace>(count)?,
        rows::<EdgeEdge>(count)?,
        rows::<VertexEdge>(count)?,
        rows::<VertexVertex>(count)?,
    ]
    .concat();
    table::write(BufWriter::new(File::create(&path)?), &rows)?;
    println!(
        "{} queries, {} of them collide",
        rows.len(),
        rows.iter().filter(|row| row.collides()).count()
    );
    Ok(())
}

/// The rows of a kind, each compared with the definition.
fn rows<K: Hard>(count: usize) -> Result<Vec<Row>, String> {
    let cases: Vec<Case<K>> = cases(count).collect();
    cases.par_iter().map(row).collect()
}

fn row<K: Hard>(case: &Case<K>) -> Result<Row, String> {
    let Case {
        class,
        query,
        distance,
    } = case;
    let [start, end]: [Vec<Point>; 2] = query.points().map(|now| now.as_ref().to_vec());
    let times = query.exactly().intervals(*distance);
    let defined = definition::intervals(K::KIND, [&start, &end], distance.get());
    if definition::found(&times) != defined {
        return Err(format!(
            "{class}: {times:?}, but by definition {defined:?}: {query:?}, {distance:?}"
        ));
    }
    Ok(Row {
        kind: K::NAME,
        class,
        points: [start, end],
        distance: distance.get(),
        first: times.first_time(),
        intervals: times.len(),
        count: times.count(),
    })
}

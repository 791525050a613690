//! The published queries as raw numbers, for programs that read nothing else.
//!
//! `cargo run --release -p exact-ccd-bench --example raw_queries -- OUT`
//!
//! Each query is 26 little-endian f64: the kind (0 for a vertex and a face, 1 for two edges), the distance
//! 0, and the coordinates of the four points at t = 0 and at t = 1.

use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use exact_ccd::{EdgeEdge, Query, VertexFace};
use exact_ccd_data::{DataFolder, DataKind, QueryReader, Rounding};

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args()
        .nth(1)
        .ok_or("expected the name of the file to write")?;
    let data = DataFolder::find(Path::new(REPOSITORY))?;
    let mut file = BufWriter::new(File::create(path)?);
    write_kind::<VertexFace>(&mut file, &data, 0.0)?;
    write_kind::<EdgeEdge>(&mut file, &data, 1.0)?;
    Ok(file.flush()?)
}

fn write_kind<K: DataKind>(
    file: &mut impl Write,
    data: &DataFolder,
    kind: f64,
) -> Result<(), Box<dyn Error>> {
    for path in data.handcrafted::<K>()? {
        for record in QueryReader::<K, _>::open(&path, Rounding::Refuse)? {
            write_query(file, &record?.sample.query, kind)?;
        }
    }
    for scene in data.scenes()? {
        let motion = scene.motion()?;
        let step = motion.step()?;
        for sample in scene.samples::<K>(&step)? {
            write_query(file, &sample.query, kind)?;
        }
    }
    Ok(())
}

fn write_query<K: DataKind>(file: &mut impl Write, query: &Query<K>, kind: f64) -> std::io::Result<()> {
    let coordinates = query
        .points()
        .iter()
        .flat_map(|now| now.as_ref().as_flattened().iter().copied());
    let numbers = [kind, 0.0].into_iter().chain(coordinates);
    numbers
        .into_iter()
        .try_for_each(|x| file.write_all(&x.to_le_bytes()))
}

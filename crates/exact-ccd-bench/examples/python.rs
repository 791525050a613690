//! The seconds of the calls in Rust that `bindings/python/benchmarks/speed.py` compares the package with.
//!
//! Arguments: a folder of `indices` (u32), `x0`, `x1` (f64) and `faces` (u32), raw, and the number of runs.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use exact_ccd::batch::{Queries, Trajectories};
use exact_ccd::{CONTACT, EdgeEdge};
use exact_ccd_bench::fastest;
use exact_ccd_mesh::{Detector, TriangleMesh};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    let [_, folder, runs] = &arguments[..] else {
        return Err("expected a folder and the number of runs".into());
    };
    let (folder, runs) = (Path::new(folder), runs.parse()?);
    let indices: Vec<[u32; 4]> = rows(&folder.join("indices"), u32::from_le_bytes)?;
    let x0 = rows(&folder.join("x0"), f64::from_le_bytes)?;
    let x1 = rows(&folder.join("x1"), f64::from_le_bytes)?;
    let faces = rows(&folder.join("faces"), u32::from_le_bytes)?;
    let at = |x: &[[f64; 3]], query: &[u32; 4]| query.map(|vertex| x[vertex as usize]);
    let points: Vec<_> = indices
        .iter()
        .map(|query| [at(&x0, query), at(&x1, query)])
        .collect();
    let mut detector = Detector::new(TriangleMesh::new(x0.len(), faces)?);

    let by_indices = fastest(runs, || {
        let mut answers = vec![false; indices.len()];
        let trajectories = Trajectories::new(&x0, &x1).expect("the positions are finite");
        let found = trajectories.collisions::<EdgeEdge>(&indices, CONTACT, |index, _| answers[index] = true);
        found.expect("the vertices exist");
        answers
    });
    let by_points = fastest(runs, || {
        let mut answers = vec![false; indices.len()];
        let found = Queries::<EdgeEdge>::new(&points).collisions(CONTACT, |index, _| answers[index] = true);
        found.expect("the points are finite");
        answers
    });
    let earliest = fastest(runs, || {
        detector
            .collision(&x0, &x1, CONTACT)
            .expect("the positions are finite")
    });
    let table =
        format!("{{\"indices\": {by_indices}, \"points\": {by_points}, \"earliest_contact\": {earliest}}}\n");
    std::io::Write::write_all(&mut std::io::stdout(), table.as_bytes())?;
    Ok(())
}

/// The rows of `M` numbers in a file.
fn rows<T: Copy, const N: usize, const M: usize>(
    file: &Path,
    of: fn([u8; N]) -> T,
) -> Result<Vec<[T; M]>, std::io::Error> {
    let bytes = fs::read(file)?;
    let numbers: Vec<T> = bytes.as_chunks().0.iter().map(|&bytes| of(bytes)).collect();
    Ok(numbers.as_chunks().0.to_vec())
}

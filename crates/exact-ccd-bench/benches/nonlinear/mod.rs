//! The published queries of curved motion.

use std::fs;
use std::path::Path;

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{Kind, Point};
use exact_ccd_data::{DataError, DataFolder};
use serde::Deserialize;

/// A line of a file.
#[derive(Deserialize)]
pub(super) struct Line {
    pub(super) kind: String,
    #[serde(flatten)]
    motion: Motion,
    /// The number of contact times; −1 for infinitely many.
    #[allow(dead_code, reason = "the benchmark has no need of it")]
    pub(super) count: i64,
    #[allow(dead_code, reason = "the benchmark has no need of it")]
    pub(super) toi: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Motion {
    Bodies {
        first: Vec<Rigid>,
        second: Vec<Rigid>,
        points: [Point; 4],
    },
    Bezier {
        points: [Vec<Point>; 4],
    },
}

#[derive(Deserialize)]
struct Rigid {
    q0: [f64; 4],
    q1: [f64; 4],
    o0: Point,
    o1: Point,
}

/// A file: its name without extension, and its lines.
pub(super) type File = (String, Vec<Line>);

/// The files of the data folder, in order.
pub(super) fn files() -> Result<Vec<File>, DataError> {
    let folder = DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")))?;
    Ok(folder.nonlinear()?.iter().map(|path| file(path)).collect())
}

fn file(path: &Path) -> File {
    let name = path
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    let text = fs::read_to_string(path).unwrap_or_default();
    let line = |(index, line): (usize, &str)| {
        serde_json::from_str(line).unwrap_or_else(|error| panic!("line {} of {name}: {error}", index + 1))
    };
    (name.clone(), text.lines().enumerate().map(line).collect())
}

fn chain(motions: &[Rigid]) -> Chain {
    let motion = |m: &Rigid| RigidMotion::new([m.q0, m.q1], &[m.o0, m.o1]).expect("a motion");
    Chain::new(motions.iter().map(motion)).expect("a short chain")
}

/// The query of a line.
pub(super) fn query<K: Kind<Points = [Point; 4]>>(line: &Line) -> CurvedQuery<K> {
    match &line.motion {
        Motion::Bodies {
            first,
            second,
            points,
        } => CurvedQuery::of_bodies(*points, chain(first), chain(second)).expect("finite points"),
        Motion::Bezier { points } => {
            let set = |i: usize| [0, 1, 2, 3].map(|point: usize| points[point][i]);
            let control: Vec<_> = (0..points[0].len()).map(set).collect();
            Bezier::new(&control).expect("finite points").into()
        }
    }
}

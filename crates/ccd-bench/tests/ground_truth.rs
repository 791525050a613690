//! The published data sets, with symbolic ground truth that no one on this project made.
//!
//! Without the data folder these tests say so and pass.

use std::path::Path;

use ccd_bench::{DataFolder, DataKind, QueryReader, Rounding, Sample, Scene, read_roots};
use exact_ccd::{ContactTimes, PointTriangle, Query, SegmentSegment, exact};

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn data() -> Option<DataFolder> {
    DataFolder::find(Path::new(REPOSITORY))
        .inspect_err(|error| eprintln!("skipped, there is no data: {error}"))
        .ok()
}

fn scenes() -> Vec<Scene> {
    data().map_or(Vec::new(), |data| data.scenes().unwrap())
}

/// Where the decision differs from the truth.
fn mismatches<K: DataKind>(samples: &[Sample<K>], decide: impl Fn(&Query<K>) -> bool) -> Vec<usize> {
    let differs = |index: &usize| Some(decide(&samples[*index].query)) != samples[*index].truth;
    (0..samples.len()).filter(differs).collect()
}

fn read_all<K: DataKind>(file: &Path) -> Vec<Sample<K>> {
    QueryReader::open(file, Rounding::Refuse)
        .unwrap()
        .collect::<Result<_, _>>()
        .unwrap()
}

fn handcrafted<K: DataKind>(queries: usize) {
    let Some(data) = data() else { return };
    let mut count = 0;
    for file in data.handcrafted::<K>().unwrap() {
        let samples = read_all::<K>(&file);
        assert_eq!(
            mismatches(&samples, Query::collides),
            [0; 0],
            "{}",
            file.display()
        );
        assert_eq!(
            mismatches(&samples, exact::collides),
            [0; 0],
            "exactly, {}",
            file.display()
        );
        count += samples.len();
    }
    assert_eq!(count, queries);
}

#[test]
fn handcrafted_vertex_face_queries_agree() {
    handcrafted::<PointTriangle>(1750);
}

#[test]
fn handcrafted_edge_edge_queries_agree() {
    handcrafted::<SegmentSegment>(1574);
}

#[test]
fn all_pairs_of_the_scenes_agree() {
    let scenes = scenes();
    if scenes.is_empty() {
        return;
    }
    let mut count = 0;
    for scene in scenes {
        let motion = scene.motion().unwrap();
        let faces = scene.samples::<PointTriangle>(&motion).unwrap();
        let edges = scene.samples::<SegmentSegment>(&motion).unwrap();
        assert_eq!(
            mismatches(&faces, Query::collides),
            [0; 0],
            "{}, vertex-face",
            scene.name()
        );
        assert_eq!(
            mismatches(&edges, Query::collides),
            [0; 0],
            "{}, edge-edge",
            scene.name()
        );
        count += faces.len() + edges.len();
    }
    assert_eq!(count, 119_385);
}

#[test]
fn published_coordinates_equal_the_rebuilt_ones() {
    fn compare<K: DataKind>(scene: &Scene) {
        let Some(file) = scene.queries::<K>().unwrap() else {
            return;
        };
        let published = read_all::<K>(&file);
        let rebuilt = scene.samples::<K>(&scene.motion().unwrap()).unwrap();
        assert_eq!(published.len(), rebuilt.len());
        for (index, (a, b)) in published.iter().zip(&rebuilt).enumerate() {
            assert_eq!(
                a.query.points(),
                b.query.points(),
                "query {index} of {}",
                file.display()
            );
        }
    }
    for scene in scenes() {
        compare::<PointTriangle>(&scene);
        compare::<SegmentSegment>(&scene);
    }
}

#[test]
fn contact_times_equal_the_symbolic_roots_bit_for_bit() {
    fn compare<K: DataKind>(scene: &Scene) {
        let Some(file) = scene.roots::<K>().unwrap() else {
            return;
        };
        let samples = scene.samples::<K>(&scene.motion().unwrap()).unwrap();
        let roots = read_roots(&file).unwrap();
        assert_eq!(
            roots.len(),
            samples.iter().filter(|sample| sample.truth == Some(true)).count()
        );
        for root in roots {
            let place = format!("query {} of {}", root.query, file.display());
            let times = samples[root.query].query.contact_times();
            let first = times.first().unwrap_or_else(|| panic!("no contact in {place}"));
            assert_eq!(first.lower().to_bits(), root.toi.to_bits(), "{place}");
            assert_eq!(first.is_exact(), root.toi_is_exact, "{place}");
            match times {
                ContactTimes::Finite(times) => {
                    let bits = |times: Vec<f64>| times.into_iter().map(f64::to_bits).collect::<Vec<_>>();
                    let lower = times.iter().map(|time| time.lower()).collect();
                    assert_eq!(times.len(), root.count, "{place}");
                    assert_eq!(bits(lower), bits(root.times), "{place}");
                }
                ContactTimes::Interval { .. } => assert_eq!(root.count, 1, "{place}"),
            }
        }
    }
    for scene in scenes() {
        compare::<PointTriangle>(&scene);
        compare::<SegmentSegment>(&scene);
    }
}

//! Decisions and contact times against the symbolic ground truth.

use std::path::Path;

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Intervals, Query, VertexFace};
use exact_ccd_data::{DataKind, QueryReader, RecordedStep, Roots, Rounding, Sample, read_roots};
use exact_ccd_mesh::Step;

use crate::{data, scenes};

/// The queries whose decision differs from the truth.
fn mismatches<K: DataKind>(samples: &[Sample<K>], decide: impl Fn(&Query<K>) -> bool) -> Vec<usize> {
    let differs = |index: &usize| Some(decide(&samples[*index].query)) != samples[*index].truth;
    (0..samples.len()).filter(differs).collect()
}

fn read_all<K: DataKind>(file: &Path) -> Vec<Sample<K>> {
    QueryReader::<K, _>::open(file, Rounding::Refuse)
        .unwrap()
        .map(|record| record.unwrap().sample)
        .collect()
}

fn handcrafted<K: DataKind>(queries: usize) {
    let mut count = 0;
    for file in data().handcrafted::<K>().unwrap() {
        let samples = read_all::<K>(&file);
        assert_eq!(
            mismatches(&samples, |query| query.collides(CONTACT)),
            [0; 0],
            "{}",
            file.display()
        );
        assert_eq!(
            mismatches(&samples, |query| query.exactly().collides(CONTACT)),
            [0; 0],
            "exactly, {}",
            file.display()
        );
        count += samples.len();
    }
    assert_eq!(count, queries);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn handcrafted_vertex_face_queries_agree() {
    handcrafted::<VertexFace>(1750);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn handcrafted_edge_edge_queries_agree() {
    handcrafted::<EdgeEdge>(1574);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn all_pairs_of_the_scenes_agree() {
    fn check<K: DataKind>(scene: &RecordedStep, step: &Step<'_>) -> usize {
        let samples = scene.samples::<K>(step).unwrap();
        let place = format!("{}, {}", scene.name(), K::FOLDER);
        assert_eq!(
            mismatches(&samples, |query| query.collides(CONTACT)),
            [0; 0],
            "{place}"
        );
        samples.len()
    }
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        check::<VertexFace>(&scene, &step) + check::<EdgeEdge>(&scene, &step)
    });
    assert_eq!(counts.sum::<usize>(), 119_385);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn published_coordinates_equal_the_rebuilt_ones() {
    fn compare<K: DataKind>(scene: &RecordedStep, step: &Step<'_>) -> usize {
        let Some(file) = scene.queries::<K>().unwrap() else {
            return 0;
        };
        let points = |samples: &[Sample<K>]| samples.iter().map(|sample| *sample.query.points()).collect();
        let published: Vec<_> = points(&read_all(&file));
        let rebuilt: Vec<_> = points(&scene.samples(step).unwrap());
        assert_eq!(published, rebuilt, "{}", file.display());
        published.len()
    }
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        compare::<VertexFace>(&scene, &step) + compare::<EdgeEdge>(&scene, &step)
    });
    assert_eq!(counts.sum::<usize>(), 5_526);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn contact_times_equal_the_symbolic_roots_bit_for_bit() {
    fn compare<K: DataKind>(scene: &RecordedStep, step: &Step<'_>) -> usize {
        let Some(file) = scene.roots::<K>().unwrap() else {
            return 0;
        };
        let samples = scene.samples::<K>(step).unwrap();
        let roots = read_roots(&file).unwrap();
        let colliding = |index: &usize| samples[*index].truth == Some(true);
        assert_eq!(
            roots.iter().map(|root| root.query).collect::<Vec<_>>(),
            (0..samples.len()).filter(colliding).collect::<Vec<_>>(),
            "{}",
            file.display()
        );
        for root in &roots {
            let query = &samples[root.query].query;
            let place = format!("query {} of {}", root.query, file.display());
            assert_same_times(&query.intervals(CONTACT), root, &place);
            assert_same_times(
                &query.exactly().intervals(CONTACT),
                root,
                &format!("exactly, {place}"),
            );
        }
        roots.len()
    }
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        compare::<VertexFace>(&scene, &step) + compare::<EdgeEdge>(&scene, &step)
    });
    assert_eq!(counts.sum::<usize>(), 5_078);
}

fn assert_same_times(times: &Intervals, root: &Roots, place: &str) {
    let bits = |times: &[f64]| times.iter().map(|time| time.to_bits()).collect::<Vec<_>>();
    // The files have only the first time of an interval.
    let listed = times.iter().take(times.count().unwrap_or(1));
    let lower: Vec<f64> = listed.map(|interval| interval.start.lower()).collect();
    assert_eq!(bits(&lower), bits(&root.times), "{place}");
    assert_eq!(lower.len(), root.count, "{place}");
    assert_eq!(lower[0].to_bits(), root.toi.to_bits(), "{place}");
    assert_eq!(
        times.first_time().map(ContactTime::is_exact),
        Some(root.toi_is_exact),
        "{place}"
    );
}

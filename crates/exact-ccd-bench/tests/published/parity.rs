//! Root parity on the published queries: the parity by the definition of contact, and the false negatives.

use exact_ccd::{CONTACT, EdgeEdge, Query, VertexFace};
use exact_ccd_data::{DataKind, QueryReader, RecordedStep, Rounding, Sample};
use exact_ccd_mesh::Step;
use exact_ccd_methods::parity::{self, Parity, Rounded};
use rayon::prelude::*;

use crate::{data, scenes};
use exact_ccd_testing::parity::{Rim, expected};

fn rounded<K: DataKind>(query: &Query<K>) -> Rounded<K> {
    Rounded::shift(query).unwrap()
}

/// The rounded queries whose parity differs from the parity in integers or of the exact contacts.
fn exceptions<K: DataKind + Rim>(samples: &[Sample<K>]) -> Vec<usize> {
    let is_exception = |index: &usize| {
        let rounded = rounded(&samples[*index].query);
        let (parity, query) = (rounded.parity(), rounded.query());
        parity != parity::rational(query) || parity != expected(query)
    };
    (0..samples.len()).into_par_iter().filter(is_exception).collect()
}

fn handcrafted<K: DataKind>() -> Vec<Sample<K>> {
    let files = data().handcrafted::<K>().unwrap().into_iter();
    let records = files.flat_map(|file| QueryReader::<K, _>::open(&file, Rounding::Refuse).unwrap());
    records.map(|record| record.unwrap().sample).collect()
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn of_handcrafted_queries_is_as_defined() {
    let (faces, edges) = (handcrafted::<VertexFace>(), handcrafted::<EdgeEdge>());
    assert_eq!((faces.len(), edges.len()), (1750, 1574));
    assert_eq!(exceptions(&faces), [0; 0]);
    assert_eq!(exceptions(&edges), [0; 0]);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn of_all_pairs_of_the_scenes_is_as_defined() {
    fn check<K: DataKind + Rim>(scene: &RecordedStep, step: &Step<'_>) -> usize {
        let samples = scene.samples::<K>(step).unwrap();
        assert_eq!(exceptions(&samples), [0; 0], "{}, {}", scene.name(), K::FOLDER);
        samples.len()
    }
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        check::<VertexFace>(&scene, &step) + check::<EdgeEdge>(&scene, &step)
    });
    assert_eq!(counts.sum::<usize>(), 119_385);
}

/// The number of colliding queries, and the numbers of colliding queries that parity and the exact
/// decision report as free.
type Misses = [usize; 3];

/// The rounding of the shift changes no parity here.
fn misses<K: DataKind>(scene: &RecordedStep, step: &Step<'_>) -> Misses {
    let mut misses = [0; 3];
    for Sample { query, truth } in scene.samples::<K>(step).unwrap() {
        let parity = rounded(&query).parity();
        assert_eq!(parity, parity::rational(&query), "{query:?}");
        let is_odd = query
            .intervals(CONTACT)
            .count()
            .is_some_and(|count| count % 2 == 1);
        assert_eq!(
            parity.is_collision(),
            is_odd || parity == Parity::Boundary,
            "{query:?}"
        );
        if truth == Some(true) {
            misses[0] += 1;
            misses[1] += usize::from(!parity.is_collision());
            misses[2] += usize::from(!query.collides(CONTACT));
        } else {
            assert_eq!(parity, Parity::Even, "{query:?}");
        }
    }
    misses
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn misses_two_contacts() {
    let found = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        let faces = misses::<VertexFace>(&scene, &step);
        (scene.name(), faces, misses::<EdgeEdge>(&scene, &step))
    });
    let expected = [
        ("cloth-ball", [19_032, 288, 0], [94_822, 2_517, 0]),
        ("cloth-funnel", [27, 0, 0], [107, 1, 0]),
        ("rod-twist", [765, 441, 0], [4_179, 2_797, 0]),
    ];
    let expected = expected.map(|(name, faces, edges)| (name.to_owned(), faces, edges));
    assert_eq!(found.collect::<Vec<_>>(), expected);
}

/// Rounding changes the parity of degenerate queries. The two counts of each kind are the queries
/// that collide only after the shift, and only before it.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn depends_on_rounding_where_queries_are_degenerate() {
    fn count<K: DataKind>() -> [usize; 2] {
        let mut counts = [0; 2];
        for Sample { query, .. } in handcrafted::<K>() {
            let parities = [parity::rational(&query), rounded(&query).parity()];
            match parities.map(Parity::is_collision) {
                [false, true] => counts[0] += 1,
                [true, false] => counts[1] += 1,
                _ => {}
            }
        }
        counts
    }
    assert_eq!(count::<VertexFace>(), [31, 1]);
    assert_eq!(count::<EdgeEdge>(), [46, 3]);
}

//! Batches answer as single queries do, on all instruction sets of this machine.

use exact_ccd::batch::{Instructions, Trajectories};
use exact_ccd::{CONTACT, EdgeEdge, Query, VertexFace};
use exact_ccd_data::{DataKind, QueryReader, Rounding};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, Point, Step};

use crate::{data, scenes};

/// The indices of the queries that collide, one by one.
fn one_by_one<K: DataKind>(queries: impl Iterator<Item = Query<K>>) -> Vec<usize> {
    queries
        .enumerate()
        .filter(|(_, query)| query.collides(CONTACT))
        .map(|(index, _)| index)
        .collect()
}

fn assert_batches_find<K: DataKind>(
    trajectories: &Trajectories,
    vertices: &[[u32; 4]],
    expected: &[usize],
    name: &str,
) {
    for instructions in Instructions::available() {
        let trajectories = trajectories.clone().with_instructions(instructions);
        let mut found = Vec::new();
        trajectories
            .collisions::<K>(vertices, CONTACT, |index, _| found.push(index))
            .unwrap();
        assert_eq!(found, expected, "{name} {} {instructions:?}", K::KIND.short());
    }
}

fn check_scene<K: DataKind>(step: &Step<'_>, candidates: &Candidates, name: &str) {
    let [x0, x1] = step.positions();
    let trajectories = Trajectories::new(x0, x1).unwrap();
    let pairs = candidates.of_kind(K::KIND);
    let vertices: Vec<_> = pairs
        .iter()
        .filter_map(|&pair| K::vertices(step.mesh(), pair))
        .collect();
    let expected = one_by_one(pairs.iter().filter_map(|&pair| step.query::<K>(pair)));
    assert!(!expected.is_empty());
    assert_batches_find::<K>(&trajectories, &vertices, &expected, name);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn all_candidates_of_the_scenes() {
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        let options = CandidateOptions::default().with_boxes(BoxKind::Swept);
        let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
        check_scene::<VertexFace>(&step, &candidates, &scene.name());
        check_scene::<EdgeEdge>(&step, &candidates, &scene.name());
    }
}

/// Each query has four vertices of its own.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn all_handcrafted_queries() {
    fn check<K: DataKind>() {
        let mut queries = Vec::new();
        for file in data().handcrafted::<K>().unwrap() {
            for record in QueryReader::<K, _>::open(&file, Rounding::Refuse).unwrap() {
                queries.push(record.unwrap().sample.query);
            }
        }
        let at =
            |time: usize| -> Vec<Point> { queries.iter().flat_map(|query| query.points()[time]).collect() };
        let trajectories = Trajectories::new(&at(0), &at(1)).unwrap();
        let vertices: Vec<_> = (0..queries.len() as u32)
            .map(|query| [0, 1, 2, 3].map(|point| 4 * query + point))
            .collect();
        let expected = one_by_one(queries.iter().copied());
        assert!(!expected.is_empty());
        assert_batches_find::<K>(&trajectories, &vertices, &expected, "handcrafted");
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

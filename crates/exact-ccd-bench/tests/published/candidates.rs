//! The broad phase on the scenes.

use exact_ccd::{AnyKind, EdgeEdge, VertexFace};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, Motion};

use crate::scenes;

/// The candidates by boxes around the paths, as the published ones were found.
fn swept(motion: &Motion) -> Candidates {
    let options = CandidateOptions::default().with_boxes(BoxKind::Swept);
    Candidates::with_options(motion.step().unwrap(), &Bvh, &options).unwrap()
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn there_are_as_many_candidates_as_overlapping_boxes() {
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let counts = swept(&motion).counts();
        (
            scene.name(),
            counts[AnyKind::VertexFace],
            counts[AnyKind::EdgeEdge],
        )
    });
    let expected = [
        ("cloth-ball", 1_655_541, 5_197_332),
        ("cloth-funnel", 7_319, 33_770),
        ("rod-twist", 448_270, 2_041_334),
    ];
    let expected = expected.map(|(name, vertex_face, edge_edge)| (name.to_owned(), vertex_face, edge_edge));
    assert_eq!(counts.collect::<Vec<_>>(), expected);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_published_pairs_are_candidates() {
    fn others(published: Vec<[u32; 2]>, candidates: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let is_other = |pair: &[u32; 2]| candidates.binary_search(pair).is_err();
        published.into_iter().filter(is_other).collect()
    }
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        let candidates = swept(&motion);
        let faces = scene.pairs::<VertexFace>(&motion.mesh).unwrap();
        let edges = scene.pairs::<EdgeEdge>(&motion.mesh).unwrap();
        assert_eq!(
            others(faces, candidates.of_kind(AnyKind::VertexFace)),
            [[0; 2]; 0],
            "{}",
            scene.name()
        );
        assert_eq!(
            others(edges, candidates.of_kind(AnyKind::EdgeEdge)),
            [[0; 2]; 0],
            "{}",
            scene.name()
        );
    }
}

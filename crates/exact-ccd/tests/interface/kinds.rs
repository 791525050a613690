//! The list of the kinds.

use std::collections::BTreeSet;

use exact_ccd::{AnyKind, EdgeEdge, Kind, Query, VertexEdge, VertexFace, VertexVertex, with_kind};

/// The kind of the type, the number of its points, and the number of points of its first primitive.
fn described<K: Kind>() -> (AnyKind, usize, usize) {
    let points = K::Points::default();
    let count = points.as_ref().len();
    assert!(Query::<K>::new(points, points).is_ok());
    let vertices: Vec<u32> = (0..2 * count as u32 + 1).collect();
    let queries: Vec<&[u32]> = K::queries(&vertices).iter().map(AsRef::as_ref).collect();
    assert_eq!(queries, [&vertices[..count], &vertices[count..2 * count]]);
    (K::KIND, count, K::FIRST)
}

#[test]
fn each_kind_of_the_list_is_that_of_its_type() {
    let counts = AnyKind::ALL.iter().map(|&kind| {
        let (same, count, first) = with_kind!(kind, K => described::<K>());
        assert_eq!((same, kind.point_names().len()), (kind, count));
        assert_eq!(kind.sizes(), [first, count - first]);
        (count, first)
    });
    assert_eq!(counts.collect::<Vec<_>>(), [(4, 1), (4, 2), (3, 1), (2, 1)]);
    let of_types = [
        VertexFace::KIND,
        EdgeEdge::KIND,
        VertexEdge::KIND,
        VertexVertex::KIND,
    ];
    assert_eq!(AnyKind::ALL, of_types);
}

#[test]
fn names_of_kinds_and_of_their_points_differ() {
    let all = AnyKind::ALL.iter();
    let names: BTreeSet<&str> = all.clone().flat_map(|kind| [kind.name(), kind.short()]).collect();
    assert_eq!(names.len(), 2 * AnyKind::ALL.len());
    for kind in all {
        let points: BTreeSet<&&str> = kind.point_names().iter().collect();
        assert_eq!(points.len(), kind.point_names().len(), "{kind:?}");
    }
}

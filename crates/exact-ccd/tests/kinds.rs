//! The list of the kinds.

use std::collections::BTreeSet;

use exact_ccd::{AnyKind, EdgeEdge, Kind, Query, VertexEdge, VertexFace, VertexVertex, WithKind};

/// The kind of the type, the number of its points, and the number of points of its first primitive.
struct Described;

impl WithKind for Described {
    type Output = (AnyKind, usize, usize);

    fn with<K: Kind>(self) -> Self::Output {
        let points = K::Points::default();
        assert_eq!(points.as_ref().len(), K::Vertices::default().as_ref().len());
        assert!(Query::<K>::new(points, points).is_ok());
        (K::KIND, points.as_ref().len(), K::FIRST)
    }
}

#[test]
fn each_kind_of_the_list_is_that_of_its_type() {
    let counts = AnyKind::ALL.iter().map(|&kind| {
        let (same, count, first) = kind.with(Described);
        assert_eq!((same, kind.point_names().len()), (kind, count));
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

//! Query files.

use exact_ccd::{Kind, Point, Query};
use exact_ccd_data::{DataKind, QueryReader, Rounding, write_query};

use crate::folder::Folder;

/// The rows of a query whose coordinates are all multiples of 1/8. Each row ends with this text.
pub(crate) fn rows<K: Kind>(query: &Query<K>, ending: &str) -> String {
    let points = query.points().iter().flat_map(AsRef::as_ref);
    points.map(|point| row(point) + ending + "\n").collect()
}

fn row(point: &Point) -> String {
    let fraction = |x: &f64| {
        let numerator = 8.0 * x;
        assert_eq!(numerator.fract(), 0.0);
        format!("{numerator},8")
    };
    point.iter().map(fraction).collect::<Vec<_>>().join(",")
}

/// A query file of any queries.
pub(crate) fn file<K: Kind>(queries: &[Query<K>]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for query in queries {
        write_query(&mut bytes, query).unwrap();
    }
    bytes
}

/// The points of the queries in a file, which must have no ground truth.
pub(crate) fn points_in<K: DataKind>(folder: &Folder, name: &str) -> Vec<[[Point; 4]; 2]> {
    QueryReader::<K, _>::open(&folder.path(name), Rounding::Refuse)
        .unwrap()
        .map(|record| record.unwrap().sample)
        .inspect(|sample| assert_eq!(sample.truth, None))
        .map(|sample| *sample.query.points())
        .collect()
}

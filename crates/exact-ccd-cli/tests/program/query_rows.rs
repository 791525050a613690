//! Query files.

use exact_ccd::{Kind, Point, Query};

/// The rows of a query whose coordinates are all multiples of 1/8. Each row has this at its end.
pub(crate) fn rows<K: Kind>(query: &Query<K>, ending: &str) -> String {
    let points = query.points().as_flattened();
    points.iter().map(|point| row(point) + ending + "\n").collect()
}

fn row(point: &Point) -> String {
    let fraction = |x: &f64| {
        let numerator = 8.0 * x;
        assert_eq!(numerator.fract(), 0.0);
        format!("{numerator},8")
    };
    point.iter().map(fraction).collect::<Vec<_>>().join(",")
}

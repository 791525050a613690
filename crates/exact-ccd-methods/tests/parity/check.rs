//! A query is accepted without rounding if all its corner differences are exactly f64, and only then.

use dashu_int::ops::{BitTest, UnsignedAbs};
use exact_ccd::{Axis, EdgeEdge, VertexFace};
use exact_ccd_methods::parity::{Rounded, RoundingError};
use proptest::prelude::*;

use crate::corners::Corners;
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::integers::exactly;
use exact_ccd_testing::primitives::{Points, Primitives};
use exact_ccd_testing::runner::for_all;

/// Returns true if x − y is an f64: it has at most 53 bits, and is less than 2¹⁰²⁴.
fn is_exact(x: f64, y: f64) -> bool {
    let difference = (exactly(x) - exactly(y)).unsigned_abs();
    let bits = difference.bit_len() - difference.trailing_zeros().unwrap_or(0);
    bits <= 53 && difference.bit_len() <= 1024 + 1074
}

/// The error for the first inexact difference, if there is one.
fn expected_error<K: Corners>(points: &Points) -> Option<RoundingError> {
    for (time, now) in points.iter().enumerate() {
        for &points in K::DIFFERENCES {
            let [x, y] = points.map(|i| now[i]);
            if let Some(axis) = Axis::ALL
                .iter()
                .copied()
                .find(|axis| !is_exact(x[axis.index()], y[axis.index()]))
            {
                return Some(RoundingError::Inexact { time, points, axis });
            }
        }
    }
    None
}

fn refuses_inexact_differences<K: Corners + Primitives>() {
    let points = prop_oneof![
        2 => small_integers(2),
        2 => fractions(),
        2 => few_values(),
        2 => stretched(small_integers(8)),
        2 => nearly(exact_contacts::<K>(small_integers(8))),
        2 => scattered(small_integers(1)),
        1 => extremes(),
    ];
    for_all(20_000, points, |points| {
        let error = Rounded::check(query::<K>(&points)).err();
        assert_eq!(error, expected_error::<K>(&points), "{points:?}");
    });
}

#[test]
fn refuses_inexact_differences_of_a_vertex_and_a_face() {
    refuses_inexact_differences::<VertexFace>();
}

#[test]
fn refuses_inexact_differences_of_edges() {
    refuses_inexact_differences::<EdgeEdge>();
}

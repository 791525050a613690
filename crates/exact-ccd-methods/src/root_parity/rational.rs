//! The method in rational arithmetic.

use std::cmp::Ordering;

use dashu_ratio::Relaxed;
use exact_ccd::{Ccd, Decide, Guarantees, Query, TimeGuarantee};

use super::fold;
use super::image::{Image, Predicate, Solid, Vectors, differences, vectors};
use super::number::Number;
use super::ray::cast;

/// Root parity in rational arithmetic: the method of [`BrochuRootParity`](super::BrochuRootParity),
/// without its filters and with the degenerate cases settled, on the input as it is.
///
/// It is the reference that B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider
/// compare with in *Fast and Exact Root Parity for Continuous Collision Detection*, Computer
/// Graphics Forum 41(2), 2022. Their code fails after eight random rays, reports no contact if
/// all points have the same displacement, and splits a flat face into triangles that may differ
/// from it. Here, at least one of 49 fixed rays is valid, and a flat face covers exactly its
/// points.
///
/// # When it fails
/// An even number of contacts in the interior of the domain, counted with multiplicity, is a false
/// negative: 2797 of the 4179 colliding pairs of edges in the scene rod-twist. A contact on the
/// boundary, at t = 0 or t = 1, with an edge of the face or an end of an edge, is always reported.
/// There are no false positives.
#[derive(Clone, Copy, Debug, Default)]
pub struct RationalRootParity;

impl Image for Vectors<Relaxed> {
    fn sign(&self, predicate: Predicate) -> Ordering {
        predicate.value(self).certain_sign().unwrap_or(Ordering::Equal)
    }

    fn flat_patch_contains_origin(&self, patch: [usize; 4]) -> bool {
        fold::contains_origin(patch.map(|corner| &self[corner]))
    }
}

/// The largest number of directions (1, k, k²) that a query rejects.
///
/// A direction is rejected if it is in a plane with the origin and two corners of one face: an edge
/// or a diagonal, of which a hexahedron has 24. A plane through the origin contains two of the
/// directions at most.
const MOST_REJECTED: u32 = 2 * 24;

impl<K: Solid> Decide<K> for RationalRootParity {
    fn collides(&self, query: &Query<K>) -> bool {
        let collides = (0..=MOST_REJECTED).map(f64::from).find_map(|k| {
            let image: Vectors<Relaxed> = vectors(&differences(query, [1.0, k, k * k]));
            cast(&image, K::DOMAIN.faces)
        });
        collides.unwrap_or(true)
    }
}

impl Ccd for RationalRootParity {
    fn name(&self) -> &'static str {
        "RRP"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: true,
            false_positives: false,
            time: TimeGuarantee::Absent,
        }
    }
}

//! Hard cases: queries of all kinds with a distance, from families that have one difficulty each, with
//! fixed seeds.
//!
//! They are the same on every machine. docs/hard-cases.md describes the families.

mod close;
pub mod coincident;
pub mod digest;
mod distances;
pub mod extremes;
pub mod hard;
pub mod random;

use exact_ccd::{Query, Separation};

use crate::kinds::points_of;
use crate::primitives::Points;
use hard::Hard;
use random::Random;

/// A generator of queries of one family, as four points at both ends of the step.
pub type Family = fn(&mut Random) -> Points;

/// A hard case.
pub struct Case<K: Hard> {
    /// The name of the family.
    pub class: &'static str,
    /// The query.
    pub query: Query<K>,
    /// The distance at which the primitives touch.
    pub distance: Separation,
}

/// The families of a kind of query, by name.
pub fn families<K: Hard>() -> impl Iterator<Item = (&'static str, Family)> {
    (close::families::<K>().into_iter())
        .chain(extremes::families::<K>())
        .chain(coincident::FAMILIES)
}

/// A number of queries of a family; those with a coordinate that is not finite are left out.
pub fn queries<K: Hard>(family: Family, count: usize) -> impl Iterator<Item = Query<K>> {
    let mut random = Random(1);
    (0..count).filter_map(move |_| {
        let [start, end] = family(&mut random).map(points_of::<K>);
        Query::new(start, end).ok()
    })
}

/// The cases of a kind: a number of queries of each family for contact, and as many for a distance.
pub fn cases<K: Hard>(count: usize) -> impl Iterator<Item = Case<K>> {
    families::<K>().flat_map(move |(class, family)| {
        let mut random = Random(2);
        let contact = queries::<K>(family, count).map(move |query| Case {
            class,
            query,
            distance: Separation::ZERO,
        });
        let within = queries::<K>(family, 2 * count)
            .skip(count)
            .map(move |query| Case {
                class,
                query,
                distance: distances::distance(&query, &mut random),
            });
        contact.chain(within)
    })
}

//! Hard cases: queries of all kinds with a distance, from families that have one difficulty each, with
//! fixed seeds.
//!
//! They are the same on every machine. The root of a program with this module has the module `primitives`
//! of the test target `queries`. docs/hard-cases.md describes the families.

#[path = "../queries/generators/alphabet.rs"]
mod alphabet;
#[path = "../queries/generators/changes.rs"]
mod changes;
mod close;
pub(crate) mod coincident;
#[path = "../queries/generators/contacts.rs"]
mod contacts;
pub(crate) mod digest;
mod distances;
pub(crate) mod extremes;
pub(crate) mod hard;
mod random;

use exact_ccd::{Point, Query, Separation};

use crate::primitives::Points;
use hard::Hard;
use random::Random;

/// A generator of queries of one family, as four points at both ends of the step.
pub(crate) type Family = fn(&mut Random) -> Points;

/// A hard case.
pub(crate) struct Case<K: Hard> {
    /// The name of the family.
    pub(crate) class: &'static str,
    pub(crate) query: Query<K>,
    /// The distance at which the primitives touch.
    pub(crate) distance: Separation,
}

/// The families of a kind of query, by name.
pub(crate) fn families<K: Hard>() -> impl Iterator<Item = (&'static str, Family)> {
    (close::families::<K>().into_iter())
        .chain(extremes::families::<K>())
        .chain(coincident::FAMILIES)
}

/// A number of queries of a family; those with a coordinate that is not finite are left out.
pub(crate) fn queries<K: Hard>(family: Family, count: usize) -> impl Iterator<Item = Query<K>> {
    let mut random = Random(1);
    (0..count).filter_map(move |_| {
        let [start, end] = family(&mut random).map(points_of::<K>);
        Query::new(start, end).ok()
    })
}

/// The points of a query among four: the first primitive takes the first ones, the second primitive the last.
fn points_of<K: Hard>(four: [Point; 4]) -> K::Points {
    let mut points = K::Points::default();
    let (first, second) = points.as_mut().split_at_mut(K::FIRST);
    first.copy_from_slice(&four[..first.len()]);
    second.copy_from_slice(&four[4 - second.len()..]);
    points
}

/// The cases of a kind: a number of queries of each family for contact, and as many for a distance.
pub(crate) fn cases<K: Hard>(count: usize) -> impl Iterator<Item = Case<K>> {
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

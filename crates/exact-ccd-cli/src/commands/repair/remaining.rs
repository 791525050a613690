//! The pairs that are not free after a repair.

use std::fmt;

use exact_ccd_mesh::{Intersection, Pair, TriangleMesh};
use serde::Serialize;

use crate::assembly::Assembly;
use crate::contacts::ContactRecord;

/// The number of pairs that a text names.
const NAMED: usize = 5;

/// The first pairs that are not free.
#[derive(Default, Serialize)]
pub(super) struct Remaining {
    /// The edges that pass through faces.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    crossings: Vec<String>,
    /// The pairs that touch, or are within the minimum distance.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    contacts: Vec<String>,
}

/// The numbers of pairs that are not free.
#[derive(Clone, Copy, Default, Serialize)]
pub(super) struct Pairs {
    /// The edges that pass through faces.
    pub(super) crossings: usize,
    /// The pairs that touch, or are within the minimum distance.
    pub(super) contacts: usize,
}

impl Remaining {
    /// The pairs of a mesh in these positions, with their bodies and the ids of their files.
    pub(super) fn new(
        scene: &Assembly,
        mesh: &TriangleMesh,
        crossings: &[Intersection],
        contacts: &[Pair],
    ) -> Self {
        let crossing = |pair: &Intersection| ContactRecord::of_crossing(0, mesh, *pair);
        let contact = |pair: &Pair| ContactRecord::of_pair(0, mesh, *pair);
        let name = |record| scene.in_file(record).to_string();
        Self {
            crossings: crossings.iter().take(NAMED).map(crossing).map(name).collect(),
            contacts: contacts.iter().take(NAMED).map(contact).map(name).collect(),
        }
    }
}

impl Pairs {
    pub(super) fn of(crossings: &[Intersection], contacts: &[Pair]) -> Self {
        Self {
            crossings: crossings.len(),
            contacts: contacts.len(),
        }
    }
}

/// A line for each pair.
impl fmt::Display for Remaining {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let crossings = self.crossings.iter().map(|pair| ("crossing", pair));
        let contacts = self.contacts.iter().map(|pair| ("contact", pair));
        let mut pairs = crossings.chain(contacts);
        pairs.try_for_each(|(kind, pair)| writeln!(f, "  {kind}: {pair}"))
    }
}

impl fmt::Display for Pairs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} of an edge that passes through a face, {} in contact",
            self.crossings, self.contacts
        )
    }
}

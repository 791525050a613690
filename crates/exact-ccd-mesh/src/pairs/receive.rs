//! Receivers of pairs.

use std::ops::ControlFlow;

use super::kind::Searched;

/// A receiver of the pairs of a step, in batches in any order, on any thread.
pub(crate) trait Receive: Sync {
    /// Receives pairs of one kind, of two primitives of one set the smaller index first. `Break` ends the
    /// search.
    fn receive<K: Searched>(&self, pairs: &[[u32; 2]]) -> ControlFlow<()>;
}

//! The pairs of bodies for which contact counts.

use std::fmt;
use std::sync::Arc;

/// A predicate on pairs of bodies: all pairs, if there is none.
#[derive(Clone, Default)]
pub(super) struct BodyPredicate(Option<Arc<Predicate>>);

type Predicate = dyn Fn(usize, usize) -> bool + Send + Sync;

impl BodyPredicate {
    pub(super) fn new(predicate: impl Fn(usize, usize) -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(predicate)))
    }

    /// Returns true if two bodies, the lesser first, can collide.
    pub(super) fn allows(&self, [a, b]: [usize; 2]) -> bool {
        self.0.as_ref().is_none_or(|predicate| predicate(a, b))
    }
}

impl fmt::Debug for BodyPredicate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("BodyPredicate")
            .field("has_predicate", &self.0.is_some())
            .finish()
    }
}

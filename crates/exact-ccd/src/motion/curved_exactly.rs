//! The answers about curved motion by the definition alone, without any filter.

use super::curved_query::CurvedQuery;
use crate::exact::First;
use crate::kind::Kind;
use crate::values::{Impact, Intervals, Options};

/// A query of curved motion whose answers are computed in integers alone, for audits: the answers
/// of [`CurvedQuery`], by the definition. See [`Exactly`](crate::Exactly).
#[derive(Clone, Copy, Debug)]
pub struct CurvedExactly<'a, K: Kind> {
    pub(super) query: &'a CurvedQuery<K>,
}

impl<K: Kind> CurvedQuery<K> {
    /// The same query, answered in integers alone.
    #[must_use]
    pub fn exactly(&self) -> CurvedExactly<'_, K> {
        CurvedExactly { query: self }
    }
}

impl<K: Kind> CurvedExactly<'_, K> {
    /// [`CurvedQuery::collides`], decided in integers alone.
    #[must_use]
    pub fn collides(self, options: impl Into<Options>) -> bool {
        let options = options.into();
        if options.until >= 1.0 {
            First::<K>::exists_along(self.query.points(), options.separation)
        } else {
            self.first(options).is_some()
        }
    }

    /// [`CurvedQuery::time_of_impact`], computed in integers alone.
    #[must_use]
    pub fn time_of_impact(self, options: impl Into<Options>) -> Option<f64> {
        self.first(options.into()).map(|first| first.time().lower())
    }

    /// [`CurvedQuery::intervals`], computed in integers alone.
    #[must_use]
    pub fn intervals(self, options: impl Into<Options>) -> Intervals {
        self.first(options.into())
            .map_or_else(Intervals::default, |first| first.intervals())
    }

    /// [`CurvedQuery::impact`], computed in integers alone.
    #[must_use]
    pub fn impact(self, options: impl Into<Options>) -> Option<Impact> {
        self.first(options.into()).map(|first| first.impact())
    }

    /// The first time at which the primitives touch, if it counts.
    pub(super) fn first(self, options: Options) -> Option<First<K>> {
        First::along(self.query.points(), options.separation)?.until(options.until)
    }
}

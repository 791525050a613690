//! The answers by the definition alone, without any filter.

use core::marker::PhantomData;

use crate::exact::{First, MovingPoints};
use crate::kind::Kind;
use crate::query::Query;
use crate::values::{Impact, Intervals, Options};

/// A query whose answers are computed by the definition, in integers alone, for audits. [`Query`] and
/// [`CurvedQuery`](crate::motion::CurvedQuery) have the same answers.
///
/// They follow from signs of polynomials with integer coefficients, without rounding and without tolerance.
/// Coordinates are read as bit patterns: no answer depends on the floating-point environment.
///
/// ```
/// use exact_ccd::{CONTACT, Query, VertexVertex};
///
/// let query = Query::<VertexVertex>::new([[-1.0, 0.0, 0.0], [0.0; 3]], [[2.0, 0.0, 0.0], [0.0; 3]])?;
/// assert_eq!(query.exactly().time_of_impact(CONTACT), Some(0.3333333333333333));
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
#[derive(Clone, Debug)]
pub struct Exactly<K> {
    points: MovingPoints,
    kind: PhantomData<K>,
}

impl<K: Kind> Query<K> {
    /// The same query, answered in integers alone.
    #[must_use]
    pub fn exactly(&self) -> Exactly<K> {
        Exactly::along(MovingPoints::along(&*self.four()))
    }
}

impl<K: Kind> Exactly<K> {
    /// The query of points in motion.
    pub(crate) fn along(points: MovingPoints) -> Self {
        let kind = PhantomData;
        Self { points, kind }
    }

    /// [`Query::collides`], decided in integers alone.
    #[must_use]
    pub fn collides(&self, options: impl Into<Options>) -> bool {
        let options = options.into();
        if options.until >= 1.0 {
            First::<K>::exists_along(self.points.clone(), options.separation)
        } else {
            // A part of the step, or none of it: NaN.
            self.first(options).is_some()
        }
    }

    /// [`Query::time_of_impact`], computed in integers alone.
    #[must_use]
    pub fn time_of_impact(&self, options: impl Into<Options>) -> Option<f64> {
        self.first(options.into()).map(|first| first.time().lower())
    }

    /// [`Query::intervals`], computed in integers alone.
    #[must_use]
    pub fn intervals(&self, options: impl Into<Options>) -> Intervals {
        self.first(options.into())
            .map_or_else(Intervals::default, |first| first.intervals())
    }

    /// [`Query::impact`], computed in integers alone.
    #[must_use]
    pub fn impact(&self, options: impl Into<Options>) -> Option<Impact> {
        self.first(options.into()).map(|first| first.impact())
    }

    /// The first time at which the primitives touch, if it counts.
    pub(crate) fn first(&self, options: Options) -> Option<First<K>> {
        First::along(self.points.clone(), options.separation)?.until(options.until)
    }
}

//! Methods of continuous collision detection behind one trait.

use crate::batch::{Trajectories, VertexOutOfRange};
use crate::kind::Kind;
use crate::query::Query;
use crate::tables::{EdgeEdge, VertexFace};
use crate::values::CONTACT;

/// A decision of queries of one kind, right or wrong: the part of a [`Ccd`] that depends on the kind.
pub trait Decide<K: Kind>: Send + Sync {
    /// Returns true if the primitives touch, according to this method.
    fn collides(&self, query: &Query<K>) -> bool;

    /// The earliest contact time according to this method, in \[0, 1\]; `None` if the primitives do
    /// not touch.
    ///
    /// The default is for a method without times: 0 for each contact, which is conservative.
    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        self.collides(query).then_some(0.0)
    }

    /// Calls `sink` with the index of each query over `trajectories` that
    /// [collides](Self::collides), in order.
    ///
    /// # Errors
    /// [`VertexOutOfRange`] names the first vertex that does not exist.
    fn collisions(
        &self,
        trajectories: &Trajectories,
        queries: &[K::Vertices],
        sink: &mut dyn FnMut(usize),
    ) -> Result<(), VertexOutOfRange> {
        let queries = trajectories.queries(queries)?.enumerate();
        queries
            .filter(|(_, query)| self.collides(query))
            .for_each(|(index, _)| sink(index));
        Ok(())
    }

    /// Calls `sink` with the index and the [time of impact](Self::time_of_impact) of each query
    /// over `trajectories` that has one, in order.
    ///
    /// # Errors
    /// [`VertexOutOfRange`] names the first vertex that does not exist.
    fn times_of_impact(
        &self,
        trajectories: &Trajectories,
        queries: &[K::Vertices],
        sink: &mut dyn FnMut(usize, f64),
    ) -> Result<(), VertexOutOfRange> {
        for (index, query) in trajectories.queries(queries)?.enumerate() {
            if let Some(time) = self.time_of_impact(&query) {
                sink(index, time);
            }
        }
        Ok(())
    }
}

/// A method of continuous collision detection.
///
/// ```
/// use exact_ccd::{Ccd, Decide, Exact, Query, VertexFace};
///
/// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let at = |z: f64| [[0.25, 0.25, z], face[0], face[1], face[2]];
/// let query = Query::<VertexFace>::new(at(1.0), at(-1.0))?;
///
/// let method: &dyn Ccd = &Exact;
/// assert!(!method.guarantees().false_negatives);
/// assert_eq!(method.time_of_impact(&query), Some(0.5));
/// # Ok::<(), exact_ccd::NonFinite>(())
/// ```
pub trait Ccd: Decide<VertexFace> + Decide<EdgeEdge> {
    /// The name of the method: short, and different from all others.
    fn name(&self) -> &str;

    /// The guarantees of the method's answers, for any finite input.
    fn guarantees(&self) -> Guarantees;
}

/// The guarantees of a method's answers, for any finite input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Guarantees {
    /// False negatives are possible: a query that collides may be decided to be free.
    pub false_negatives: bool,
    /// False positives are possible: a query that is free may be decided to collide.
    pub false_positives: bool,
    /// The meaning of the method's times of impact.
    pub time: TimeGuarantee,
}

/// The meaning of a method's times of impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TimeGuarantee {
    /// The method has no times of impact: it returns 0 for each contact.
    Absent,
    /// An approximation, on either side of the earliest contact.
    Approximate,
    /// At or before the earliest contact.
    Conservative,
    /// The earliest contact, rounded down to the next f64.
    Exact,
}

/// The exact method: the answers of [`Query`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Exact;

impl<K: Kind> Decide<K> for Exact {
    fn collides(&self, query: &Query<K>) -> bool {
        query.collides(CONTACT)
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        query.time_of_impact(CONTACT)
    }

    fn collisions(
        &self,
        trajectories: &Trajectories,
        queries: &[K::Vertices],
        sink: &mut dyn FnMut(usize),
    ) -> Result<(), VertexOutOfRange> {
        trajectories.collisions::<K>(queries, CONTACT, |index, _| sink(index))
    }

    fn times_of_impact(
        &self,
        trajectories: &Trajectories,
        queries: &[K::Vertices],
        sink: &mut dyn FnMut(usize, f64),
    ) -> Result<(), VertexOutOfRange> {
        trajectories.collisions::<K>(queries, CONTACT, |index, collision| {
            sink(index, collision.time_of_impact());
        })
    }
}

impl Ccd for Exact {
    fn name(&self) -> &'static str {
        "exact"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: false,
            false_positives: false,
            time: TimeGuarantee::Exact,
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec;
    use alloc::vec::Vec;

    use super::*;
    use crate::tables::VertexVertex;

    /// A method with the default functions.
    struct Defaults;

    impl<K: Kind> Decide<K> for Defaults {
        fn collides(&self, query: &Query<K>) -> bool {
            query.collides(CONTACT)
        }
    }

    #[test]
    fn queries_of_trajectories_have_the_answers_of_single_queries() {
        // Two points that meet at t = 1/2, and one that stays away.
        let x0 = [[0.0; 3], [1.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
        let x1 = [[0.0; 3], [-1.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
        let trajectories = Trajectories::new(&x0, &x1).expect("finite coordinates");
        let answers = |method: &dyn Decide<VertexVertex>, queries: &[[u32; 2]]| {
            let (mut found, mut times) = (Vec::new(), Vec::new());
            method.collisions(&trajectories, queries, &mut |index| found.push(index))?;
            method.times_of_impact(&trajectories, queries, &mut |index, t| times.push((index, t)))?;
            Ok::<_, VertexOutOfRange>((found, times))
        };
        let queries = [[0, 2], [0, 1]];
        assert_eq!(answers(&Defaults, &queries), Ok((vec![1], vec![(1, 0.0)])));
        assert_eq!(answers(&Exact, &queries), Ok((vec![1], vec![(1, 0.5)])));
        let query = |[a, b]: [usize; 2]| {
            Query::<VertexVertex>::new([x0[a], x0[b]], [x1[a], x1[b]]).expect("finite coordinates")
        };
        for method in [&Defaults as &dyn Decide<VertexVertex>, &Exact] {
            let error = answers(method, &[[0, 1], [0, 3]]).expect_err("there is no vertex 3");
            assert_eq!((error.query, error.vertex, error.vertex_count), (1, 3, 3));
            assert_eq!(
                [[0, 2], [0, 1]].map(|pair| method.collides(&query(pair))),
                [false, true]
            );
        }
        assert_eq!(Decide::time_of_impact(&Exact, &query([0, 1])), Some(0.5));
        let guarantees = Exact.guarantees();
        assert!(!guarantees.false_negatives && !guarantees.false_positives);
    }
}

//! The kinds of query, with the algorithms compiled for each.

use core::fmt::Debug;
use core::ops::Deref;

use crate::answers;
use crate::batch::{self, Batch, Instructions};
use crate::collision::Collision;
use crate::query::Query;
use crate::tables::{EdgeEdge, Point, Tables, VertexEdge, VertexFace, VertexVertex};
use crate::values::{ContactTime, DistanceBounds, Impact, Intervals, Options, Stage};

/// The kind of a [`Query`](crate::Query): [`VertexFace`], [`EdgeEdge`], [`VertexEdge`] or [`VertexVertex`].
/// Sealed.
pub trait Kind: Tables + Copy {
    /// The points of a query at one time, in the order that the kind states.
    type Points: AsRef<[Point]> + AsMut<[Point]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The indices of those points among the vertices of a mesh, in the same order.
    type Vertices: AsRef<[u32]> + AsMut<[u32]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The number of points of the first primitive, which come first.
    const FIRST: usize;

    /// x₀ … x₃ at both ends of the step: the points themselves if they are four.
    #[doc(hidden)]
    fn four(points: &[Self::Points; 2]) -> impl Deref<Target = [[Point; 4]; 2]>;

    // The algorithms are functions of each kind, not generic ones: this crate contains their code, and the
    // crates that call them do not compile it again.
    #[doc(hidden)]
    fn run(batch: Batch<'_, Self>, instructions: Instructions);
    #[doc(hidden)]
    fn collides(query: &Query<Self>, options: Options) -> bool;
    #[doc(hidden)]
    fn decide(query: &Query<Self>, options: Options) -> Result<Collision<'_, Self>, Stage>;
    #[doc(hidden)]
    fn time(collision: &Collision<'_, Self>) -> ContactTime;
    #[doc(hidden)]
    fn intervals(collision: &Collision<'_, Self>) -> Intervals;
    #[doc(hidden)]
    fn impact(collision: &Collision<'_, Self>) -> Impact;
    #[doc(hidden)]
    fn distance(collision: &Collision<'_, Self>) -> DistanceBounds;
}

/// Four points of a query that has fewer: some occur twice.
struct Repeated([[Point; 4]; 2]);

impl Repeated {
    #[inline(always)]
    fn of<K: Kind>(points: &[K::Points; 2]) -> Self {
        Self(points.map(|points| K::LAYOUT.map(|i| points.as_ref()[i])))
    }
}

impl Deref for Repeated {
    type Target = [[Point; 4]; 2];

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// A kind with numbers of points, of a query and of its first primitive, and x₀ … x₃ among them.
macro_rules! kind {
    ($kind:ident, $count:literal, $first:literal, |$points:ident| $four:expr) => {
        impl Kind for $kind {
            type Points = [Point; $count];
            type Vertices = [u32; $count];
            const FIRST: usize = $first;

            #[inline(always)]
            fn four($points: &[Self::Points; 2]) -> impl Deref<Target = [[Point; 4]; 2]> {
                $four
            }

            #[inline(never)]
            fn run(batch: Batch<'_, Self>, instructions: Instructions) {
                batch::run(batch, instructions);
            }

            #[inline(never)]
            fn collides(query: &Query<Self>, options: Options) -> bool {
                answers::collides(query, &options)
            }

            #[inline(never)]
            fn decide(query: &Query<Self>, options: Options) -> Result<Collision<'_, Self>, Stage> {
                answers::decide(query, &options)
            }

            #[inline(never)]
            fn time(collision: &Collision<'_, Self>) -> ContactTime {
                collision.determine_time()
            }

            #[inline(never)]
            fn intervals(collision: &Collision<'_, Self>) -> Intervals {
                collision.determine_intervals()
            }

            #[inline(never)]
            fn impact(collision: &Collision<'_, Self>) -> Impact {
                collision.determine_impact()
            }

            #[inline(never)]
            fn distance(collision: &Collision<'_, Self>) -> DistanceBounds {
                collision.determine_distance()
            }
        }
    };
}

kind!(VertexFace, 4, 1, |points| points);
kind!(EdgeEdge, 4, 2, |points| points);
kind!(VertexEdge, 3, 1, |points| Repeated::of::<Self>(points));
kind!(VertexVertex, 2, 1, |points| Repeated::of::<Self>(points));

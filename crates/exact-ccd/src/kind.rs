//! The kinds of query, with the algorithms compiled for each.

use core::fmt::Debug;
use core::ops::Deref;

use crate::decide;
use crate::decided::Decided;
use crate::tables::{EdgeEdge, Point, Points, Tables, VertexEdge, VertexFace, VertexVertex};
use crate::values::{ContactTime, DistanceBounds, Impact, Intervals, Options, Stage};
use crate::vectors::{self, Batch, Instructions};

/// The kind of a [`Query`](crate::Query): [`VertexFace`], [`EdgeEdge`], [`VertexEdge`] or [`VertexVertex`].
/// Sealed.
pub trait Kind: Tables + Copy {
    /// The points of a query at one time, in the order that the kind states.
    type Points: AsRef<[Point]> + AsMut<[Point]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The indices of those points among the vertices of a mesh, in the same order.
    type Vertices: AsRef<[u32]> + AsMut<[u32]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The number of points of the first primitive, which come first.
    const FIRST: usize = Self::SECOND;

    /// x₀ … x₃ at both ends of the step: the points themselves if they are four.
    #[doc(hidden)]
    fn four(points: &[Self::Points; 2]) -> impl Deref<Target = Points<f64>>;

    // The algorithms are functions of each kind, not generic ones: this crate contains their code, and the
    // crates that call them do not compile it again.
    #[doc(hidden)]
    fn run(batch: Batch<'_, Self, Self::Vertices>, instructions: Instructions);
    #[doc(hidden)]
    fn collides(points: &[Self::Points; 2], options: Options) -> bool;
    #[doc(hidden)]
    fn decide(points: &[Self::Points; 2], options: Options) -> Result<Decided<Self>, Stage>;
    #[doc(hidden)]
    fn time(decided: &Decided<Self>, points: &[Self::Points; 2]) -> ContactTime;
    #[doc(hidden)]
    fn intervals(decided: &Decided<Self>, points: &[Self::Points; 2]) -> Intervals;
    #[doc(hidden)]
    fn impact(decided: &Decided<Self>, points: &[Self::Points; 2]) -> Impact;
    #[doc(hidden)]
    fn distance(decided: &Decided<Self>, points: &[Self::Points; 2]) -> DistanceBounds;
}

/// Four points of a query that has fewer: some occur twice.
struct Repeated(Points<f64>);

impl Repeated {
    #[inline(always)]
    fn of<K: Kind>(points: &[K::Points; 2]) -> Self {
        Self(points.map(|points| K::LAYOUT.map(|i| points.as_ref()[i])))
    }
}

impl Deref for Repeated {
    type Target = Points<f64>;

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// A kind with a number of points, and x₀ … x₃ among them.
macro_rules! kind {
    ($kind:ident, $count:literal, |$points:ident| $four:expr) => {
        impl Kind for $kind {
            type Points = [Point; $count];
            type Vertices = [u32; $count];

            #[inline(always)]
            fn four($points: &[Self::Points; 2]) -> impl Deref<Target = Points<f64>> {
                $four
            }

            #[inline(never)]
            fn run(batch: Batch<'_, Self, Self::Vertices>, instructions: Instructions) {
                vectors::run(batch, instructions);
            }

            #[inline(never)]
            fn collides(points: &[Self::Points; 2], options: Options) -> bool {
                if options.until >= 1.0 {
                    decide::collides::<Self>(&Self::four(points), &options)
                } else {
                    // A part of the step, or none of it: NaN.
                    Self::decide(points, options).is_ok()
                }
            }

            #[inline(never)]
            fn decide(points: &[Self::Points; 2], options: Options) -> Result<Decided<Self>, Stage> {
                decide::decide(&Self::four(points), &options)
            }

            #[inline(never)]
            fn time(decided: &Decided<Self>, points: &[Self::Points; 2]) -> ContactTime {
                decided.time(&Self::four(points))
            }

            #[inline(never)]
            fn intervals(decided: &Decided<Self>, points: &[Self::Points; 2]) -> Intervals {
                decided.intervals(&Self::four(points))
            }

            #[inline(never)]
            fn impact(decided: &Decided<Self>, points: &[Self::Points; 2]) -> Impact {
                decided.impact(&Self::four(points))
            }

            #[inline(never)]
            fn distance(decided: &Decided<Self>, points: &[Self::Points; 2]) -> DistanceBounds {
                decided.distance(&Self::four(points))
            }
        }
    };
}

kind!(VertexFace, 4, |points| points);
kind!(EdgeEdge, 4, |points| points);
kind!(VertexEdge, 3, |points| Repeated::of::<Self>(points));
kind!(VertexVertex, 2, |points| Repeated::of::<Self>(points));

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
    /// This kind as a value.
    const KIND: AnyKind;

    /// x₀ … x₃ at both ends of the step: the points themselves if they are four.
    #[doc(hidden)]
    fn four(points: &[Self::Points; 2]) -> impl Deref<Target = Points<f64>>;
    /// The points of the query of x₀ … x₃.
    #[doc(hidden)]
    fn of_four(four: &Points<f64>) -> [Self::Points; 2];

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

/// A computation for a kind that is known at run time: see [`AnyKind::with`].
pub trait WithKind {
    /// The result.
    type Output;

    /// Computes it for a kind.
    fn with<K: Kind>(self) -> Self::Output;
}

/// The list of the kinds: documentation, the type, its name, its short name, the names of its points, x₀ … x₃
/// of its points, and the reverse.
macro_rules! kinds {
    ($(
        $(#[$doc:meta])*
        $kind:ident, $name:literal, $short:literal, [$($point:literal),+],
        |$points:ident| $four:expr, |$of_four:ident| $points_of_four:expr;
    )+) => {
        /// A kind of query as a value: one that is known at run time, as from a file or an option.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum AnyKind {
            $($(#[$doc])* $kind,)+
        }

        impl AnyKind {
            /// All kinds.
            pub const ALL: &'static [Self] = &[$(Self::$kind),+];

            /// The name, such as `vertex-face`.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)+
                }
            }

            /// The short name, such as `vf`.
            #[must_use]
            pub const fn short(self) -> &'static str {
                match self {
                    $(Self::$kind => $short,)+
                }
            }

            /// The names of the points of a query, in their order.
            #[must_use]
            pub const fn point_names(self) -> &'static [&'static str] {
                match self {
                    $(Self::$kind => &[$($point),+],)+
                }
            }

            /// Calls a generic function for this kind.
            ///
            /// ```
            /// use exact_ccd::{AnyKind, Kind, WithKind};
            ///
            /// struct Count;
            ///
            /// impl WithKind for Count {
            ///     type Output = usize;
            ///
            ///     fn with<K: Kind>(self) -> usize {
            ///         K::Points::default().as_ref().len()
            ///     }
            /// }
            ///
            /// assert_eq!(AnyKind::VertexEdge.with(Count), 3);
            /// ```
            pub fn with<W: WithKind>(self, computation: W) -> W::Output {
                match self {
                    $(Self::$kind => computation.with::<$kind>(),)+
                }
            }
        }

        $(impl Kind for $kind {
            type Points = [Point; <Self as Tables>::COUNT];
            type Vertices = [u32; <Self as Tables>::COUNT];
            const KIND: AnyKind = AnyKind::$kind;

            #[inline(always)]
            fn four($points: &[Self::Points; 2]) -> impl Deref<Target = Points<f64>> {
                $four
            }

            #[inline(always)]
            fn of_four($of_four: &Points<f64>) -> [Self::Points; 2] {
                $points_of_four
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
        })+
    };
}

kinds! {
    /// [`VertexFace`](crate::VertexFace).
    VertexFace, "vertex-face", "vf", ["p", "v1", "v2", "v3"], |points| points, |four| *four;
    /// [`EdgeEdge`](crate::EdgeEdge).
    EdgeEdge, "edge-edge", "ee", ["a0", "a1", "b0", "b1"], |points| points, |four| *four;
    /// [`VertexEdge`](crate::VertexEdge).
    VertexEdge, "vertex-edge", "ve", ["p", "a", "b"],
    |points| Repeated::of::<Self>(points), |four| four.map(|[p, _, a, b]| [p, a, b]);
    /// [`VertexVertex`](crate::VertexVertex).
    VertexVertex, "vertex-vertex", "vv", ["p", "q"],
    |points| Repeated::of::<Self>(points), |four| four.map(|[p, _, q, _]| [p, q]);
}

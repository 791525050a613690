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
pub trait Kind: Tables + Copy + Send + Sync + 'static {
    /// The points of a query at one time, in the order that the kind states.
    type Points: AsRef<[Point]> + AsMut<[Point]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The indices of those points among the vertices of a mesh, in the same order.
    type Vertices: AsRef<[u32]> + AsMut<[u32]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The number of points of the first primitive, which come first.
    const FIRST: usize = Self::SECOND;
    /// The index of each of x₀ … x₃ among the points of a query. In a query of fewer points, some occur
    /// twice: an edge of length zero stands for a vertex.
    const OF_FOUR: [usize; 4] = Self::LAYOUT;
    /// This kind as a value.
    const KIND: AnyKind;

    /// Queries whose vertices stand one after the other. The rest of an incomplete query is left out.
    fn queries(vertices: &[u32]) -> &[Self::Vertices];

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

/// The list of the kinds: documentation, the type, its name, its short name, the names of its points, x₀ … x₃
/// of its points, and the reverse. The dollar sign begins the names in [`with_kind!`](crate::with_kind).
macro_rules! kinds {
    ($d:tt $(
        $(#[$doc:meta])*
        $kind:ident, $name:literal, $short:literal, [$($point:literal),+],
        |$points:ident| $four:expr, |$of_four:ident| $points_of_four:expr;
    )+) => {
        /// A kind of query as a value: one that is known at run time, as from a file or an option.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
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

            /// The numbers of points of both primitives: 1 for a vertex, 2 for an edge, 3 for a face.
            #[must_use]
            pub const fn sizes(self) -> [usize; 2] {
                match self {
                    $(Self::$kind => [$kind::SECOND, $kind::COUNT - $kind::SECOND],)+
                }
            }
        }

        /// Evaluates an expression for an [`AnyKind`](crate::AnyKind): in it, a name stands for the type of
        /// the kind.
        ///
        /// ```
        /// use exact_ccd::{AnyKind, Kind, with_kind};
        ///
        /// fn count<K: Kind>() -> usize {
        ///     K::Points::default().as_ref().len()
        /// }
        ///
        /// let counts = AnyKind::ALL.iter().map(|&kind| with_kind!(kind, K => count::<K>()));
        /// assert_eq!(counts.collect::<Vec<_>>(), [4, 4, 3, 2]);
        /// ```
        #[macro_export]
        macro_rules! with_kind {
            ($d any:expr, $d K:ident => $d value:expr) => {
                match $d any {
                    $($d crate::AnyKind::$kind => {
                        type $d K = $d crate::$kind;
                        $d value
                    })+
                }
            };
        }

        $(impl Kind for $kind {
            type Points = [Point; <Self as Tables>::COUNT];
            type Vertices = [u32; <Self as Tables>::COUNT];
            const KIND: AnyKind = AnyKind::$kind;

            #[inline]
            fn queries(vertices: &[u32]) -> &[Self::Vertices] {
                vertices.as_chunks().0
            }

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
    $
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

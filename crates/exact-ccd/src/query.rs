//! Queries: four points at the two ends of a time step.

use core::fmt;
use core::ops::Deref;

use crate::kind::Kind;
use crate::tables::Point;
use crate::values::Axis;

/// Two primitives of a moving mesh over one time step; see [`VertexFace`](crate::VertexFace) and
/// [`EdgeEdge`](crate::EdgeEdge).
///
/// Each of its points, two, three or four, moves in a straight line, at constant speed, from its position
/// at t = 0 to its position at t = 1. Any finite coordinates are allowed: the answers are exact for faces
/// without area, edges without length, coincident points and subnormal numbers too.
#[derive(Clone, Copy, PartialEq)]
pub struct Query<K: Kind> {
    points: [K::Points; 2],
}

/// A coordinate is infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("coordinate {axis} of point {point}{} is {value}, not a finite number", At(*.time))]
pub struct NonFinite {
    /// The end of the time step, 0 or 1; `None` for points at rest.
    pub time: Option<usize>,
    /// The index of the point among those given, from 0.
    pub point: usize,
    /// The axis of the coordinate.
    pub axis: Axis,
    /// The coordinate.
    pub value: f64,
}

/// The end of a time step, in a message.
pub(crate) struct At(pub(crate) Option<usize>);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |time| write!(f, " at t = {time}"))
    }
}

impl NonFinite {
    /// Checks points at rest, or at t = 0 and at t = 1.
    pub(crate) fn check(ends: &[&[Point]]) -> Result<(), Self> {
        let is_moving = ends.len() > 1;
        for (time, points) in ends.iter().enumerate() {
            for (point, coordinates) in points.iter().enumerate() {
                for &axis in Axis::ALL {
                    let value = coordinates[axis.index()];
                    if !value.is_finite() {
                        return Err(Self {
                            time: is_moving.then_some(time),
                            point,
                            axis,
                            value,
                        });
                    }
                }
            }
        }
        Ok(())
    }
}

impl<K: Kind> Query<K> {
    /// The query of points at the start and at the end of the time step, in the order of the kind: four
    /// points for [`VertexFace`](crate::VertexFace) and [`EdgeEdge`](crate::EdgeEdge), three for
    /// [`VertexEdge`](crate::VertexEdge), two for [`VertexVertex`](crate::VertexVertex).
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is infinite or not a number.
    #[inline]
    pub fn new(t0: K::Points, t1: K::Points) -> Result<Self, NonFinite> {
        // Without a branch for each coordinate, which would cost more than most queries.
        let are_finite = |points: &K::Points| {
            let coordinates = points.as_ref().as_flattened();
            coordinates.iter().fold(true, |all, x| all & x.is_finite())
        };
        if !(are_finite(&t0) & are_finite(&t1)) {
            NonFinite::check(&[t0.as_ref(), t1.as_ref()])?;
        }
        Ok(Self::from_finite([t0, t1]))
    }

    /// The query of finite points.
    #[inline]
    pub(crate) fn from_finite(points: [K::Points; 2]) -> Self {
        Self { points }
    }

    /// The points at t = 0 and at t = 1.
    #[must_use]
    #[inline]
    pub fn points(&self) -> &[K::Points; 2] {
        &self.points
    }

    /// x₀ … x₃ at t = 0 and at t = 1.
    #[inline(always)]
    pub(crate) fn four(&self) -> impl Deref<Target = [[Point; 4]; 2]> {
        K::four(&self.points)
    }
}

impl<K: Kind<Points = [Point; 4]>> Query<K> {
    /// [`new`](Self::new) for points of another library: the points of `glam` (`DVec3`), `nalgebra`
    /// (`Point3<f64>`, `Vector3<f64>`) and `mint` (`Point3<f64>`, `Vector3<f64>`) convert into `[f64; 3]`.
    ///
    /// # Errors
    /// [`NonFinite`], as [`new`](Self::new).
    pub fn from_points<P: Into<Point>>(t0: [P; 4], t1: [P; 4]) -> Result<Self, NonFinite> {
        Self::new(t0.map(Into::into), t1.map(Into::into))
    }
}

impl<K: Kind> fmt::Debug for Query<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Query")
            .field("t0", &self.points[0])
            .field("t1", &self.points[1])
            .finish()
    }
}

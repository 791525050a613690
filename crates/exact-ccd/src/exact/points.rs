//! The four moving points of a query in integers.

use alloc::boxed::Box;

use dashu_int::IBig;

use super::dyadic::{in_unit, unit_of};
use super::frame::Frame;
use super::polynomial::{Polynomial, Vector, cross, cross_component, dot};
use crate::tables::{Difference, Point, Side, Tables};

/// The points of a query as homogeneous polynomials in t: the place of a point is X / w, for three
/// polynomials X and one, w, which is positive in the step. The coordinates on an axis are integers of a unit
/// of its own, a power of two: contact is invariant under scalings of an axis.
///
/// Points on polynomial curves have w = 1. Straight motion has degree 1.
#[derive(Clone, Debug)]
pub(crate) struct MovingPoints {
    points: [Vector; 4],
    /// The exponent of the unit of each axis; none if all coordinates are 0.
    units: [Option<i32>; 3],
    /// For rigid bodies: the coordinates are those of the second body, in which its points are at rest.
    frame: Option<Box<Frame>>,
}

impl MovingPoints {
    /// Points on Bézier curves of one degree, by their control points in order. Two for each are straight
    /// motion.
    ///
    /// The Bernstein polynomial of index i and degree p is tⁱ sᵖ⁻ⁱ times a binomial coefficient.
    pub(crate) fn along(control: &[[Point; 4]]) -> Self {
        let units = [0, 1, 2].map(|axis: usize| {
            let points = control.iter().flatten();
            unit_of(points.map(|point| point[axis]))
        });
        let curve = |point: usize, axis: usize| {
            let coordinates = control.iter().map(|points| points[point][axis]);
            Polynomial::bezier(coordinates.map(|x| in_unit(x, units[axis])).collect())
        };
        let mut points = [0, 1, 2, 3].map(|point| [0, 1, 2].map(|axis| curve(point, axis)));
        while control.len() > 2
            && let Some(lowered) = lowered(&points)
        {
            points = lowered;
        }
        Self {
            points,
            units,
            frame: None,
        }
    }

    /// Points in the coordinates of the second body, with one unit for all axes.
    pub(super) fn in_frame(points: [Vector; 4], unit: Option<i32>, frame: Frame) -> Self {
        Self {
            points,
            units: [unit; 3],
            frame: Some(Box::new(frame)),
        }
    }

    /// The difference of two points, times w if they are of different bodies, or both of the first one.
    pub(crate) fn difference(&self, (i, j): Difference) -> Vector {
        match &self.frame {
            None => minus(&self.points[i], &self.points[j]),
            Some(frame) => match [i, j].map(|point| frame.is_of_first(point)) {
                [true, false] => minus(&self.points[i], &frame.weighted(&self.points[j])),
                [false, true] => minus(&frame.weighted(&self.points[i]), &self.points[j]),
                _ => minus(&self.points[i], &self.points[j]),
            },
        }
    }

    /// The difference of two points, times w.
    pub(super) fn weighted_difference(&self, (i, j): Difference) -> Vector {
        let difference = self.difference((i, j));
        match &self.frame {
            Some(frame) if !frame.is_of_first(i) && !frame.is_of_first(j) => frame.weighted(&difference),
            _ => difference,
        }
    }

    /// x − q and y − q for a vertex q and an edge from x to y, times w.
    pub(super) fn seen_from_vertex(&self, side: &Side) -> [Vector; 2] {
        side.edge.map(|end| self.difference((end, side.vertex)))
    }

    /// One component of (x − q) × (y − q), times w, given both factors.
    pub(super) fn area(&self, side: &Side, seen: &[Vector; 2], axis: usize) -> Polynomial {
        match &self.frame {
            None => cross_component(&seen[0], &seen[1], axis),
            Some(frame) => {
                let [x, y] = side.edge;
                let edge = self.difference((y, x));
                if frame.is_of_first(side.vertex) {
                    // The edge is at rest: (x − q) × (y − x).
                    cross_component(&seen[0], &edge, axis)
                } else {
                    // x × y − q × (y − x).
                    let vertex = &self.points[side.vertex];
                    let moment =
                        &frame.moment[axis] * &Polynomial::constant(if x < y { 1 } else { -1 }.into());
                    &moment - &cross_component(vertex, &edge, axis)
                }
            }
        }
    }

    /// (x − q) × (y − q), times w.
    pub(super) fn areas(&self, side: &Side) -> Vector {
        let seen = self.seen_from_vertex(side);
        [0, 1, 2].map(|axis| self.area(side, &seen, axis))
    }

    /// w · (e₁ × e₂), which vanishes when the four points are coplanar, and e₁ × e₂, both times the weight.
    pub(super) fn plane<K: Tables>(&self) -> (Polynomial, Vector) {
        let [w, e1, e2] = K::SPAN.map(|difference| self.difference(difference));
        let normal = cross(&e1, &e2);
        match &self.frame {
            None => (dot(&w, &normal), normal),
            // A face at rest.
            Some(frame) if !frame.is_of_first(1) => (dot(&w, &normal), frame.weighted(&normal)),
            // w × e₁ is the area of the second edge's first vertex and the first edge.
            Some(_) => {
                let first = K::SIDES.iter().find(|side| side.vertex == K::SPAN[0].1);
                let area = first.map_or_else(|| cross(&w, &e1), |side| self.areas(side));
                (dot(&area, &e2), normal)
            }
        }
    }

    /// The frame of rigid bodies.
    pub(super) fn frame(&self) -> Option<&Frame> {
        self.frame.as_deref()
    }

    /// A length as a polynomial of the degree of the points; with a frame, as a constant.
    pub(super) fn length(&self, length: IBig) -> Polynomial {
        let degree = match &self.frame {
            None => self.points[0][0].degree(),
            Some(_) => 0,
        };
        Polynomial::constant(length).elevated(degree)
    }

    /// A vector in the coordinates of the world, with one unit for all axes, times a positive factor.
    pub(super) fn to_world(&self, vector: Vector) -> Vector {
        match &self.frame {
            None => vector,
            Some(frame) => frame.to_world(&vector),
        }
    }

    /// The least exponent of a unit; none if all coordinates are 0.
    pub(super) fn least_unit(&self) -> Option<i32> {
        self.units.into_iter().flatten().min()
    }

    /// A vector of such coordinates with one unit for all axes, as lengths and angles need it: the least
    /// one.
    pub(super) fn to_scale(&self, vector: Vector) -> Vector {
        self.in_unit(vector, self.least_unit().unwrap_or_default())
    }

    /// A vector of such coordinates in a unit that is not above the least one.
    fn in_unit(&self, vector: Vector, unit: i32) -> Vector {
        [0, 1, 2].map(|axis: usize| {
            let shift = self.units[axis].map_or(0, |own| own - unit);
            vector[axis].shifted(shift.unsigned_abs() as usize)
        })
    }

    /// The same points with this unit, not above the least one, for all axes.
    pub(super) fn scaled_to(&self, unit: i32) -> Self {
        let frame = self.frame.as_ref().map(|frame| {
            let shift = self.units[0].map_or(0, |own| own - unit);
            Box::new(frame.scaled_by(shift.unsigned_abs() as usize))
        });
        Self {
            points: self.points.clone().map(|point| self.in_unit(point, unit)),
            units: [Some(unit); 3],
            frame,
        }
    }

    /// Points of straight motion with other coordinates.
    pub(super) fn map(&self, mut change: impl FnMut(&Polynomial) -> Polynomial) -> Self {
        let mut change = |vector: &Vector| [0, 1, 2].map(|axis: usize| change(&vector[axis]));
        Self {
            points: [0, 1, 2, 3].map(|point: usize| change(&self.points[point])),
            units: self.units,
            frame: None,
        }
    }
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis: usize| &a[axis] - &b[axis])
}

/// The points in a lower degree, if they have one: each with the factor t + s, which is 1, left out.
fn lowered(points: &[Vector; 4]) -> Option<[Vector; 4]> {
    let mut result = points.clone();
    for coordinate in result.iter_mut().flatten() {
        *coordinate = coordinate.lowered()?;
    }
    Some(result)
}

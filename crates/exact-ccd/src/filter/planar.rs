//! Motion in a plane across an axis, as of a cloth on the ground or between two walls: the coplanarity cubic
//! is zero, and the sides of the edges' lines on which the vertices lie decide.
//!
//! Each side is the sign of a quadratic. If all roots of the quadratics are simple and apart from
//! each other, one sign changes at a time, so that contact lasts for intervals of positive length.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::impact::{parameters_and_normal, vertex_on_edge};
use crate::numbers::cubic::{Cubic, Root};
use crate::numbers::double_double::DoubleDouble;
use crate::numbers::number::{Number, reach, subtract};
use crate::numbers::precise_cubic::PreciseCubic;
use crate::tables::{Difference, Point, Points, Side, Tables};
use crate::values::{ContactTime, Impact, Interval, Intervals};

/// The maximal number of crossings. A kind of query has at most four sides. The quadratic of a side
/// is handled as a cubic, whose roots are at most three.
const MAX_CROSSINGS: usize = 12;

/// A query in a plane.
pub(super) struct Planar<'a> {
    points: &'a Points<f64>,
    /// The axes along the plane.
    axes: [usize; 2],
}

/// The event with which an interval of contact begins or ends.
#[derive(Clone, Debug)]
pub(crate) enum Event {
    /// The primitives are in contact at t = 0.
    Start,
    /// A vertex crosses the line of an edge, while all others lie on the required sides.
    Side(&'static Side, Root),
    /// The primitives are in contact at t = 1.
    End,
}

/// A root of a side's quadratic.
struct Crossing {
    side: usize,
    root: Root,
}

/// Returns true if all points are in one plane across an axis, at t = 0 and at t = 1.
pub(super) fn is_across(points: &Points<f64>, axis: usize) -> bool {
    let is_flat = |points: &[Point; 4]| points.iter().all(|point| point[axis] == points[0][axis]);
    points.iter().all(is_flat)
}

impl<'a> Planar<'a> {
    /// The query, if all its points move in one plane across an axis. Exact: coordinates are only
    /// compared.
    pub(super) fn new(points: &'a Points<f64>) -> Option<Self> {
        let axes = [[1, 2], [2, 0], [0, 1]];
        (0..3).find(|&axis| is_across(points, axis)).map(|axis| Self {
            points,
            axes: axes[axis],
        })
    }

    /// The intervals of contact in increasing order, each by its two events; `None` if they are unknown.
    pub(super) fn stretches<K: Tables>(&self) -> Option<ArrayVec<[Event; 2], MAX_CROSSINGS>> {
        let [_, e1, e2] = K::SPAN;
        let facing = self.area(e1, e2).constant_sign()?;
        let mut inside = ArrayVec::<bool, 4>::new();
        let mut crossings = ArrayVec::<Crossing, MAX_CROSSINGS>::new();
        for (index, side) in K::SIDES.iter().enumerate() {
            let [x, y] = side.edge.map(|end| (end, side.vertex));
            let area = self.area(x, y);
            inside.push(area.starts_positive() == (facing.is_gt() == side.along));
            crossings.extend(
                area.roots()?
                    .into_iter()
                    .map(|root| Crossing { side: index, root }),
            );
        }
        crossings.sort_unstable_by(|a, b| a.root.near.total_cmp(&b.root.near));
        if crossings
            .windows(2)
            .any(|pair| pair[0].root.high > pair[1].root.low)
        {
            return None;
        }
        let touch = |inside: &[bool]| inside.iter().all(|&inside| inside);
        let mut stretches = ArrayVec::new();
        let mut began = touch(&inside).then_some(Event::Start);
        for Crossing { side, root } in crossings {
            inside[side] = !inside[side];
            let event = Event::Side(&K::SIDES[side], root);
            // One sign changes at a time: contact begins or ends here, or there is none on either side.
            match began.take() {
                Some(beginning) => stretches.push([beginning, event]),
                None => began = touch(&inside).then_some(event),
            }
        }
        if let Some(beginning) = began {
            stretches.push([beginning, Event::End]);
        }
        Some(stretches)
    }

    /// The intervals of contact, if they are known.
    pub(super) fn intervals<K: Tables>(&self) -> Option<Intervals> {
        let interval = |[beginning, end]: &[Event; 2]| {
            Some(Interval {
                start: self.round(beginning)?,
                end: self.round(end)?,
                is_moment: false,
            })
        };
        self.stretches::<K>()?.iter().map(interval).collect()
    }

    /// The cross product of two differences in the plane.
    fn area(&self, x: Difference, y: Difference) -> Cubic<f64> {
        let (coefficients, magnitude) = self.expand::<f64>(x, y);
        Cubic::new(coefficients, magnitude)
    }

    /// The time of an event, to the last bit.
    pub(super) fn round(&self, event: &Event) -> Option<ContactTime> {
        match event {
            Event::Start => Some(ContactTime::exactly(0.0)),
            Event::End => Some(ContactTime::exactly(1.0)),
            Event::Side(side, root) => {
                let [x, y] = side.edge.map(|end| (end, side.vertex));
                let (coefficients, magnitude) = self.expand::<DoubleDouble>(x, y);
                PreciseCubic::new(coefficients, magnitude).round(root)
            }
        }
    }

    /// The contact at an event with which it begins, if parameters and normal are accurate enough.
    ///
    /// At t = 0, all vertices are strictly beside the edges: the parameters are the only ones. Later, only
    /// the vertex of the event is on an edge.
    pub(super) fn impact<K: Tables>(&self, beginning: &Event) -> Option<Impact> {
        let time = self.round(beginning)?;
        let (parameters, normal) = match beginning {
            Event::Start => parameters_and_normal::<K>(self.points, &Root::exactly(0.0, Ordering::Greater))?,
            Event::Side(side, root) => vertex_on_edge(self.points, self.axes, side, &root.at(time))?,
            Event::End => return None,
        };
        Some(Impact {
            time,
            parameters,
            normal: Some(normal),
        })
    }

    /// The quadratic q₀ (1−t)² + m (1−t) t + q₁ t², raised to a cubic. The longest chain of
    /// roundings to a coefficient is a difference, a product, the difference in `cross`, the sum in
    /// `mixed` and one more; and the other difference in each term.
    pub(super) fn expand<T: Number<Real = f64>>(&self, x: Difference, y: Difference) -> ([T; 4], f64) {
        let along =
            |difference| subtract(self.points, difference).map(|d: [T; 3]| self.axes.map(|axis| d[axis]));
        let (x, y) = (along(x), along(y));
        let cross = |a: [T; 2], b: [T; 2]| a[0] * b[1] - a[1] * b[0];
        let (q0, q1) = (cross(x[0], y[0]), cross(x[1], y[1]));
        let mixed = cross(x[0], y[1]) + cross(x[1], y[0]);
        let (x, y) = (reach(&x), reach(&y));
        ([q0, q0 + mixed, mixed + q1, q1], x[0] * y[1] + x[1] * y[0])
    }
}

//! Where the primitives are in their common plane, at a time known to within a bracket.

use super::cubic::Root;
use super::{UNDERFLOW, UNIT};
use crate::kind::{Difference, Kind};
use crate::query::{Point, Query};

/// Whether two coplanar primitives touch.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Position {
    Inside,
    Outside,
}

/// A sign that is certain in a whole bracket of time.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Negative,
    Zero,
    Positive,
}

/// The difference of two points somewhere in a bracket of time.
pub(super) struct Motion {
    /// Near the middle of the bracket.
    value: Point,
    /// The larger magnitude at t = 0 and t = 1.
    magnitude: Point,
}

/// A number in a bracket of time, to within an error. It is zero for certain if the error is.
pub(super) struct Component {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Component {
    fn sign(&self) -> Option<Sign> {
        if self.value > self.error {
            Some(Sign::Positive)
        } else if self.value < -self.error {
            Some(Sign::Negative)
        } else if self.error == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

/// Whether the primitives touch at the root, if that is certain; the same tests as in the exact path.
pub(super) fn position<K: Kind>(query: &Query<K>, root: &Root) -> Option<Position> {
    let bracket = Bracket::new(query, root);
    let [_, e1, e2] = K::SPAN.map(|difference| bracket.motion(difference));
    let normal = bracket.cross(&e1, &e2);
    let corners = K::CORNERS.map(|difference| bracket.motion(difference));
    let axis = longest(&normal);
    let mut position = Some(Position::Inside);
    for side in K::SIDES {
        let [x, y] = side.corners.map(|corner| &corners[corner]);
        // In one plane, the components of both cross products have the same ratio: any certain one will do.
        let verdict = |axis: usize| match (normal[axis].sign()?, bracket.cross_along(axis, x, y).sign()?) {
            (Sign::Zero, _) => None,
            (_, Sign::Zero) => Some(Position::Inside),
            (normal, area) if (normal == area) == side.along => Some(Position::Inside),
            _ => Some(Position::Outside),
        };
        match verdict(axis).or_else(|| (0..3).find_map(verdict)) {
            Some(Position::Inside) => {}
            Some(Position::Outside) => return Some(Position::Outside),
            None => position = None,
        }
    }
    position
}

/// The axis along which a vector is the longest.
pub(super) fn longest(vector: &[Component; 3]) -> usize {
    let magnitude = |axis: usize| vector[axis].value.abs();
    (1..3).fold(0, |best, axis| {
        if magnitude(axis) > magnitude(best) {
            axis
        } else {
            best
        }
    })
}

pub(super) struct Bracket<'a, K> {
    query: &'a Query<K>,
    near: f64,
    /// A bound of the error of a difference, relative to its magnitude: two ends rounded once, (1 − t), a product and a
    /// sum, n = 4, and |d₁ − d₀| ≤ 2 max(|d₀|, |d₁|) times how far the time may be from the one it is taken at.
    slack: f64,
}

impl<'a, K: Kind> Bracket<'a, K> {
    pub(super) fn new(query: &'a Query<K>, root: &Root) -> Self {
        let radius = (root.high - root.near).max(root.near - root.low);
        Self {
            query,
            near: root.near,
            slack: 8.0 * UNIT + 4.0 * radius,
        }
    }

    pub(super) fn motion(&self, (i, j): Difference) -> Motion {
        let [start, end] = self.query.points();
        let mut motion = Motion {
            value: [0.0; 3],
            magnitude: [0.0; 3],
        };
        for axis in 0..3 {
            let (start, end) = (start[i][axis] - start[j][axis], end[i][axis] - end[j][axis]);
            motion.value[axis] = (1.0 - self.near) * start + self.near * end;
            let (start, end) = (start.abs(), end.abs());
            motion.magnitude[axis] = if start > end { start } else { end };
        }
        motion
    }

    /// The components of a × b.
    pub(super) fn cross(&self, a: &Motion, b: &Motion) -> [Component; 3] {
        [0, 1, 2].map(|axis| self.cross_along(axis, a, b))
    }

    /// A component of a × b. Each factor is off by `slack` of its magnitude, each product by 2 slack + slack² and two
    /// more roundings. Zero is certain where each product has a factor that is zero at both ends of the step, as happens
    /// when a vertex and an edge share a coordinate.
    pub(super) fn cross_along(&self, axis: usize, a: &Motion, b: &Motion) -> Component {
        let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
        let relative = 2.0 * self.slack + self.slack * self.slack + 8.0 * UNIT;
        let vanishes = |i: usize, j: usize| a.magnitude[i] == 0.0 || b.magnitude[j] == 0.0;
        let magnitude = a.magnitude[next] * b.magnitude[last] + a.magnitude[last] * b.magnitude[next];
        Component {
            value: a.value[next] * b.value[last] - a.value[last] * b.value[next],
            error: if vanishes(next, last) && vanishes(last, next) {
                0.0
            } else {
                relative * magnitude + UNDERFLOW
            },
        }
    }
}

//! Parameters and normal of a contact, by signs at its instant.

use super::instant::Instant;
use super::motion::Motion;
use super::narrowing::Narrowing;
use super::polynomial::{Vector, cross};
use crate::tables::{Difference, Point, Side, Tables};
use crate::values::Impact;

/// The primitives at an instant of contact.
struct Meeting<'a, K> {
    motion: &'a Motion<K>,
    instant: Narrowing,
}

impl<K: Tables> Motion<K> {
    /// The contact at an instant at which the primitives touch; see [`Impact`] for the cases.
    pub(super) fn impact(&self, instant: &Instant) -> Impact {
        let time = instant.round();
        // In a bracket narrower than the resolution of the ratios, approximations prove nearly
        // all of their signs.
        let instant = Narrowing::new(instant.clone());
        instant.narrow_to(80);
        let meeting = Meeting {
            motion: self,
            instant,
        };
        let crossing = !self.is_always_coplanar() && self.facing(&meeting.instant).is_some();
        let is_met = |side: &&Side| !crossing && self.lies_on(side, &meeting.instant);
        let (parameters, normal) = match K::SIDES.iter().find(is_met) {
            None => (meeting.parameters_in_plane(), meeting.normal_of_plane()),
            Some(side) => meeting.vertex_on_edge(side),
        };
        Impact {
            time,
            parameters,
            normal,
        }
    }
}

impl<K: Tables> Meeting<'_, K> {
    /// The difference of two points, times the weight, with one unit for all axes.
    fn vector(&self, difference: Difference) -> Vector {
        let points = &self.motion.points;
        points.to_scale(points.weighted_difference(difference))
    }

    /// The direction of a vector in the coordinates of the world, unless it vanishes.
    fn direction(&self, vector: Vector) -> Option<Point> {
        self.instant.direction(self.motion.points.to_world(vector))
    }

    /// (u, v) as ratios of the sides' areas to the normal, which does not vanish.
    fn parameters_in_plane(&self) -> [f64; 2] {
        let Some((axis, facing)) = self.motion.facing(&self.instant) else {
            return [0.0; 2];
        };
        let normal = self.motion.normal[axis].clone();
        K::PARAMETERS.map(|index| {
            let side = &K::SIDES[index];
            let area = self.motion.side(side, axis);
            let reversed = facing.is_lt() == side.along;
            self.instant.ratio(
                &if reversed { -area } else { area },
                &if facing.is_lt() {
                    -normal.clone()
                } else {
                    normal.clone()
                },
            )
        })
    }

    /// The normal of the common plane, on the side on which the first primitive is just before the
    /// contact. The first derivative of c that does not vanish determines the sign of c there.
    fn normal_of_plane(&self) -> Option<Point> {
        let [_, e1, e2] = K::SPAN.map(|difference| self.vector(difference));
        let normal = self.direction(cross(&e1, &e2))?;
        let mut derivative = self.motion.volume.clone();
        let mut is_above = true;
        while !derivative.is_zero() {
            let sign = self.instant.sign(&derivative);
            if sign.is_ne() {
                is_above = sign.is_gt() == is_above;
                break;
            }
            derivative = derivative.velocity();
            is_above = !is_above;
        }
        Some(if is_above { normal } else { normal.map(|x| -x) })
    }

    /// Parameters and normal where a vertex meets an edge: the normal opposes the velocity of the
    /// first primitive relative to the second, across the line of the edge.
    fn vertex_on_edge(&self, side: &Side) -> ([f64; 2], Option<Point>) {
        let [x, y] = side.edge;
        let (offset, edge) = (self.vector((side.vertex, x)), self.vector((y, x)));
        let velocity = |vector: &Vector| [0, 1, 2].map(|axis: usize| vector[axis].velocity());
        let mut relative = velocity(&offset);
        let mut along = 0.0;
        let axis = (0..3).find(|&axis| self.instant.sign(&edge[axis]).is_ne());
        if let Some(axis) = axis {
            // The vertex is at x + s (y − x), s = offset / edge on this axis.
            let reversed = self.instant.sign(&edge[axis]).is_lt();
            let [above, below] = [&offset, &edge].map(|vector| {
                let component = vector[axis].clone();
                if reversed { -component } else { component }
            });
            along = self.instant.ratio(&above, &below);
            let of_edge = velocity(&edge);
            relative = [0, 1, 2].map(|axis: usize| &(&below * &relative[axis]) - &(&above * &of_edge[axis]));
        }
        let is_of_first = side.vertex < x;
        let towards_first = relative.map(|component| if is_of_first { -component } else { component });

        (
            side.parameters(along),
            self.direction(self.across_line(edge, towards_first)),
        )
    }

    /// The part of a vector that is orthogonal to the line that holds both primitives, if they have
    /// one, up to a positive factor.
    fn across_line(&self, edge: Vector, vector: Vector) -> Vector {
        let [_, e1, e2] = K::SPAN.map(|difference| self.vector(difference));
        let is_point = |line: &Vector| line.iter().all(|component| self.instant.sign(component).is_eq());
        match [edge, e1, e2].into_iter().find(|line| !is_point(line)) {
            Some(line) => cross(&line, &cross(&vector, &line)),
            None => vector,
        }
    }
}

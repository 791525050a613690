//! The four moving points and the distance d in integers of one unit.

use alloc::vec::Vec;

use dashu_int::IBig;

use super::feature::{Feature, Pair};
use crate::exact::dyadic::{decompose, to_integers};
use crate::exact::motion::common;
use crate::exact::narrowing::Narrowing;
use crate::exact::points::MovingPoints;
use crate::exact::polynomial::{Polynomial, Vector, cross, dot, squared_length};
use crate::tables::{Difference, Point, Points, Side, Tables};
use crate::values::Separation;

/// The points of a query as polynomials in t, and d², with one unit for all axes and d: unlike
/// contact, distance is not invariant under a scaling of one axis.
#[derive(Clone, Debug)]
pub(super) struct Scaled {
    points: MovingPoints,
    squared_separation: Polynomial,
    /// The coordinates are integers times two to this power.
    pub(super) unit: i32,
}

impl Scaled {
    pub(super) fn new(points: &MovingPoints, d: Separation) -> Self {
        let ([separation], of_separation) = to_integers([d.get()]);
        let unit = points.least_unit().into_iter().chain(of_separation).min();
        let unit = unit.unwrap_or_default();
        let separation = separation << of_separation.map_or(0, |own| (own - unit) as usize);
        Self {
            squared_separation: points.length(separation).squared(),
            points: points.scaled_to(unit),
            unit,
        }
    }

    /// The points at one time, as constant polynomials, and d = 0.
    pub(super) fn at(points: &Points<f64>, t: f64) -> Self {
        let (numerator, exponent) = decompose(t);
        let scaled = Self::new(&MovingPoints::along(points), Separation::ZERO);
        let at_time = |coordinate: &Polynomial| {
            let (start, end) = (coordinate.at_start(), coordinate.at_end());
            let moved = (end - &start) * IBig::from(numerator);
            Polynomial::constant((start << exponent.unsigned_abs() as usize) + moved)
        };
        Self {
            points: scaled.points.map(at_time),
            squared_separation: Polynomial::constant(IBig::ZERO),
            unit: scaled.unit + exponent,
        }
    }

    pub(super) fn difference(&self, difference: Difference) -> Vector {
        self.points.difference(difference)
    }

    /// The difference of two points, times the weight.
    pub(super) fn weighted_difference(&self, difference: Difference) -> Vector {
        self.points.weighted_difference(difference)
    }

    /// The direction of a vector in the coordinates of the world, unless it vanishes.
    pub(super) fn direction(&self, vector: Vector, instant: &Narrowing) -> Option<Point> {
        instant.direction(self.points.to_world(vector))
    }

    /// The volume and the normal of both primitives' plane.
    pub(super) fn plane<K: Tables>(&self) -> (Polynomial, Vector) {
        self.points.plane::<K>()
    }

    /// The features of the primitives.
    pub(super) fn features<K: Tables>(&self) -> Vec<Feature> {
        let one = Polynomial::constant(IBig::ONE);
        let squared_weight = || self.points.frame().map(|frame| frame.weight().squared());
        let vertices = K::FEATURES.vertices.iter().map(|&(difference, parameters)| {
            let x = self.difference(difference);
            (
                Pair::Vertices(difference, parameters),
                one.clone(),
                [
                    squared_length(&x),
                    squared_weight().unwrap_or_else(|| one.clone()),
                ],
                Vec::new(),
            )
        });
        let sides = K::FEATURES.sides.iter().map(|side| {
            let [a, b] = side.edge;
            let (x, e) = (
                self.difference((side.vertex, a)),
                self.weighted_difference((b, a)),
            );
            let along = dot(&e, &x);
            let beyond = &squared_length(&e) - &along;
            let (length, across, direction) = self.line(side, e, &x);
            (
                Pair::VertexEdge(side),
                length,
                [squared_length(&across), squared_length(&direction)],
                [along, beyond].into(),
            )
        });
        let inner = K::FEATURES.inner.map(|_| {
            let (volume, n) = self.plane::<K>();
            let guards = self.guards_of_inner::<K>(&n);
            let (length, volume, direction) = self.without_factor(volume, n);
            let quotient = [volume.squared(), squared_length(&direction)];
            (Pair::Inner, length, quotient, guards)
        });
        vertices
            .chain(sides)
            .chain(inner)
            .map(|(pair, length, quotient, guards)| {
                Feature::new(pair, length, quotient, guards, &self.squared_separation)
            })
            .collect()
    }

    /// The edge e of a side as the product of a factor and a direction, with e × x divided by that factor.
    ///
    /// The edge of a body does not vanish at any time, or it always does: the factor is constant.
    fn line(&self, side: &Side, e: Vector, x: &Vector) -> (Polynomial, Vector, Vector) {
        if self.points.frame().is_some() {
            let exists = e.iter().any(|component| !component.is_zero());
            let length = Polynomial::constant(i32::from(exists).into());
            return (length, self.points.areas(side), e);
        }
        let length = common(e.clone());
        let direction = over(e, &length);
        (length, cross(&direction, x), direction)
    }

    /// The normal as the product of a factor and a direction, with the volume divided by that factor.
    ///
    /// With a weight w, the volume is w · n over w, which the factor divides if it has no part in common
    /// with w.
    fn without_factor(&self, volume: Polynomial, n: Vector) -> (Polynomial, Polynomial, Vector) {
        let mut length = common(n.clone());
        if let Some(frame) = self.points.frame() {
            length = length.coprime_to(frame.weight());
        }
        let direction = over(n, &length);
        let [volume] = over([volume], &length);
        (length, volume, direction)
    }

    /// ±n · ((x − q) × (y − q)) for each vertex q and edge x y, in the order of the sides. Over n · n, they
    /// are u and v, and 1 − u − v for a triangle, otherwise 1 − u and 1 − v.
    fn guards_of_inner<K: Tables>(&self, n: &Vector) -> Vec<Polynomial> {
        let [u, v] = K::PARAMETERS.map(|index| {
            let side = &K::SIDES[index];
            let area = dot(n, &self.points.areas(side));
            if side.along { area } else { -area }
        });
        let whole = squared_length(n);
        let beyond_u = &whole - &u;
        if K::FEATURES.are_of_triangle() {
            [v.clone(), &beyond_u - &v, u].into()
        } else {
            let beyond_v = &whole - &v;
            [u, beyond_u, v, beyond_v].into()
        }
    }
}

/// Polynomials over a common factor of them, if it has roots. So a direction vanishes at no time, unless its
/// vector is always zero.
fn over<const N: usize>(polynomials: [Polynomial; N], factor: &Polynomial) -> [Polynomial; N] {
    if factor.degree() == 0 || factor.is_zero() {
        polynomials
    } else {
        polynomials.map(|polynomial| polynomial.over(factor))
    }
}

//! The four moving points and the distance d in integers of one unit.

use alloc::vec::Vec;

use dashu_int::IBig;

use super::feature::{Feature, Pair};
use crate::exact::dyadic::{decompose, to_integers};
use crate::exact::motion::common;
use crate::exact::points::MovingPoints;
use crate::exact::polynomial::{Polynomial, Vector, cross, dot, squared_length};
use crate::tables::{Difference, Points, Tables};
use crate::values::Separation;

/// The points of a query as polynomials in t, and d², with one unit for all axes and d: unlike
/// contact, distance is not invariant under a scaling of one axis.
#[derive(Clone, Debug)]
pub(super) struct Approach {
    points: MovingPoints,
    squared_separation: Polynomial,
    /// The coordinates are integers times two to this power.
    pub(super) unit: i32,
}

impl Approach {
    pub(super) fn new(points: &Points<f64>, d: Separation) -> Self {
        let points = MovingPoints::new(points);
        let ([separation], of_separation) = to_integers([d.get()]);
        let unit = points.least_unit().into_iter().chain(of_separation).min();
        let unit = unit.unwrap_or_default();
        let separation = separation << of_separation.map_or(0, |own| (own - unit) as usize);
        let separation = Polynomial::between(&separation, &separation);
        Self {
            points: points.scaled_to(unit),
            squared_separation: separation.squared(),
            unit,
        }
    }

    /// The points at one time, as constant polynomials, and d = 0.
    pub(super) fn at(points: &Points<f64>, t: f64) -> Self {
        let (numerator, exponent) = decompose(t);
        let approach = Self::new(points, Separation::ZERO);
        let at_time = |coordinate: &Polynomial| {
            let (start, end) = (coordinate.at_start(), coordinate.at_end());
            let moved = (end - &start) * IBig::from(numerator);
            Polynomial::constant((start << exponent.unsigned_abs() as usize) + moved)
        };
        Self {
            points: approach.points.map(at_time),
            squared_separation: Polynomial::constant(IBig::ZERO),
            unit: approach.unit + exponent,
        }
    }

    pub(super) fn difference(&self, difference: Difference) -> Vector {
        self.points.difference(difference)
    }

    /// The features of the primitives.
    pub(super) fn features<K: Tables>(&self) -> Vec<Feature> {
        let vertices = K::FEATURES.vertices.iter().map(|&(difference, parameters)| {
            let x = self.difference(difference);
            (
                Pair::Vertices(difference, parameters),
                Polynomial::constant(IBig::ONE),
                [squared_length(&x), Polynomial::constant(IBig::ONE)],
                Vec::new(),
            )
        });
        let sides = K::FEATURES.sides.iter().map(|side| {
            let [a, b] = side.edge;
            let (x, e) = (self.difference((side.vertex, a)), self.difference((b, a)));
            let along = dot(&e, &x);
            let beyond = &squared_length(&e) - &along;
            let (length, direction) = factor(e);
            let across = cross(&direction, &x);
            (
                Pair::VertexEdge(side),
                length,
                [squared_length(&across), squared_length(&direction)],
                [along, beyond].into(),
            )
        });
        let inner = K::FEATURES.inner.map(|_| {
            let [w, e1, e2] = K::SPAN.map(|difference| self.difference(difference));
            let n = cross(&e1, &e2);
            let guards = self.guards_of_inner::<K>(&n);
            let (length, direction) = factor(n);
            let volume = dot(&w, &direction);
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

    /// ±n · ((x − q) × (y − q)) for each vertex q and edge x y, in the order of the sides. Over n · n, they
    /// are u and v, and 1 − u − v for a triangle, otherwise 1 − u and 1 − v.
    fn guards_of_inner<K: Tables>(&self, n: &Vector) -> Vec<Polynomial> {
        let [u, v] = K::PARAMETERS.map(|index| {
            let side = &K::SIDES[index];
            let [x, y] = side.edge.map(|end| self.difference((end, side.vertex)));
            let area = dot(n, &cross(&x, &y));
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

/// A vector as the product of a common factor of its components, which vanishes when it does, and of a
/// direction, which vanishes at no time unless the vector is always zero.
fn factor(vector: Vector) -> (Polynomial, Vector) {
    let length = common(vector.clone());
    let direction = if length.coefficients().len() == 1 || length.is_zero() {
        vector
    } else {
        vector.map(|component| component.over(&length))
    };
    (length, direction)
}

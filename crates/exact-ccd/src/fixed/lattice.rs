//! A query in integers of fixed width, and the contact of its primitives by the signs of quadratics.

use core::array::from_fn;
use core::cell::OnceCell;
use core::cmp::Ordering;
use core::marker::PhantomData;

use super::common_root::{Quadratics, vanishes_at_cubic_root};
use super::factors::{Ends, Factors, difference};
use super::fraction::Fraction;
use super::length::{Area, Length, Volume};
use super::moment::Moment;
use super::wide::Wide;
use crate::exact::parts;
use crate::tables::{Difference, Points, Side, Tables};

/// The points of a query in integers, each axis in a unit of its own: contact is invariant under such
/// scalings.
#[expect(
    clippy::large_enum_variant,
    reason = "a local variable, which is not moved or stored"
)]
pub(super) enum Integers<K> {
    Short(Lattice<K, i64>),
    Long(Lattice<K, i128>),
}

impl<K: Tables> Integers<K> {
    /// The query in units that make all coordinates integers; `None` if these are too long.
    pub(super) fn new(points: &Points<f64>) -> Option<Self> {
        let exponents = from_fn(|axis| parts(extent(points, axis)).1);
        let short = Lattice::new(points, exponents).map(Self::Short);
        short.or_else(|| Lattice::new(points, exponents).map(Self::Long))
    }

    /// The first coefficient of the coplanarity cubic: the volume of the points at t = 0.
    pub(super) fn volume_at_start(&self) -> Volume {
        match self {
            Self::Short(lattice) => lattice.volume_at_start(),
            Self::Long(lattice) => lattice.volume_at_start(),
        }
    }

    /// The coplanarity cubic c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³.
    pub(super) fn cubic(&self) -> [Volume; 4] {
        match self {
            Self::Short(lattice) => cubic(&lattice.span()),
            Self::Long(lattice) => cubic(&lattice.span()),
        }
    }

    /// The coplanarity cubic without its linear [`Factors`], times a constant, in the same form.
    pub(super) fn rest_of_cubic(&self) -> [Volume; 4] {
        match self {
            Self::Short(lattice) => lattice.rest_of_cubic(),
            Self::Long(lattice) => lattice.rest_of_cubic(),
        }
    }

    /// The times at which the factors vanish.
    pub(super) fn zeros_of_factors(&self) -> &[Fraction] {
        match self {
            Self::Short(lattice) => &lattice.factors().zeros,
            Self::Long(lattice) => &lattice.factors().zeros,
        }
    }

    /// The quadratics that are not zero and whose signs decide contact if the points are coplanar at all
    /// times.
    pub(super) fn quadratics(&self) -> Quadratics {
        match self {
            Self::Short(lattice) => lattice.quadratics(),
            Self::Long(lattice) => lattice.quadratics(),
        }
    }

    /// Returns true if the primitives touch at each time of a moment, false if they do so at none, if it is
    /// certain; the four points are coplanar then. The tests are the same as on the exact path.
    pub(super) fn touches(&self, moment: &Moment) -> Option<bool> {
        match self {
            Self::Short(lattice) => lattice.position(moment),
            Self::Long(lattice) => lattice.position(moment),
        }
    }

    /// A moment, in a narrower window if that is necessary, and true if the primitives touch then; `None` if
    /// that is not certain.
    pub(super) fn decided(
        &self,
        mut moment: Moment,
        narrowed: impl Fn(&Moment) -> Option<Moment>,
    ) -> Option<(Moment, bool)> {
        for _ in 0..MOST_NARROWINGS {
            if let Some(touches) = self.touches(&moment) {
                return Some((moment, touches));
            }
            moment = narrowed(&moment)?;
        }
        let touches = self.touches(&moment)?;
        Some((moment, touches))
    }
}

/// The number of times that a window is made narrower.
const MOST_NARROWINGS: usize = 2;

/// The points in integers of one width.
pub(super) struct Lattice<K, L> {
    points: Points<L>,
    /// The factors, computed on first use.
    factors: OnceCell<Factors<L>>,
    kind: PhantomData<K>,
}

impl<K: Tables, L: Length> Lattice<K, L> {
    /// The points, given the exponent of the largest coordinate of each axis, if all are short enough.
    #[inline(always)]
    fn new(points: &Points<f64>, exponents: [i32; 3]) -> Option<Self> {
        let mut are_integers = true;
        let points = points.map(|end| {
            end.map(|point| {
                from_fn(|axis| {
                    let (mantissa, exponent) = parts(point[axis]);
                    let (coordinate, is_integer) = L::scaled(mantissa, (exponents[axis] - exponent) as u32);
                    are_integers &= is_integer;
                    coordinate
                })
            })
        });
        are_integers.then(|| Self {
            points,
            factors: OnceCell::new(),
            kind: PhantomData,
        })
    }

    fn factors(&self) -> &Factors<L> {
        self.factors.get_or_init(|| Factors::new(&self.points))
    }

    fn span(&self) -> [Ends<L>; 3] {
        K::SPAN.map(|span| difference(&self.points, span))
    }

    fn volume_at_start(&self) -> Volume {
        let [w, e1, e2] = self.span().map(|[start, _]| start);
        volume(w, [0, 1, 2].map(|axis| component(axis, e1, e2)))
    }

    /// A difference of two points. No factor vanishes at a root: axes with one of the [`Factors`] are at
    /// rest.
    #[inline(always)]
    fn difference(&self, moment: &Moment, of: Difference) -> Ends<L> {
        let points = match moment {
            Moment::Root(..) => &self.factors().at_rest,
            Moment::At(_) | Moment::QuadraticRoot(_) | Moment::Later => &self.points,
        };
        difference(points, of)
    }

    fn position(&self, moment: &Moment) -> Option<bool> {
        self.touches(moment)
            .or_else(|| self.is_apart(moment).then_some(false))
    }

    /// Returns true if an axis separates the primitives at all times of a moment: F has one strict sign there
    /// at all corners of its domain, hence everywhere.
    fn is_apart(&self, moment: &Moment) -> bool {
        let side = |axis: usize, corner| {
            let [start, end] = self.difference(moment, corner).map(|ends| ends[axis]);
            moment.sign_of_linear([start.value(), end.value()])
        };
        (0..3).any(|axis| {
            let first = side(axis, K::CORNERS[0]);
            let has_side = |&corner: &Difference| side(axis, corner) == first;
            first.is_some() && K::CORNERS[1..].iter().all(has_side)
        })
    }

    fn touches(&self, moment: &Moment) -> Option<bool> {
        let span = [1, 2].map(|i: usize| self.difference(moment, K::SPAN[i]));
        let mut facing = Some(Ordering::Equal);
        let mut along = 0;
        for axis in 0..3 {
            match self.sign(moment, &span, |a, b| component(axis, a, b)) {
                Some(Ordering::Equal) => {}
                None => facing = None,
                certain => {
                    (facing, along) = (certain, axis);
                    break;
                }
            }
        }
        let facing = facing?;
        if facing.is_eq() {
            return holds(K::SIDES.iter().map(|side| self.lies_on(side, moment)), true);
        }
        let is_inside = |side: &Side| {
            let edge = self.edge(side, moment);
            let inside = if side.along { facing } else { facing.reverse() };
            let sign = self.sign(moment, &edge, |a, b| component(along, a, b))?;
            Some(sign.is_eq() || sign == inside)
        };
        holds(K::SIDES.iter().map(is_inside), false)
    }

    /// The normal and the sides along one axis if the normal is not zero there at all times. Otherwise, the
    /// primitives are parallel at all times, and vertices lie on edges or do not.
    fn quadratics(&self) -> Quadratics {
        let mut quadratics = Quadratics::new();
        let mut push = |[a, b]: [Ends<L>; 2], product: &dyn Fn([L; 3], [L; 3]) -> L::Area| {
            let quadratic = [0, 1, 2].map(|i| coefficient_of(i, &a, &b, product).widened());
            let is_zero = quadratic.iter().all(Wide::is_zero);
            // There is space for all of them.
            let _ = is_zero || quadratics.try_push(quadratic).is_err();
            !is_zero
        };
        let span = [1, 2].map(|i: usize| difference(&self.points, K::SPAN[i]));
        let edges = || {
            K::SIDES
                .iter()
                .map(|side| side.edge.map(|end| difference(&self.points, (end, side.vertex))))
        };
        let normal = (0..3).find(|&axis| push(span, &|a, b| component(axis, a, b)));
        match normal {
            Some(axis) => edges().for_each(|edge| {
                push(edge, &|a, b| component(axis, a, b));
            }),
            None => edges().for_each(|edge| {
                (0..3).for_each(|axis| {
                    push(edge, &|a, b| component(axis, a, b));
                });
                push(edge, &dot);
            }),
        }
        quadratics
    }

    /// The sign of a bilinear product of two differences at a moment. Where roundings leave it open, it may
    /// be zero because the product and the polynomial of the moment have a root in common.
    #[inline(always)]
    fn sign(
        &self,
        moment: &Moment,
        [a, b]: &[Ends<L>; 2],
        product: impl Fn([L; 3], [L; 3]) -> L::Area,
    ) -> Option<Ordering> {
        let coefficient = |i| coefficient_of(i, a, b, &product);
        moment.sign(coefficient).or_else(|| {
            let quadratic = || [0, 1, 2].map(|i| coefficient(i).widened());
            let is_zero = match moment {
                Moment::Root(window, root) => {
                    vanishes_at_cubic_root(&quadratic(), &self.rest_of_cubic(), window.bracket(root))
                }
                Moment::QuadraticRoot(root) => root.is_root_of(&quadratic()),
                Moment::At(_) | Moment::Later => false,
            };
            is_zero.then_some(Ordering::Equal)
        })
    }

    /// The coplanarity cubic without its factors.
    fn rest_of_cubic(&self) -> [Volume; 4] {
        cubic(&self.factors().rows)
    }

    /// Returns true if a vertex lies on an edge.
    fn lies_on(&self, side: &Side, moment: &Moment) -> Option<bool> {
        let edge = self.edge(side, moment);
        let is_on_line = |axis| Some(self.sign(moment, &edge, |a, b| component(axis, a, b))?.is_eq());
        if holds((0..3).map(is_on_line), false)? {
            return self.sign(moment, &edge, dot).map(Ordering::is_le);
        }
        Some(false)
    }

    /// The ends of an edge, from a vertex.
    fn edge(&self, side: &Side, moment: &Moment) -> [Ends<L>; 2] {
        side.edge.map(|end| self.difference(moment, (end, side.vertex)))
    }
}

/// The largest magnitude of a coordinate along an axis.
fn extent(points: &Points<f64>, axis: usize) -> f64 {
    let magnitudes = points.as_flattened().iter().map(|point| point[axis].abs());
    magnitudes.fold(0.0, |most, x| if x > most { x } else { most })
}

/// The determinant of three differences: its coefficients in the form of the cubic.
fn cubic<L: Length>([w, e1, e2]: &[Ends<L>; 3]) -> [Volume; 4] {
    let normal =
        |coefficient| [0, 1, 2].map(|axis| coefficient_of(coefficient, e1, e2, |a, b| component(axis, a, b)));
    let [start, mixed, end] = [0, 1, 2].map(normal);
    [
        volume(w[0], start),
        volume(w[1], start) + volume(w[0], mixed),
        volume(w[0], end) + volume(w[1], mixed),
        volume(w[1], end),
    ]
}

/// `Some(decisive)` if a condition certainly equals `decisive`. `Some(!decisive)` if all conditions are
/// certain and none equals `decisive`. Otherwise `None`.
fn holds(conditions: impl Iterator<Item = Option<bool>>, decisive: bool) -> Option<bool> {
    let mut result = Some(!decisive);
    for condition in conditions {
        match condition {
            Some(holds) if holds == decisive => return Some(decisive),
            Some(_) => {}
            None => result = None,
        }
    }
    result
}

/// One of the coefficients q₀, q₁, q₂ of a bilinear product of two differences.
#[inline(always)]
fn coefficient_of<L: Length>(
    coefficient: usize,
    a: &Ends<L>,
    b: &Ends<L>,
    product: impl Fn([L; 3], [L; 3]) -> L::Area,
) -> L::Area {
    match coefficient {
        0 => product(a[0], b[0]),
        1 => product(a[0], b[1]) + product(a[1], b[0]),
        _ => product(a[1], b[1]),
    }
}

/// One component of a × b.
#[inline(always)]
fn component<L: Length>(axis: usize, a: [L; 3], b: [L; 3]) -> L::Area {
    let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
    a[next].times(b[last]) - a[last].times(b[next])
}

#[inline(always)]
fn dot<L: Length>(a: [L; 3], b: [L; 3]) -> L::Area {
    a[0].times(b[0]) + a[1].times(b[1]) + a[2].times(b[2])
}

/// The scalar product of a difference and a normal.
#[inline(always)]
fn volume<L: Length>([x, y, z]: [L; 3], normal: [L::Area; 3]) -> Volume {
    x.volume(normal[0]) + y.volume(normal[1]) + z.volume(normal[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::VertexFace;

    #[test]
    fn integers_are_short_or_long_or_none_by_the_longest_axis() {
        for exponent in [-900, -30, 0, 700] {
            for bits in 1..150 {
                let unit = libm::ldexp(1.0, exponent);
                let far = libm::ldexp(unit, bits - 1);
                let start = [[unit, 0.0, far], [unit; 3], [far, unit, unit], [0.0; 3]];
                let points = [start, [[unit; 3]; 4]];
                let is_as_expected = match Integers::<VertexFace>::new(&points) {
                    Some(Integers::Short(_)) => bits <= 61,
                    Some(Integers::Long(_)) => bits > 61 && bits <= 123,
                    None => bits > 123,
                };
                assert!(is_as_expected, "{exponent} {bits}");
            }
        }
    }
}

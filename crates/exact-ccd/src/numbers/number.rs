//! The arithmetic of the filters: f64 for the decisions, one query or eight at a time, and
//! [`DoubleDouble`](super::double_double::DoubleDouble) for the last bit of a time.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use crate::tables::Difference;

/// One f64 or several side by side. Each lane computes the same bits, whatever their number.
pub(crate) trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<Output = Self>
    + Div<f64, Output = Self>
{
    /// A bool for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// A number with this value in each lane.
    fn splat(self, value: f64) -> Self;

    /// True in each lane that is greater than the same lane of another number; never for a NaN.
    fn gt(self, other: Self) -> Self::Mask;

    /// Returns true if a lane is true.
    fn any(mask: Self::Mask) -> bool;

    fn abs(self) -> Self;

    fn sqrt(self) -> Self;

    /// One number in the lanes of a mask, another one elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The smaller of two numbers that are not NaN.
    fn min(self, other: Self) -> Self;

    /// The larger of two numbers that are not NaN.
    fn max(self, other: Self) -> Self;
}

impl Lanes for f64 {
    type Mask = bool;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn gt(self, other: Self) -> bool {
        self > other
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

/// Numbers that are added, subtracted and multiplied.
pub(crate) trait Ring: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Ring for T {}

/// An approximation of a real number.
pub(crate) trait Number: Ring {
    /// The type of coordinates and bounds.
    type Real: Lanes;

    fn difference(a: Self::Real, b: Self::Real) -> Self;

    /// The nearest f64.
    fn value(self) -> Self::Real;
}

impl<T: Lanes> Number for T {
    type Real = Self;

    #[inline(always)]
    fn difference(a: Self, b: Self) -> Self {
        a - b
    }

    #[inline(always)]
    fn value(self) -> Self {
        self
    }
}

/// The four points of a query at t = 0 and at t = 1.
pub(crate) type Points<T> = [[[T; 3]; 4]; 2];

/// The difference of two points at t = 0 and at t = 1.
#[inline(always)]
pub(crate) fn subtract<T: Number>(points: &Points<T::Real>, (i, j): Difference) -> [[T; 3]; 2] {
    let minus = |a: [T::Real; 3], b: [T::Real; 3]| {
        [
            T::difference(a[0], b[0]),
            T::difference(a[1], b[1]),
            T::difference(a[2], b[2]),
        ]
    };
    let [start, end] = points;
    [minus(start[i], start[j]), minus(end[i], end[j])]
}

/// The larger magnitude of a coordinate at the two times.
#[inline(always)]
pub(crate) fn reach<T: Number, const N: usize>([a, b]: &[[T; N]; 2]) -> [T::Real; N] {
    let mut reach = a.map(Number::value);
    for axis in 0..N {
        reach[axis] = a[axis].value().abs().max(b[axis].value().abs());
    }
    reach
}

//! The positions of all vertices as integers, and times as ratios.
//!
//! A finite f64 is an integer times a power of two. Divided by the least such power of all coordinates
//! and of the distance, all of them are integers. At the time t = k / 2^m, a vertex that moves from a
//! to b is at ((2^m − k) a + k b) / 2^m, and 2^m times that is an integer again.

use dashu_int::IBig;

use crate::failure::{Failure, unreadable};

/// A point with integer coordinates.
pub type Point = [IBig; 3];

/// A finite f64 as an integer, odd or 0, times a power of two; `None` for others.
pub fn dyadic(x: f64) -> Option<(i64, i32)> {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 2047) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (mantissa, exponent) = match (exponent, fraction) {
        (2047, _) => return None,
        // 0 gets the exponent of the largest f64: it is no reason for a smaller unit.
        (0, 0) => return Some((0, 971)),
        (0, _) => (fraction, -1074),
        _ => (fraction | 1 << 52, exponent - 1075),
    };
    let zeros = mantissa.trailing_zeros();
    let mantissa = mantissa >> zeros;
    Some((if bits >> 63 == 0 { mantissa } else { -mantissa }, exponent + zeros as i32))
}

/// A mesh in motion from one frame to the next, and the distance that counts as contact.
pub struct Motion {
    /// The positions at t = 0 and at t = 1.
    pub(crate) ends: [Vec<Point>; 2],
    /// The distance that counts as contact.
    pub(crate) distance: IBig,
}

impl Motion {
    /// The motion from the first positions to the second, with a distance d ≥ 0.
    ///
    /// # Errors
    /// If a number is not finite, d is negative, or there are not as many vertices in both.
    pub fn new(start: &[[f64; 3]], end: &[[f64; 3]], d: f64) -> Result<Self, Failure> {
        if start.len() != end.len() {
            return unreadable("the frames have different numbers of vertices");
        }
        let mut unit = 971;
        for &x in start.as_flattened().iter().chain(end.as_flattened()).chain([&d]) {
            let Some((_, exponent)) = dyadic(x) else {
                return unreadable("a coordinate, or the distance, is infinite or not a number");
            };
            unit = unit.min(exponent);
        }
        let whole = |x: f64| {
            let (mantissa, exponent) = dyadic(x).unwrap_or_default();
            IBig::from(mantissa) << (exponent - unit).max(0) as usize
        };
        let distance = whole(d);
        if distance < IBig::ZERO {
            return unreadable("the distance is negative");
        }
        let ends = [start, end].map(|x| x.iter().map(|point| point.map(whole)).collect());
        Ok(Self { ends, distance })
    }

    /// The position of a vertex at a time, and the distance, both times the denominator of the time.
    ///
    /// `vertex` is below the number of vertices.
    pub fn at(&self, vertex: u32, time: &Time) -> Point {
        let [a, b] = [0, 1].map(|end: usize| &self.ends[end][vertex as usize]);
        let rest = (IBig::ONE << time.power) - &time.numerator;
        std::array::from_fn(|axis| &rest * &a[axis] + &time.numerator * &b[axis])
    }
}

/// The time numerator / 2^power in [0, 1].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Time {
    /// From 0 to 2^power.
    pub numerator: IBig,
    /// The logarithm of the denominator.
    pub power: usize,
}

impl Time {
    /// Numbers in [0, 1] over one denominator, the least one.
    pub fn together<const N: usize>(times: [f64; N]) -> [Self; N] {
        let dyadic = times.map(|t| dyadic(t).unwrap_or_default());
        let least = dyadic.iter().fold(0, |least, (_, exponent)| least.min(*exponent));
        dyadic.map(|(mantissa, exponent)| Self {
            numerator: IBig::from(mantissa) << (exponent - least) as usize,
            power: -least as usize,
        })
    }
}

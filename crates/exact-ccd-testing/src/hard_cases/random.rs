//! Pseudorandom numbers, coordinates and points, the same on every machine.

use crate::primitives::Points;

/// Vigna's SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// An integer from 0 to below the bound, which is not 0.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound as u64) as usize
    }

    /// A number in [−1, 1].
    pub fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// An integer of magnitude at most `radius`.
    pub fn integer(&mut self, radius: usize) -> f64 {
        self.below(2 * radius + 1) as f64 - radius as f64
    }

    /// A finite number with any sign, exponent and fraction.
    pub fn any(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }

    /// One of the least and the largest numbers.
    pub fn extreme(&mut self) -> f64 {
        let magnitudes = [
            5e-324,
            1.5e-323,
            f64::MIN_POSITIVE,
            f64::MAX / 4.0,
            1e308,
            f64::MAX,
        ];
        let magnitude = magnitudes[self.below(magnitudes.len())];
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    /// Points with random coordinates.
    pub fn points(&mut self, mut coordinate: impl FnMut(&mut Self) -> f64) -> Points {
        let mut points = Points::default();
        for x in points.as_flattened_mut().as_flattened_mut() {
            *x = coordinate(self);
        }
        points
    }

    /// Points with coordinates in [−1, 1].
    pub fn fractions(&mut self) -> Points {
        self.points(Self::fraction)
    }

    /// Points with integer coordinates of magnitude at most 4.
    pub fn small_integers(&mut self) -> Points {
        self.points(|random| random.integer(4))
    }

    /// (t, u, v), in quarters.
    pub fn place(&mut self) -> [f64; 3] {
        let t = self.below(5) as f64 / 4.0;
        let u = self.below(5);
        [t, u as f64 / 4.0, self.below(5 - u) as f64 / 4.0]
    }

    /// The numbers from 0 to 3 in any order.
    pub fn order(&mut self) -> [usize; 4] {
        let mut order = [0, 1, 2, 3];
        for i in 1..4 {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}

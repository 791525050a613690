//! Pseudo-random numbers (SplitMix64).

pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [−1, 1) with 53 bits.
    pub fn number(&mut self) -> f64 {
        (self.bits() as i64 >> 11) as f64 / (1_u64 << 52) as f64
    }

    /// An integer from −size to size.
    pub fn integer(&mut self, size: u64) -> f64 {
        (self.bits() % (2 * size + 1)) as f64 - size as f64
    }
}

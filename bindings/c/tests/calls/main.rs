//! Calls with arguments from random bytes, with a fixed seed.

#[path = "calls.rs"]
mod calls;

#[test]
fn calls_with_random_arguments_keep_the_rules_of_the_interface() {
    let mut random = Random(1);
    let mut bytes = [0; 600];
    for _ in 0..3_000 {
        bytes.fill_with(|| random.byte());
        calls::check(&bytes);
    }
}

/// Marsaglia's xorshift generator.
struct Random(u64);

impl Random {
    fn byte(&mut self) -> u8 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u8
    }
}

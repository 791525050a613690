//! Calls with arguments from random bytes, with a fixed seed.

// The fuzz target of the C interface has it too.
#[path = "calls.rs"]
mod calls;

/// `EXACT_CCD_CALLS` is the number of rounds: fewer under valgrind.
#[test]
fn calls_with_random_arguments_keep_the_rules_of_the_interface() {
    let rounds = std::env::var("EXACT_CCD_CALLS").map_or(3_000, |rounds| rounds.parse().expect("a number"));
    let mut random = Random(1);
    let mut bytes = [0; 600];
    let mut contacts = 0;
    for _ in 0..rounds {
        bytes.fill_with(|| random.byte());
        contacts += calls::check(&bytes);
    }
    assert!(contacts > rounds / 4, "{contacts} contacts in {rounds} rounds");
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

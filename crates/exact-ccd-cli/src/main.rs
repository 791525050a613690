//! The `exact-ccd` program.

fn main() {}

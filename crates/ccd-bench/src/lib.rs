//! Data sets and benchmarks.

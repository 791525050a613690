//! The answers to queries, against their definition, their symmetries, and independent truth.

mod agreement;
mod generators;
mod laws;
mod primitives;
mod runner;

//! The answers to queries, against their definition, their symmetries, and independent truth.

mod agreement;
mod cuts;
mod generators;
mod invariance;
mod laws;
mod primitives;
mod runner;
mod symmetry;

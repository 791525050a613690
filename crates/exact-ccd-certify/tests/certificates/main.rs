//! Certificates, made and verified: of the examples, and of generated meshes.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod drape;
mod example;
mod generated;
mod proof;

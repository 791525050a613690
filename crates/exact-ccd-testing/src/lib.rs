//! The support that tests, benchmarks and fuzz targets of several crates share.
//!
//! It depends on the kernel alone, and by the feature `parity` on the published methods: so the tests of each
//! crate can use it, and a change of the crate for meshes does not compile it again.
//!
//! The tests of the kernel that need it are its own. As a dependency of the kernel's tests, it would make its
//! unit tests wait until the kernel has been compiled twice.
//!
//! | modules | contents |
//! |---|---|
//! | [`primitives`], [`kinds`], [`alphabet`], [`changes`], [`contacts`] | four points, and what makes them difficult |
//! | `families`, `runner` | strategies of proptest for queries (feature `families`) |
//! | `definition`, `intersection` | answers from their definition, in rational numbers (feature `definition`) |
//! | [`laws`], [`symmetry`] | properties of the answers to every query |
//! | [`hard_cases`] | families of queries with one difficulty each, with fixed seeds |
//! | [`meshes`] | meshes in motion |
//! | `parity` | the parity of a query by the definition of contact (feature `parity`) |

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

pub mod alphabet;
pub mod changes;
pub mod contacts;
#[cfg(feature = "definition")]
pub mod definition;
#[cfg(feature = "families")]
pub mod families;
pub mod hard_cases;
#[cfg(feature = "definition")]
pub mod intersection;
pub mod kinds;
pub mod laws;
pub mod meshes;
#[cfg(feature = "parity")]
pub mod parity;
pub mod primitives;
#[cfg(feature = "families")]
pub mod runner;
pub mod symmetry;

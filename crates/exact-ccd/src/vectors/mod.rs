//! Queries side by side: the first filters on eight at a time, the rest one by one.

mod queries;
mod row;
mod run;
// The only place of the kernel that names the targets with vectors: those for which `fearless_simd` has
// more than its fallback, whose code for eight queries without vectors takes ten minutes to compile.
#[cfg_attr(
    not(any(
        target_arch = "x86",
        target_arch = "x86_64",
        all(target_arch = "aarch64", target_feature = "neon"),
        all(target_arch = "wasm32", target_feature = "simd128"),
    )),
    path = "scalar.rs"
)]
mod simd;

pub(crate) use queries::{Batch, CHUNK, Passed, points_of};
pub(crate) use row::Row;
pub(crate) use run::run;
pub use simd::Instructions;

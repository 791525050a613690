//! The machine and the build of a comparison.

use std::{fmt, fs};

use serde::Serialize;

/// The machine, and the settings of the build.
#[derive(Clone, Debug, Serialize, PartialEq, Eq)]
#[non_exhaustive]
pub struct Setting {
    /// The name of the processor.
    pub processor: String,
    /// The number of threads that it runs at a time.
    pub cores: usize,
    /// The number of threads that answer queries.
    pub threads: usize,
    /// The version of the compiler.
    pub compiler: String,
    /// The target of the compiler.
    pub target: String,
    /// The level of optimisation.
    pub optimisation: String,
    /// The flags of the compiler.
    pub flags: String,
    /// The version of this program.
    pub version: String,
}

impl Setting {
    /// This machine and this program.
    #[must_use]
    pub fn here() -> Self {
        Self {
            processor: processor(),
            cores: std::thread::available_parallelism().map_or(1, Into::into),
            threads: 1,
            compiler: env!("CCD_COMPARE_COMPILER").to_owned(),
            target: env!("CCD_COMPARE_TARGET").to_owned(),
            optimisation: env!("CCD_COMPARE_OPTIMISATION").to_owned(),
            flags: env!("CCD_COMPARE_FLAGS").to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            processor,
            cores,
            threads,
            compiler,
            target,
            optimisation,
            flags,
            version,
        } = self;
        let flags = if flags.is_empty() { "none" } else { flags };
        write!(
            f,
            "exact-ccd {version}; {processor}, {cores} cores, {threads} thread; {compiler}, {target}, \
             opt-level {optimisation}, flags: {flags}"
        )
    }
}

/// The name of the processor on Linux; elsewhere, its architecture.
fn processor() -> String {
    let information = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = information
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.trim_start().strip_prefix(':'));
    name.map_or(std::env::consts::ARCH, str::trim).to_owned()
}

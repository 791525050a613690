//! Sets `cfg(no_data)` for the tests if the published data sets are missing, and passes the build
//! settings to the reports.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    find_data();
    describe_build();
}

/// The folder is that of `exact_ccd_data::DataFolder::find`.
fn find_data() {
    const VARIABLE: &str = "EXACT_CCD_DATA";
    let default = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let folder = env::var_os(VARIABLE).map_or(default, PathBuf::from);
    println!("cargo::rustc-check-cfg=cfg(no_data)");
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    if folder.is_dir() {
        println!("cargo::rerun-if-changed={}", folder.display());
    } else {
        // A watched folder that does not exist would cause a new build every time.
        println!("cargo::rustc-cfg=no_data");
    }
}

fn describe_build() {
    let variable = |name: &str| env::var(name).unwrap_or_default();
    let version = Command::new(variable("RUSTC")).arg("--version").output();
    let compiler = version.map_or(String::new(), |output| {
        String::from_utf8_lossy(&output.stdout).into_owned()
    });
    println!("cargo::rustc-env=CCD_BENCH_COMPILER={}", compiler.trim());
    println!("cargo::rustc-env=CCD_BENCH_TARGET={}", variable("TARGET"));
    println!(
        "cargo::rustc-env=CCD_BENCH_OPTIMISATION={}",
        variable("OPT_LEVEL")
    );
    let flags = variable("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    println!("cargo::rustc-env=CCD_BENCH_FLAGS={flags}");
}

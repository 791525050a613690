//! Tells the tests whether the published data sets are there: without them, `cfg(no_data)` is set. And tells the reports how
//! the program was built.

#[path = "src/location.rs"]
mod location;

use std::env;
use std::path::Path;
use std::process::Command;

fn main() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = location::data_folder(&repository);
    println!("cargo::rustc-check-cfg=cfg(no_data)");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={}", location::VARIABLE);
    if folder.is_dir() {
        println!("cargo::rerun-if-changed={}", folder.display());
    } else {
        // Watching a folder that is not there would compile the crate anew every time.
        println!("cargo::rustc-cfg=no_data");
    }
    describe_build();
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

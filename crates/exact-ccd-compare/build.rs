//! Passes the settings of the build to the reports.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let variable = |name: &str| env::var(name).unwrap_or_default();
    let version = Command::new(variable("RUSTC")).arg("--version").output();
    let compiler = version.map_or(String::new(), |output| {
        String::from_utf8_lossy(&output.stdout).into_owned()
    });
    println!("cargo::rustc-env=CCD_COMPARE_COMPILER={}", compiler.trim());
    println!("cargo::rustc-env=CCD_COMPARE_TARGET={}", variable("TARGET"));
    println!(
        "cargo::rustc-env=CCD_COMPARE_OPTIMISATION={}",
        variable("OPT_LEVEL")
    );
    // The folders of the build have no influence on times.
    let flags = variable("CARGO_ENCODED_RUSTFLAGS");
    let flags: Vec<_> = flags
        .split('\u{1f}')
        .filter(|flag| !flag.starts_with("--remap-path-prefix"))
        .collect();
    println!("cargo::rustc-env=CCD_COMPARE_FLAGS={}", flags.join(" "));
}

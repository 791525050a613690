//! Sets `cfg(no_data)` for the tests if the published data sets are missing.

use std::env;
use std::path::{Path, PathBuf};

/// Sets `cfg(no_data)` if the folder of `exact_ccd_data::DataFolder::find` is missing.
fn main() {
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
        if env::var_os(VARIABLE).is_some() {
            let folder = folder.display();
            println!("cargo::warning={VARIABLE} is no folder: {folder}. Tests of published data are ignored");
        }
    }
}

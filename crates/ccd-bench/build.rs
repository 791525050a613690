//! Tells the tests whether the published data sets are there: without them, `cfg(no_data)` is set.

#[path = "src/location.rs"]
mod location;

use std::path::Path;

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
}

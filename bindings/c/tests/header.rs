//! The checked-in header is the one that cbindgen makes from the sources.

use std::fs;
use std::path::Path;

/// With `EXACT_CCD_WRITE_HEADER` set, the header is written instead.
#[test]
fn the_header_is_current() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml is valid");
    let bindings = cbindgen::Builder::new()
        .with_crate(root)
        .with_config(config)
        .generate()
        .expect("the sources have a C interface");
    let mut header = Vec::new();
    bindings.write(&mut header);
    let header = String::from_utf8(header).expect("a header is text");
    // The names of types end in `_t`, and cbindgen derives the names of the constants from them.
    let header = header.replace("_T_", "_");
    let path = root.join("include/exact_ccd.h");
    if std::env::var_os("EXACT_CCD_WRITE_HEADER").is_some() {
        fs::write(path, header).expect("the header can be written");
        return;
    }
    let current = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        current == header,
        "include/exact_ccd.h is out of date: run the tests with EXACT_CCD_WRITE_HEADER=1"
    );
}

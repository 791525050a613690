//! Gives the shared library the name under which programs load it; the version of the binary interface is
//! part of it.

/// The version of the binary interface, which the header has from `src/version.rs`.
fn abi_version() -> &'static str {
    let (_, version) = include_str!("include/exact_ccd.h")
        .split_once("#define EXACT_CCD_ABI_VERSION ")
        .expect("the header has the version");
    version.lines().next().unwrap_or_default()
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=include/exact_ccd.h");
    let target = |key: &str| std::env::var(format!("CARGO_CFG_TARGET_{key}")).unwrap_or_default();
    if target("VENDOR") == "apple" {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-install_name,@rpath/libexact_ccd.dylib");
    } else if target("FAMILY") == "unix" {
        println!(
            "cargo:rustc-cdylib-link-arg=-Wl,-soname,libexact_ccd.so.{}",
            abi_version()
        );
    }
}

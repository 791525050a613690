//! Writes the JavaScript that calls a WebAssembly module, as the program `wasm-bindgen` does.
//!
//! As a library, that program has the version that the lock file names, and nothing has to be
//! installed.

use std::path::PathBuf;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> anyhow::Result<()> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(module), Some(folder)) = (arguments.next(), arguments.next()) else {
        anyhow::bail!("expected two arguments: the module and the folder for the output");
    };
    Bindgen::new()
        .input_path(module)
        .web(true)?
        .typescript(true)
        .generate(folder)
}

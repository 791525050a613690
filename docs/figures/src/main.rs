//! Draws the figures of docs/parity.md and docs/separation.md, and the logo. The contacts, signs and
//! closest features in them are computed, not prescribed.
//!
//! ```sh
//! cargo run --release -p exact-ccd-figures -- [FOLDER]
//! ```

mod contacts;
mod drawing;
mod features;
mod flat;
mod fold;
mod logo;
mod patch;
mod prism;
mod rays;
mod space;
mod tetrahedron;
mod vectors;

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(|| PathBuf::from("docs/figures"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    for (name, figure) in figures()? {
        std::fs::write(folder.join(name), figure)?;
    }
    Ok(())
}

/// The names and contents of the files.
///
/// The contents are the same on every machine: coordinates are computed by +, −, ×, ÷ and √ only.
fn figures() -> Result<[(&'static str, String); 8], Box<dyn Error>> {
    Ok([
        ("prism.svg", prism::figure()?),
        ("tetrahedron.svg", tetrahedron::figure()),
        ("flat.svg", flat::figure()),
        ("fold.svg", fold::figure()?),
        ("rays.svg", rays::figure()),
        ("contacts.svg", contacts::figure()?),
        ("features.svg", features::figure()?),
        ("logo.svg", logo::figure()?),
    ])
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn the_committed_files_equal_the_figures() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let figures = figures().unwrap();
        for (name, figure) in &figures {
            let committed = std::fs::read_to_string(folder.join(name)).unwrap();
            assert!(*figure == committed, "{name}");
        }
        let is_figure = |entry: &std::fs::DirEntry| entry.path().extension().is_some_and(|it| it == "svg");
        let files = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
        assert_eq!(files.filter(is_figure).count(), figures.len());
    }
}

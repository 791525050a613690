//! The published queries of curved motion.

use std::path::{Path, PathBuf};

use exact_ccd_data::{CurvedReader, CurvedRecord, DataError, DataFolder};

/// A file: its name without extension, and its queries.
pub(super) type File = (String, Vec<CurvedRecord>);

/// The files of the data folder, in order.
pub(super) fn files() -> Result<Vec<File>, DataError> {
    let folder = DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")))?;
    folder.nonlinear()?.into_iter().map(file).collect()
}

fn file(path: PathBuf) -> Result<File, DataError> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let records = CurvedReader::open(&path)?.collect::<Result<_, _>>()?;
    Ok((name.into_owned(), records))
}

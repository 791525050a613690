//! Where the published data sets are. The build script asks too.

use std::env;
use std::path::{Path, PathBuf};

/// The environment variable that names the folder.
pub(crate) const VARIABLE: &str = "EXACT_CCD_DATA";

/// Where the folder is otherwise, as seen from the root of the repository.
const DEFAULT: &str = "../shared/data";

pub(crate) fn data_folder(repository: &Path) -> PathBuf {
    env::var_os(VARIABLE).map_or_else(|| repository.join(DEFAULT), PathBuf::from)
}

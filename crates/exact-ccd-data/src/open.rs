//! Query files of either format.

use std::path::Path;

use exact_ccd::Kind;

#[cfg(feature = "parquet")]
use crate::columns::ColumnReader;
use crate::error::DataError;
use crate::queries::QueryReader;
use crate::rational::Rounding;
use crate::record::Record;
use crate::rows::Seventh;

/// The queries of a file with all their data, read one after the other.
pub type Records<K> = Box<dyn Iterator<Item = Result<Record<K>, DataError>>>;

/// Opens a query file: Parquet if its name ends in .parquet, else CSV, whose numbers are rounded or refused,
/// and whose column after the coordinates has this meaning.
///
/// # Errors
/// If the file cannot be opened, or if it is Parquet and this build lacks the feature.
pub fn open<K: Kind>(file: &Path, rounding: Rounding, seventh: Seventh) -> Result<Records<K>, DataError> {
    if is_parquet(file) {
        return columns(file);
    }
    let reader = QueryReader::<K, _>::open(file, rounding)?;
    Ok(Box::new(reader.with_seventh(seventh)))
}

#[cfg(feature = "parquet")]
fn columns<K: Kind>(file: &Path) -> Result<Records<K>, DataError> {
    Ok(Box::new(ColumnReader::<K>::open(file)?))
}

#[cfg(not(feature = "parquet"))]
fn columns<K>(file: &Path) -> Result<Records<K>, DataError> {
    let file = file.to_owned();
    Err(DataError::NoParquet { file })
}

/// Returns true if the name of a file ends in .parquet.
#[must_use]
pub fn is_parquet(file: &Path) -> bool {
    let extension = file.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("parquet"))
}

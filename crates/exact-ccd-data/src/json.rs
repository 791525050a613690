//! The JSON files of a scene: pairs of ids, and verdicts on them.

use std::fs;
use std::path::Path;

use exact_ccd_mesh::TriangleMesh;
use serde::de::DeserializeOwned;

use crate::error::DataError;
use crate::kind::DataKind;

/// The pairs of primitives in a `boxes/*.json` file, as indices of the mesh: a vertex and a face,
/// or two edges.
///
/// # Errors
/// If the file is not a list of pairs of ids, or an id does not name a primitive of this kind.
pub(crate) fn read_pairs<K: DataKind>(file: &Path, mesh: &TriangleMesh) -> Result<Vec<[u32; 2]>, DataError> {
    let pairs: Vec<[usize; 2]> = read(file, "a list of pairs of ids")?;
    let convert = |(index, ids)| {
        K::indices(ids, mesh).ok_or_else(|| DataError::Ids {
            file: file.to_owned(),
            index,
            ids,
            kind: K::FOLDER,
        })
    };
    pairs.into_iter().enumerate().map(convert).collect()
}

/// The verdicts in a `mma_bool/*.json` file: true for each pair that collides.
///
/// # Errors
/// If the file is not a list of `true` and `false`.
pub(crate) fn read_verdicts(file: &Path) -> Result<Vec<bool>, DataError> {
    read(file, "a list of true and false")
}

fn read<T: DeserializeOwned>(file: &Path, expected: &'static str) -> Result<T, DataError> {
    let text = fs::read(file).map_err(|source| DataError::io(file, source))?;
    serde_json::from_slice(&text).map_err(|source| DataError::Json {
        file: file.to_owned(),
        expected,
        source,
    })
}

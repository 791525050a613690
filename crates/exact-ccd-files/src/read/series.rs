//! Lists of files, one for each time: collections (`.pvd`) and series (`.series`) of ParaView.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::budget::Budget;
use super::file::parse_file;
use super::vtk;
use crate::error::{Fault, ParseError, Place, ReadError, quoted};

/// Reads the times and files of a ParaView collection, `.pvd`. The times must increase.
/// [`write_pvd`](crate::write_pvd) writes one.
///
/// Paths in the collection are relative to its folder.
///
/// # Errors
/// [`ReadError`] names the file, the line, and what was expected there.
pub fn read_pvd(path: impl AsRef<Path>) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    read_pvd_within(path.as_ref(), u64::MAX)
}

/// The collection in a file of at most `max_size` bytes.
pub(super) fn read_pvd_within(path: &Path, max_size: u64) -> Result<List<PathBuf>, ReadError> {
    read_list(path, max_size, vtk::read_collection)
}

/// The series in a file of at most `max_size` bytes.
pub(super) fn read_series_within(path: &Path, max_size: u64) -> Result<List<PathBuf>, ReadError> {
    read_list(path, max_size, parse_series)
}

type List<T> = Vec<(f64, T)>;

fn read_list(
    path: &Path,
    max_size: u64,
    parse: impl FnOnce(&[u8], &Budget) -> Result<List<String>, ParseError>,
) -> Result<List<PathBuf>, ReadError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let entries = parse_file(path, max_size, |bytes, budget| {
        let entries = parse(bytes, budget)?;
        check_times(&entries)?;
        Ok(entries)
    })?;
    let entries = entries.into_iter();
    Ok(entries.map(|(time, file)| (time, folder.join(file))).collect())
}

/// Refuses several files of one time, which are parts of a frame, and times that decrease.
fn check_times(entries: &[(f64, String)]) -> Result<(), ParseError> {
    for pair in entries.windows(2) {
        let [(before, first), (time, second)] = pair else {
            continue;
        };
        let [first, second] = [first, second].map(|file| quoted(file.as_bytes()));
        let (expected, found) = if time > before {
            continue;
        } else if time == before {
            let expected = "one file for each time (make one file of the parts, in ParaView with Merge \
                            Blocks, or a list for each part)";
            (expected, format!("{first} and {second} at the time {time}"))
        } else {
            let expected = "files sorted by time (sort the list)";
            let found = format!("{second} at the time {time} after {first} at {before}");
            (expected, found)
        };
        return Err(Fault::expected(expected, found).at(Place::File));
    }
    Ok(())
}

/// The entries of `{"files": [{"name": "0.vtu", "time": 0}, …]}`.
pub(super) fn parse_series(bytes: &[u8], budget: &Budget) -> Result<List<String>, ParseError> {
    budget.step(bytes.len() as u64);
    let series: Value = serde_json::from_slice(bytes).map_err(|error| {
        let place = Place::Line(error.line());
        Fault::expected("JSON", quoted(error.to_string().as_bytes())).at(place)
    })?;
    let files = series.get("files").and_then(Value::as_array);
    let files = files.ok_or_else(|| Fault::expected("a list `files`", "none").at(Place::File))?;
    let entry = |file: &Value| {
        let name = file.get("name").and_then(Value::as_str)?;
        let time = file.get("time").and_then(Value::as_f64)?;
        time.is_finite().then(|| (time, name.to_owned()))
    };
    let with_error = |file: &Value| {
        entry(file).ok_or_else(|| {
            let found = quoted(file.to_string().as_bytes());
            Fault::expected("a file with `name` and `time`", found).at(Place::File)
        })
    };
    files.iter().map(with_error).collect()
}

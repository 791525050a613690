//! Lists of files, one for each time: collections (`.pvd`) and series (`.series`) of ParaView.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::budget::Budget;
use super::file::parse_file;
use super::vtk::{self, CollectionEntry};
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

/// The collection in a file of at most `max_size` bytes, which has one part.
pub(super) fn read_pvd_within(path: &Path, max_size: u64) -> Result<List<PathBuf>, ReadError> {
    let mut parts = read_pvd_parts(path, max_size)?;
    match parts.len() {
        0 | 1 => Ok(parts.pop().map_or_else(Vec::new, |(_, list)| list)),
        count => {
            let expected = "a collection of one part (open each part with `FrameSequence::open_parts`)";
            let source = Fault::expected(expected, format!("{count} parts")).at(Place::File);
            let path = path.to_owned();
            Err(ReadError::Parse { path, source })
        }
    }
}

/// The name and the files of each part of the collection in a file of at most `max_size` bytes. All parts
/// have the same times.
pub(super) fn read_pvd_parts(path: &Path, max_size: u64) -> Result<Vec<(String, List<PathBuf>)>, ReadError> {
    let parts = parse_file(path, max_size, |bytes, budget| {
        parts_of(vtk::read_collection(bytes, budget)?)
    })?;
    let parts = parts.into_iter();
    Ok(parts.map(|(name, list)| (name, in_folder(path, list))).collect())
}

/// The series in a file of at most `max_size` bytes.
pub(super) fn read_series_within(path: &Path, max_size: u64) -> Result<List<PathBuf>, ReadError> {
    let list = parse_file(path, max_size, |bytes, budget| {
        let list = parse_series(bytes, budget)?;
        check_times(&list)?;
        Ok(list)
    })?;
    Ok(in_folder(path, list))
}

type List<T> = Vec<(f64, T)>;

fn in_folder(path: &Path, list: List<String>) -> List<PathBuf> {
    let folder = path.parent().unwrap_or(Path::new(""));
    list.into_iter()
        .map(|(time, file)| (time, folder.join(file)))
        .collect()
}

/// The list of each part, in the order in which the parts begin.
fn parts_of(entries: Vec<CollectionEntry>) -> Result<Vec<(String, List<String>)>, ParseError> {
    let mut parts: Vec<(String, List<String>)> = Vec::new();
    let mut numbers = HashMap::new();
    for CollectionEntry { time, part, file } in entries {
        let number = *numbers.entry(part).or_insert_with_key(|part| {
            parts.push((part.clone(), Vec::new()));
            parts.len() - 1
        });
        parts[number].1.push((time, file));
    }
    if parts.is_empty() {
        // A list without files has one part without frames.
        parts.push((String::new(), Vec::new()));
    }
    for (_, list) in &parts {
        check_times(list)?;
    }
    if let Some(((first, list), rest)) = parts.split_first() {
        let times = |list: &List<String>| list.iter().map(|(time, _)| *time).collect::<Vec<_>>();
        if let Some((other, _)) = rest.iter().find(|(_, other)| times(other) != times(list)) {
            let [first, other] = [first, other].map(|name| quoted(name.as_bytes()));
            let expected =
                format!("a file of the part {other} at each time of the part {first}, and at no other");
            return Err(Fault::expected(expected, "other times").at(Place::File));
        }
    }
    Ok(parts)
}

/// Refuses several files of one time in a part, and times that decrease.
fn check_times(entries: &[(f64, String)]) -> Result<(), ParseError> {
    for pair in entries.windows(2) {
        let [(before, first), (time, second)] = pair else {
            continue;
        };
        let (expected, found) = if time > before {
            continue;
        } else if time == before {
            let expected = "one file for each time (make one file of the parts, in ParaView with Merge \
                            Blocks, or a list for each part)";
            (expected, format!("`{first}` and `{second}` at the time {time}"))
        } else {
            let expected = "files sorted by time (sort the list)";
            let found = format!("`{second}` at the time {time} after `{first}` at {before}");
            (expected, found)
        };
        return Err(Fault::expected(expected, found.replace(char::is_control, "\u{fffd}")).at(Place::File));
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

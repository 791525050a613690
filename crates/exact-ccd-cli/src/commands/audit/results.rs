//! The folder of `--results`: the results of the frames that were examined.
//!
//! Each part of an audit appends to a file of its own. The first line is the identity of the audit, and every
//! other one the result of a frame, in JSON. A line is written whole once the frame is examined. A process
//! that is killed leaves at most one unfinished line, at the end, which the next one removes.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::frame_result::FrameResult;
use super::share::Share;
use crate::files::outputs::make_folder;
use crate::messages::failure::Failure;

/// The results of all parts so far, and the file to which this part appends.
pub(super) struct Results {
    found: HashMap<usize, FrameResult>,
    /// None if no result can be added.
    own: Option<(PathBuf, File)>,
}

impl Results {
    /// The results in a folder, which has the results of one audit only. A share can add results; there is
    /// one process for each.
    ///
    /// # Errors
    /// If there are results of another audit, or if another process has the share.
    pub(super) fn open(folder: &Path, identity: &str, share: Option<Share>) -> Result<Self, Failure> {
        let mut results = Self {
            found: HashMap::new(),
            own: None,
        };
        let own = share.map(|share| folder.join(share.file_name()));
        for file in files_in(folder)? {
            if own.as_ref() != Some(&file) {
                let opened = File::open(&file).map_err(|source| unread(&file, &source))?;
                results.read(&file, &opened, identity)?;
            }
        }
        if let Some(file) = own {
            make_folder(folder)?;
            results.begin(file, identity)?;
        }
        Ok(results)
    }

    /// Takes the result of a frame, if there is one.
    pub(super) fn take(&mut self, frame: usize) -> Option<FrameResult> {
        self.found.remove(&frame)
    }

    pub(super) fn has(&self, frame: usize) -> bool {
        self.found.contains_key(&frame)
    }

    /// Adds the result of a frame.
    pub(super) fn add(&mut self, result: &FrameResult) -> Result<(), Failure> {
        let Some((path, file)) = &mut self.own else {
            return Ok(());
        };
        let mut line = serde_json::to_vec(result)?;
        line.push(b'\n');
        file.write_all(&line)
            .map_err(|source| Failure::write(path, source))
    }

    /// Reads the file of this share, and opens it behind its last whole line.
    fn begin(&mut self, path: PathBuf, identity: &str) -> Result<(), Failure> {
        let failed = |source| Failure::write(&path, source);
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&path).map_err(failed)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                let reason = "another process adds results to this file: wait for it, or name another folder";
                return Err(Failure::of(&path, reason));
            }
            // Some file systems have no locks.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let length = self.read(&path, &file, identity)?;
        file.set_len(length).map_err(failed)?;
        file.seek(SeekFrom::Start(length)).map_err(failed)?;
        if length == 0 {
            writeln!(file, "{identity}").map_err(failed)?;
        }
        self.own = Some((path, file));
        Ok(())
    }

    /// Takes the results in a file up to the first line that is not whole, and returns the length up to
    /// there.
    fn read(&mut self, path: &Path, file: &File, identity: &str) -> Result<u64, Failure> {
        let mut lines = BufReader::new(file);
        let (mut length, mut line) = (0, Vec::new());
        loop {
            line.clear();
            let read = lines.read_until(b'\n', &mut line);
            let read = read.map_err(|source| unread(path, &source))?;
            let Some((b'\n', text)) = line.split_last() else {
                return Ok(length);
            };
            if length == 0 {
                if text != identity.as_bytes() {
                    let reason = "results of other frames, of other options or of another version: name another folder, \
                                  or remove this one";
                    return Err(Failure::of(path, reason));
                }
            } else if let Ok(result) = serde_json::from_slice::<FrameResult>(text) {
                self.found.insert(result.frame, result);
            } else {
                return Ok(length);
            }
            length += read as u64;
        }
    }
}

/// The failure to read a file or a folder of results.
fn unread(path: &Path, source: &io::Error) -> Failure {
    Failure::of(path, format_args!("cannot read the results: {source}"))
}

/// The files of results in a folder, in the order of their names; none, if there is no folder.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |source| unread(folder, &source);
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("part-") && name.ends_with(".jsonl") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

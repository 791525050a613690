//! Runs of the program, each in a separate folder.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

/// A temporary folder. The program runs in it, so that files go by their names.
pub(crate) struct Folder(TempDir);

/// The output of a run of the program.
#[derive(Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) status: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Folder {
    pub(crate) fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, contents: impl AsRef<[u8]>) {
        fs::write(self.path(name), contents).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// The program with these arguments, not yet started.
    pub(crate) fn program(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_exact-ccd"));
        command.args(arguments).current_dir(&self.0).stdin(Stdio::null());
        // The width of the help.
        command.env("COLUMNS", "100");
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Run {
        self.program(arguments).output().unwrap().into()
    }

    /// A run with this text on standard input. The text must fit into a pipe.
    pub(crate) fn run_with_input(&self, arguments: &[&str], input: &str) -> Run {
        let (reader, mut writer) = std::io::pipe().unwrap();
        writer.write_all(input.as_bytes()).unwrap();
        drop(writer);
        self.program(arguments).stdin(reader).output().unwrap().into()
    }
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self {
            // A program that was ended by a signal has no status.
            status: output.status.code().unwrap(),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    }
}

impl Run {
    /// Checks that the run failed with status 2 and one line on standard error. Returns that line without
    /// its prefix.
    #[track_caller]
    pub(crate) fn error(&self) -> &str {
        assert_eq!(self.status, 2, "{self:?}");
        let line = self.stderr.strip_suffix('\n').unwrap();
        assert!(!line.contains(['\n', '\r']), "{self:?}");
        line.strip_prefix("exact-ccd: error: ").unwrap()
    }
}

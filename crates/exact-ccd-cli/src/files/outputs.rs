//! Output: the answer on standard output, and files.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;

use clap::builder::{PathBufValueParser, TypedValueParser};
use exact_ccd_files::Format;

use crate::messages::failure::Failure;

/// The option `--output` of commands with an answer in text.
#[derive(clap::Args)]
pub(crate) struct Output {
    /// Write the answer to this file, which is replaced; - is standard output.
    #[arg(long, short, value_name = "FILE", default_value = "-", value_parser = answer())]
    output: PathBuf,
}

/// The name of a file for an answer on the command line. The name of a mesh file, or of a list of mesh files,
/// is an error: where the name is left out, the answer would replace the first input behind the option.
pub(crate) fn answer() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|file| {
        let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
        if Format::of_path(&file).is_some() || extension == "pvd" || extension == "series" {
            Err("this is the name of a file of meshes, which would be replaced: name a file for the answer")
        } else {
            Ok(file)
        }
    })
}

/// The name of an HTML file on the command line.
pub(crate) fn page() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|file| {
        let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
        if extension == "html" || extension == "htm" {
            Ok(file)
        } else {
            Err("expected the name of an HTML file, such as page.html")
        }
    })
}

impl Output {
    /// The file, unless it is standard output.
    pub(crate) fn file(&self) -> Option<&Path> {
        Some(&*self.output).filter(|file| !is_dash(file))
    }

    /// Checks that the file is none of the inputs.
    #[cfg(feature = "queries")]
    pub(crate) fn check(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        self.file().map_or(Ok(()), |file| check_is_no_input(file, inputs))
    }

    /// Writes the answer, with a line break at its end.
    pub(crate) fn write(&self, text: &str) -> Result<(), Failure> {
        match self.file() {
            Some(file) => write_file(file, |writer| writeln!(writer, "{}", text.trim_end())),
            None => print(text.trim_end()),
        }
    }

    /// The failure to write the answer.
    #[cfg(feature = "queries")]
    pub(crate) fn failed(&self, source: io::Error) -> Failure {
        match self.file() {
            Some(file) => Failure::write(file, source),
            None => source.into(),
        }
    }

    /// Writes the answer as it is computed. After an error, standard output has the part before it, and a
    /// file is unchanged.
    #[cfg(feature = "queries")]
    pub(crate) fn stream<T>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        if let Some(file) = self.file() {
            return replace_file(file, |writer| write(writer));
        }
        let mut writer = BufWriter::new(io::stdout().lock());
        let written = write(&mut writer);
        let flushed = writer.flush();
        let written = written?;
        flushed?;
        Ok(written)
    }
}

/// Returns true for the name of standard input or output, `-`.
pub(crate) fn is_dash(file: &Path) -> bool {
    file == Path::new("-")
}

/// Prints the answer. A closed pipe is not a failure.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    writeln!(output, "{text}")
        .and_then(|()| output.flush())
        .map_err(Failure::from)
        .or_else(Failure::unless_closed_pipe)
}

/// The place of a file, by whatever name: a new one is in its folder, which may be new, too.
fn place(file: &Path) -> PathBuf {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
    let in_folder = |_| {
        let folder = fs::canonicalize(folder.unwrap_or(Path::new(".")))?;
        Ok::<_, io::Error>(folder.join(file.file_name().unwrap_or_default()))
    };
    let found = fs::canonicalize(file).or_else(in_folder);
    found
        .or_else(|_| std::path::absolute(file))
        .unwrap_or_else(|_| file.to_owned())
}

/// Checks that a file to write is none of the inputs.
pub(crate) fn check_is_no_input(file: &Path, inputs: &[PathBuf]) -> Result<(), Failure> {
    if file.exists() && inputs.iter().any(|input| place(input) == place(file)) {
        let reason = "the answer would replace this input: name another file";
        return Err(Failure::of(file, reason));
    }
    Ok(())
}

/// Checks that no two outputs are one file. Special files such as /dev/null take several.
pub(crate) fn check_distinct(files: &[PathBuf]) -> Result<(), Failure> {
    let is_plain = |file: &PathBuf| fs::metadata(file).map_or(true, |metadata| metadata.is_file());
    for (number, file) in files.iter().enumerate() {
        if is_plain(file) && files[..number].iter().any(|other| place(other) == place(file)) {
            let reason = "two answers would be written to this file: name another one";
            return Err(Failure::of(file, reason));
        }
    }
    Ok(())
}

/// Checks that a file can be written in its folder, before it is computed.
pub(crate) fn check_place(file: &Path) -> Result<(), Failure> {
    let failed = |source| Failure::write(file, source);
    if file.is_dir() {
        return Err(failed(io::ErrorKind::IsADirectory.into()));
    }
    match file.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        Some(folder) => fs::metadata(folder).map(|_| ()).map_err(failed),
        None => Ok(()),
    }
}

/// Checks that no file is in the place of a folder, before its contents are computed.
pub(crate) fn check_folder_place(folder: &Path) -> Result<(), Failure> {
    if folder.exists() && !folder.is_dir() {
        return Err(Failure::write(folder, io::ErrorKind::NotADirectory.into()));
    }
    Ok(())
}

/// Removes a file, if there is one.
pub(crate) fn remove_file(file: &Path) -> Result<(), Failure> {
    match fs::remove_file(file) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => Err(Failure::write(file, source)),
        _ => Ok(()),
    }
}

/// Makes a folder, and the folders around it.
pub(crate) fn make_folder(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|source| Failure::write(folder, source))
}

/// Writes a file and replaces an existing one, see [`replace_file`].
pub(crate) fn write_file(
    file: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), Failure> {
    replace_file(file, |writer| {
        write(writer).map_err(|source| Failure::write(file, source))
    })
}

/// Writes a file as [`write_file`], without waiting for the disk: after a crash of the system, not of the
/// program, it may be damaged.
#[cfg(feature = "simulate")]
pub(crate) fn write_file_soon(
    file: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), Failure> {
    replace(file, false, |writer| {
        write(writer).map_err(|source| Failure::write(file, source))
    })
}

/// Writes a file and replaces an existing one atomically: after an error or a crash, the old file
/// is unchanged.
///
/// The contents are written to a draft, which is synced and then renamed. A crash leaves the draft in the
/// folder. The name of the draft is a point, the name of the file, and a number.
pub(crate) fn replace_file<T>(
    file: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    replace(file, true, write)
}

fn replace<T>(
    file: &Path,
    is_synced: bool,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    // A special file such as /dev/stdout cannot be replaced.
    let is_plain = fs::metadata(file).map_or(true, |metadata| metadata.is_file());
    let target = fs::canonicalize(file).unwrap_or_else(|_| file.to_owned());
    let (created, draft) = match target.file_name().filter(|_| is_plain) {
        None => (File::create(file), None),
        Some(name) => {
            let mut draft = OsString::from(".");
            draft.push(name);
            draft.push(format!(".{}", process::id()));
            let draft = target.with_file_name(draft);
            // A draft of this name can only come from a process that has ended.
            let _ = fs::remove_file(&draft);
            (File::create_new(&draft), Some(draft))
        }
    };
    let failed = |source| Failure::write(file, source);
    let mut writer = BufWriter::new(created.map_err(failed)?);
    let written = write(&mut writer).and_then(|written| {
        writer.flush().map_err(failed)?;
        if let Some(draft) = &draft {
            let synced = if is_synced {
                writer.get_ref().sync_all()
            } else {
                Ok(())
            };
            synced.and_then(|()| fs::rename(draft, &target)).map_err(failed)?;
        }
        Ok(written)
    });
    if let (Err(_), Some(draft)) = (&written, &draft) {
        // An error of the removal is ignored: the first error is the one to report.
        let _ = fs::remove_file(draft);
    }
    written
}

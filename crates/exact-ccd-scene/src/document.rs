//! Positions of fields in the text of a scene file.

use std::io;
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::field_error::FieldError;

/// An error in a scene file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The file cannot be read.
    #[error("{}: {source}", file.display())]
    Io {
        /// The file.
        file: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// A value is missing or invalid.
    #[error("{}, line {line}, {field}: {message}", file.display())]
    Field {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The path of the field, such as ``body `sheet`, shell.young``, or `body[1].shell.young` for a body
        /// without a name, or `the file` for the file as a whole. Bodies and scripts are counted from 0.
        field: String,
        /// The value that was found and the values that are allowed.
        message: String,
    },
}

/// The text of a scene file.
pub(super) struct Document<'a> {
    pub(super) file: &'a Path,
    pub(super) text: &'a str,
}

impl Document<'_> {
    /// The error at a byte of the text, located at the innermost field that contains the byte.
    pub(super) fn error_at(&self, byte: usize, message: impl FnOnce(&str) -> String) -> SceneError {
        let root = self.root();
        let mut path = Vec::new();
        if let Some(root) = &root {
            add_path(root, byte, &mut path);
        }
        let (name, _) = located(root.as_ref(), path.iter().map(String::as_str));
        let message = message(&name);
        self.error(byte, name, message)
    }

    /// The error of a field. If the file lacks the field, the error names the line of the innermost table
    /// that should contain it.
    pub(super) fn error_of(&self, FieldError { path, message }: FieldError) -> SceneError {
        let keys = path.split('.').filter(|key| !key.is_empty());
        let (name, byte) = located(self.root().as_ref(), keys);
        self.error(byte, name, message)
    }

    fn root(&self) -> Option<DeValue<'_>> {
        let table = DeTable::parse(self.text).ok()?;
        Some(DeValue::Table(table.into_inner()))
    }

    fn error(&self, byte: usize, field: String, message: String) -> SceneError {
        let before = self.text.as_bytes().iter().take(byte);
        SceneError::Field {
            file: self.file.to_owned(),
            line: 1 + before.filter(|&&byte| byte == b'\n').count(),
            field: if field.is_empty() {
                "the file".to_owned()
            } else {
                field
            },
            message,
        }
    }
}

/// The name of a field in messages, and the first byte of the innermost value on the way to it.
fn located<'a>(root: Option<&DeValue<'_>>, path: impl Iterator<Item = &'a str>) -> (String, usize) {
    let (mut name, mut byte, mut value) = (String::new(), 0, root);
    for key in path {
        let array = value.and_then(DeValue::as_array);
        let table = value.and_then(DeValue::as_table);
        let entry = array.and_then(|array| array.get(key.parse::<usize>().ok()?));
        let next = entry.or_else(|| table?.get(key));
        if let Some(next) = next {
            byte = next.span().start;
        }
        value = next.map(Spanned::get_ref);
        let own = value.and_then(|entry| entry.as_table()?.get("name")?.get_ref().as_str());
        name += &match own.filter(|name| !name.is_empty()) {
            Some(own) if array.is_some() => format!(" `{}`", own.replace(char::is_control, "?")),
            _ if array.is_some() => format!("[{key}]"),
            _ if name.ends_with('`') => format!(", {key}"),
            _ if name.is_empty() => key.to_owned(),
            _ => format!(".{key}"),
        };
    }
    (name, byte)
}

/// Adds the keys from a value to the innermost value that contains a byte.
fn add_path(value: &DeValue<'_>, byte: usize, path: &mut Vec<String>) {
    let inner = match value {
        DeValue::Table(table) => table.iter().find_map(|(key, value)| {
            let is_here = key.span().contains(&byte) || contains(value, byte);
            is_here.then(|| (key.get_ref().to_string(), value))
        }),
        DeValue::Array(array) => array
            .iter()
            .enumerate()
            .find_map(|(index, value)| contains(value, byte).then(|| (index.to_string(), value))),
        _ => None,
    };
    if let Some((key, value)) = inner {
        path.push(key);
        add_path(value.get_ref(), byte, path);
    }
}

/// Returns true if a byte belongs to a value. The span of a table with a header is only the header, so the
/// entries of the table are searched too.
fn contains(value: &Spanned<DeValue<'_>>, byte: usize) -> bool {
    value.span().contains(&byte)
        || match value.get_ref() {
            DeValue::Table(table) => table
                .iter()
                .any(|(key, value)| key.span().contains(&byte) || contains(value, byte)),
            DeValue::Array(array) => array.iter().any(|value| contains(value, byte)),
            _ => false,
        }
}

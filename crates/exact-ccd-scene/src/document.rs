//! Positions of fields in the text of a scene file.

use std::io;
use std::path::{Path, PathBuf};

use toml::de::{DeTable, DeValue};

use super::import::ImportError;

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
    /// A scene of another program cannot be imported.
    #[error(transparent)]
    Import(#[from] ImportError),
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

/// One component of the path of a field.
#[derive(Clone, Copy, Debug)]
pub(super) enum Key<'a> {
    Name(&'a str),
    Index(usize),
}

/// The text of a scene file.
pub(super) struct Document<'a> {
    pub(super) file: &'a Path,
    pub(super) text: &'a str,
}

impl Document<'_> {
    /// The error at a byte of the text, located at the innermost field that contains the byte.
    pub(super) fn error_at(&self, byte: usize, message: impl FnOnce(&str) -> String) -> SceneError {
        let mut field = String::new();
        if let Ok(table) = DeTable::parse(self.text) {
            in_table(table.get_ref(), byte, &mut field);
        }
        let message = message(&field);
        self.error(byte, field, &message)
    }

    /// The error of a field. If the file lacks the field, its line is that of the innermost table that
    /// should contain it.
    pub(super) fn error_of(&self, path: &[Key<'_>], message: &str) -> SceneError {
        let mut byte = 0;
        let mut name = String::new();
        let table = DeTable::parse(self.text);
        let mut value: Option<&DeValue<'_>> = None;
        for (depth, &key) in path.iter().enumerate() {
            let next = match (key, value, &table) {
                (Key::Name(key), None, Ok(table)) if depth == 0 => table.get_ref().get(key),
                (Key::Name(key), Some(DeValue::Table(table)), _) => table.get(key),
                (Key::Index(index), Some(DeValue::Array(array)), _) => array.get(index),
                _ => None,
            };
            value = next.map(|next| {
                byte = next.span().start;
                next.get_ref()
            });
            match key {
                Key::Name(key) => push(&mut name, key),
                Key::Index(index) => push_entry(&mut name, index, value),
            }
        }
        self.error(byte, name, message)
    }

    fn error(&self, byte: usize, field: String, message: &str) -> SceneError {
        let before = self.text.as_bytes().iter().take(byte);
        SceneError::Field {
            file: self.file.to_owned(),
            line: 1 + before.filter(|&&byte| byte == b'\n').count(),
            field: if field.is_empty() {
                "the file".to_owned()
            } else {
                field
            },
            message: message.to_owned(),
        }
    }
}

/// Appends a key to a path.
fn push(path: &mut String, key: &str) {
    if path.ends_with('`') {
        path.push_str(", ");
    } else if !path.is_empty() {
        path.push('.');
    }
    path.push_str(key);
}

/// Appends the entry of an array to a path: its name, or else its place.
fn push_entry(path: &mut String, index: usize, entry: Option<&DeValue<'_>>) {
    let name = match entry {
        Some(DeValue::Table(table)) => table.get("name").map(toml::Spanned::get_ref),
        _ => None,
    };
    match name {
        Some(DeValue::String(name)) if !name.is_empty() => *path += &format!(" `{name}`"),
        _ => *path += &format!("[{index}]"),
    }
}

/// Appends the path from a table to the value at a byte.
fn in_table(table: &DeTable<'_>, byte: usize, name: &mut String) {
    for (key, value) in table {
        if key.span().contains(&byte) || contains(value.get_ref(), value.span(), byte) {
            push(name, key.get_ref());
            in_value(value.get_ref(), byte, name);
            return;
        }
    }
}

fn in_value(value: &DeValue<'_>, byte: usize, name: &mut String) {
    match value {
        DeValue::Table(table) => in_table(table, byte, name),
        DeValue::Array(array) => {
            let place = array
                .iter()
                .position(|value| contains(value.get_ref(), value.span(), byte));
            if let Some((index, value)) = place.and_then(|index| Some((index, array.get(index)?))) {
                push_entry(name, index, Some(value.get_ref()));
                in_value(value.get_ref(), byte, name);
            }
        }
        _ => {}
    }
}

/// True if a byte belongs to a value. The span of a table with a header is only the header, so the entries
/// of the table are searched too.
fn contains(value: &DeValue<'_>, span: std::ops::Range<usize>, byte: usize) -> bool {
    span.contains(&byte)
        || match value {
            DeValue::Table(table) => table.iter().any(|(key, value)| {
                key.span().contains(&byte) || contains(value.get_ref(), value.span(), byte)
            }),
            DeValue::Array(array) => array
                .iter()
                .any(|value| contains(value.get_ref(), value.span(), byte)),
            _ => false,
        }
}

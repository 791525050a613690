//! Values of JSON with their paths, for errors.

use exact_ccd_files::excerpt;
use serde_json::{Map, Value};

use super::problem::CurvedProblem;

/// A value, and the path that leads to it.
pub(super) struct At<'a> {
    path: String,
    value: &'a Value,
}

/// The members of an object, and the path that leads to it.
pub(super) struct Members<'a> {
    path: String,
    members: &'a Map<String, Value>,
}

impl<'a> At<'a> {
    pub(super) fn line(value: &'a Value) -> Self {
        let path = String::new();
        Self { path, value }
    }

    pub(super) fn path(&self) -> &str {
        &self.path
    }

    /// The error of another value.
    pub(super) fn other(&self, expected: impl Into<String>) -> CurvedProblem {
        CurvedProblem::Field {
            field: if self.path.is_empty() {
                "the line".to_owned()
            } else {
                self.path.clone()
            },
            expected: expected.into(),
            found: match self.value {
                Value::String(text) => format!("\"{}\"", excerpt(text.as_bytes())),
                other => excerpt(other.to_string().as_bytes()),
            },
        }
    }

    /// The members of an object that has no others than these.
    pub(super) fn members(&self, known: &[&'static str]) -> Result<Members<'a>, CurvedProblem> {
        let expected = || self.other(format!("an object with {}", known.join(", ")));
        let members = self.value.as_object().ok_or_else(expected)?;
        let path = self.path.clone();
        let all = Members { path, members };
        match members.keys().find(|key| !known.contains(&key.as_str())) {
            Some(key) => Err(CurvedProblem::Unknown {
                field: all.path_of(&excerpt(key.as_bytes())),
                known: known.join(", "),
            }),
            None => Ok(all),
        }
    }

    pub(super) fn list(&self, expected: &str) -> Result<Vec<Self>, CurvedProblem> {
        let values = self.value.as_array().ok_or_else(|| self.other(expected))?;
        let at = |(index, value)| Self {
            path: format!("{}[{index}]", self.path),
            value,
        };
        Ok(values.iter().enumerate().map(at).collect())
    }

    /// A list of this many numbers.
    pub(super) fn numbers<const N: usize>(&self) -> Result<[f64; N], CurvedProblem> {
        let values = self.value.as_array().map_or(&[][..], Vec::as_slice);
        let numbers: Option<Vec<f64>> = values.iter().map(Value::as_f64).collect();
        let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
        numbers.ok_or_else(|| self.other(format!("a list of {N} numbers")))
    }

    pub(super) fn value(&self) -> &'a Value {
        self.value
    }
}

impl<'a> Members<'a> {
    fn path_of(&self, key: &str) -> String {
        match self.path.as_str() {
            "" => key.to_owned(),
            path => format!("{path}.{key}"),
        }
    }

    pub(super) fn find(&self, key: &str) -> Option<At<'a>> {
        let path = self.path_of(key);
        self.members.get(key).map(|value| At { path, value })
    }

    pub(super) fn get(&self, key: &str, expected: &'static str) -> Result<At<'a>, CurvedProblem> {
        self.find(key).ok_or_else(|| CurvedProblem::Missing {
            field: self.path_of(key),
            expected,
        })
    }
}

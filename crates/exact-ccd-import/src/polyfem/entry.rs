//! Values of a JSON file with their places.

use exact_ccd_mesh::Point;
use serde_json::Value;

use crate::fault::{Fault, Place, Problem};
use crate::notes::Notes;

/// A value, and the JSON pointer to it.
#[derive(Clone, Debug)]
pub(super) struct Entry<'a> {
    pointer: String,
    notes: &'a Notes,
    pub(super) value: &'a Value,
}

/// A key that may have no value but the empty one.
pub(super) const NOTHING: Rule = Rule::Only("");

/// The treatment of a key of an object.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// It is imported.
    Said,
    /// It is ignored, for this reason.
    Ignored(&'static str),
    /// It has no counterpart. Only its default is allowed, which is this value as text or nothing: `null`,
    /// `false`, an empty list, or an object that is empty or not enabled.
    Only(&'static str),
}

/// True for a default value, or for nothing.
fn is_default(value: &Value, default: &str) -> bool {
    match value {
        Value::Null => true,
        Value::Bool(value) => *value == (default == "true"),
        Value::Array(values) => values.is_empty(),
        Value::Object(values) => {
            let is_off = |key| values.get(key) == Some(&Value::Bool(false));
            values.is_empty() || is_off("enabled") || is_off("adhesion_enabled")
        }
        Value::Number(number) => number
            .as_f64()
            .is_some_and(|number| default.parse() == Ok(number)),
        Value::String(text) => !default.is_empty() && text == default,
    }
}

impl<'a> Entry<'a> {
    pub(super) fn new(value: &'a Value, notes: &'a Notes) -> Self {
        Self {
            pointer: String::new(),
            notes,
            value,
        }
    }

    pub(super) fn place(&self) -> Place {
        Place::Pointer(self.pointer.clone())
    }

    /// The error that the value is another one than expected.
    pub(super) fn invalid(&self, expected: &str) -> Fault {
        let mut found = self.value.to_string();
        if found.chars().count() > 40 {
            found = found.chars().take(40).chain("…".chars()).collect();
        }
        Problem::invalid(found, expected).at(&self.place())
    }

    pub(super) fn unsupported(&self, what: &str, instead: &str) -> Fault {
        Problem::unsupported(what, instead).at(&self.place())
    }

    /// Notes that the value has no effect.
    pub(super) fn note(&self, message: impl Into<String>) {
        self.notes.add(self.place(), message);
    }

    /// The value of a key that is present and not `null`.
    pub(super) fn get(&self, key: &str) -> Option<Self> {
        let value = self.value.get(key).filter(|value| !value.is_null())?;
        Some(self.below(key, value))
    }

    /// The value of a required key.
    pub(super) fn need(&self, key: &str) -> Result<Self, Fault> {
        let missing = || Problem::invalid(format!("no key `{key}`"), "this key").at(&self.place());
        self.get(key).ok_or_else(missing)
    }

    fn below(&self, key: &str, value: &'a Value) -> Self {
        let key = key.replace('~', "~0").replace('/', "~1");
        let pointer = format!("{}/{key}", self.pointer);
        let notes = self.notes;
        Self {
            pointer,
            notes,
            value,
        }
    }

    /// Checks all keys of an object. Each rule is for some keys, with blanks between them. A key without a
    /// counterpart is an error, after which the import goes on.
    pub(super) fn check(&self, rules: &[(&str, Rule)]) -> Result<(), Fault> {
        let object = self.value.as_object().ok_or_else(|| self.invalid("an object"))?;
        for (key, value) in object {
            let entry = self.below(key, value);
            let rule = rules
                .iter()
                .find(|(names, _)| names.split(' ').any(|name| name == key));
            match rule.map(|(_, rule)| *rule) {
                None => self
                    .notes
                    .fail(Problem::Unknown { program: "PolyFEM" }.at(&entry.place())),
                Some(Rule::Said) => {}
                Some(Rule::Ignored(reason)) => entry.note(format!("ignored: {reason}")),
                Some(Rule::Only(default)) if is_default(value, default) => {}
                Some(Rule::Only(_)) => self.notes.fail(entry.unsupported("this value", "remove the key")),
            }
        }
        Ok(())
    }

    /// The elements of a list, or the value as the only one.
    pub(super) fn list(&self) -> Vec<Self> {
        match self.value {
            Value::Array(values) => (0..)
                .zip(values)
                .map(|(index, value): (usize, _)| self.below(&index.to_string(), value))
                .collect(),
            _ => vec![self.clone()],
        }
    }

    /// A finite number, also one in a string.
    pub(super) fn number(&self) -> Result<f64, Fault> {
        let number = match self.value {
            Value::Number(number) => number.as_f64(),
            Value::String(text) => text.trim().parse().ok(),
            _ => None,
        };
        number
            .filter(|number| number.is_finite())
            .ok_or_else(|| self.invalid("a number, without a unit"))
    }

    pub(super) fn integer(&self) -> Result<i64, Fault> {
        self.value.as_i64().ok_or_else(|| self.invalid("an integer"))
    }

    pub(super) fn text(&self) -> Result<&'a str, Fault> {
        self.value.as_str().ok_or_else(|| self.invalid("a string"))
    }

    pub(super) fn is_true(&self) -> Result<bool, Fault> {
        self.value.as_bool().ok_or_else(|| self.invalid("true or false"))
    }

    /// Three numbers.
    pub(super) fn point(&self) -> Result<Point, Fault> {
        self.three(Self::number, "three numbers")
    }

    /// A list of three values.
    pub(super) fn three<T>(
        &self,
        read: impl Fn(&Self) -> Result<T, Fault>,
        expected: &str,
    ) -> Result<[T; 3], Fault> {
        let values: Result<Vec<T>, Fault> = self.elements()?.iter().map(read).collect();
        values?.try_into().map_err(|_| self.invalid(expected))
    }

    /// The elements of a list.
    pub(super) fn elements(&self) -> Result<Vec<Self>, Fault> {
        if self.value.is_array() {
            Ok(self.list())
        } else {
            Err(self.invalid("a list"))
        }
    }

    /// The value of a key, unless it is an empty list.
    pub(super) fn get_filled(&self, key: &str) -> Option<Self> {
        let is_filled = |entry: &Self| entry.value.as_array().is_none_or(|list| !list.is_empty());
        self.get(key).filter(is_filled)
    }

    /// The number of a key, or a default.
    pub(super) fn number_or(&self, key: &str, default: f64) -> Result<f64, Fault> {
        self.get(key).map_or(Ok(default), |entry| entry.number())
    }

    /// The truth of a key that is false if not given.
    pub(super) fn flag(&self, key: &str) -> Result<bool, Fault> {
        self.get(key).map_or(Ok(false), |entry| entry.is_true())
    }
}

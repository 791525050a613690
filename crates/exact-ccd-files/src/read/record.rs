//! Numbers that belong together, by their name in messages.

use std::fmt;

use crate::error::quoted;

/// Numbers that belong together: in text, one line.
#[derive(Clone, Copy)]
pub(super) struct Record<'a> {
    name: &'static str,
    /// Its number, from 0, and the count of such records.
    number: Option<(u64, u64)>,
    element: Option<&'a [u8]>,
}

impl<'a> Record<'a> {
    pub(super) fn one(name: &'static str) -> Self {
        Self {
            name,
            number: None,
            element: None,
        }
    }

    pub(super) fn of(name: &'static str, number: u64, count: u64) -> Self {
        Self {
            number: Some((number, count)),
            ..Self::one(name)
        }
    }

    /// The record of an element with a name in the file.
    pub(super) fn of_element(self, element: &'a [u8]) -> Self {
        Self {
            element: Some(element),
            ..self
        }
    }
}

impl fmt::Display for Record<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(element) = self.element {
            write!(f, "element {}, ", quoted(element))?;
        }
        match self.number {
            Some((number, count)) => write!(f, "{} {number} of {count}", self.name),
            None => f.write_str(self.name),
        }
    }
}

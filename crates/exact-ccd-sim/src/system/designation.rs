//! Bodies and half spaces in messages.

use std::fmt;

/// A body or a half space in messages: by its name, or else by its place among the bodies or the half spaces
/// of a scene, as ``body `sheet` `` or `body[1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Designation {
    is_body: bool,
    place: usize,
    name: Box<str>,
}

impl Designation {
    /// The body at a place in the list of bodies. An empty name is none.
    #[must_use]
    pub fn of_body(place: usize, name: impl Into<Box<str>>) -> Self {
        let name = name.into();
        let is_body = true;
        Self { is_body, place, name }
    }

    /// The half space at a place in the list of half spaces. An empty name is none.
    pub(crate) fn of_half_space(place: usize, name: impl Into<Box<str>>) -> Self {
        let name = name.into();
        let is_body = false;
        Self { is_body, place, name }
    }

    /// Two bodies, or two parts of one, in messages.
    pub(crate) fn both([a, b]: &[Self; 2]) -> String {
        if a == b {
            format!("two parts of {a}")
        } else {
            format!("{a} and {b}")
        }
    }

    /// The place in the list of bodies or in the list of half spaces, from 0.
    #[must_use]
    pub fn place(&self) -> usize {
        self.place
    }

    /// The name. Empty for no name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl fmt::Display for Designation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { is_body, place, name } = self;
        let what = if *is_body { "body" } else { "half-space" };
        if name.is_empty() {
            write!(f, "{what}[{place}]")
        } else {
            write!(f, "{what} `{name}`")
        }
    }
}

//! The reasons why nothing is proved.

use std::fmt;

/// The reason why a certificate is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// A file is not a mesh, or not a certificate.
    Unreadable(String),
    /// The certificate does not prove its statement about these meshes.
    Refused(String),
}

impl Failure {
    /// The same failure, with the place of its reason: a file, a step or a row.
    pub fn at(self, place: impl fmt::Display) -> Self {
        match self {
            Self::Unreadable(reason) => Self::Unreadable(format!("{place}: {reason}")),
            Self::Refused(reason) => Self::Refused(format!("{place}: {reason}")),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(reason) | Self::Refused(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Failure {}

/// The failure of an unreadable file.
pub(crate) fn unreadable<T>(reason: impl Into<String>) -> Result<T, Failure> {
    Err(Failure::Unreadable(reason.into()))
}

/// The failure of a refused certificate.
pub(crate) fn refused<T>(reason: impl Into<String>) -> Result<T, Failure> {
    Err(Failure::Refused(reason.into()))
}

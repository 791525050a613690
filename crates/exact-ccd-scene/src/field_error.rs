//! Errors of fields.

/// A field with the message of its error. Its path has dots between keys and places in arrays, from 0:
/// `body.0.script.1.axes`.
pub(super) struct FieldError {
    pub(super) path: String,
    pub(super) message: String,
}

impl FieldError {
    pub(super) fn new(path: impl Into<String>, message: impl ToString) -> Self {
        let (path, message) = (path.into(), message.to_string());
        Self { path, message }
    }

    /// The same error, of a field below another one.
    pub(super) fn below(self, path: &str) -> Self {
        Self::new(format!("{path}.{}", self.path), self.message)
    }
}

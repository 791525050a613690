//! Lists to which many threads append.

use std::sync::{Mutex, PoisonError};

/// A list to which many threads append, in any order.
#[derive(Debug)]
pub(crate) struct Gathered<T>(Mutex<Vec<T>>);

impl<T> Gathered<T> {
    /// The same list, to be appended to.
    pub(crate) fn new(list: Vec<T>) -> Self {
        Self(Mutex::new(list))
    }

    /// Appends some elements.
    pub(crate) fn append(&self, mut some: Vec<T>) {
        if !some.is_empty() {
            let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            all.append(&mut some);
        }
    }

    pub(crate) fn into_list(self) -> Vec<T> {
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T> Default for Gathered<T> {
    fn default() -> Self {
        Self::new(Vec::new())
    }
}

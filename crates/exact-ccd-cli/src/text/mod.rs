//! The texts of answers: JSON, numbers and durations.

pub(crate) mod json;
pub(crate) mod numbers;
pub(crate) mod seconds;

//! Files of queries: their kind, their records, and the methods that answer them.

pub(crate) mod method;
pub(crate) mod recognise;
pub(crate) mod rows;

//! Queries as points, in families that are each hard in their own way.

pub(crate) mod alphabet;
mod changes;
mod contacts;
mod families;

pub(crate) use families::*;

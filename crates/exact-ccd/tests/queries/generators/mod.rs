//! Families of queries, each with its own numerical difficulty.

pub(crate) mod alphabet;
mod changes;
mod contacts;
mod families;
mod ingredients;

pub(crate) use contacts::grazing;
pub(crate) use families::*;
pub(crate) use ingredients::quarters;

//! Queries as points, in families that are each hard in their own way.

pub(crate) mod alphabet;
mod changes;
mod contacts;
mod families;
mod ingredients;

pub(crate) use contacts::grazing;
pub(crate) use families::*;
pub(crate) use ingredients::quarters;

//! Lagged friction: normal forces and tangent planes are taken from an earlier iterate.

mod coefficients;
mod contact;
mod smooth;

pub(crate) use coefficients::Coefficients;
pub(crate) use contact::FrictionContact;
pub(crate) use smooth::Smoothing;

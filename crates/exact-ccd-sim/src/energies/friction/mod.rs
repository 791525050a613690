//! Lagged friction: normal forces and tangent planes are taken from an earlier iterate.

mod coefficients;
mod friction_contact;
mod smooth;

pub(crate) use coefficients::Coefficients;
pub(crate) use friction_contact::FrictionContact;
pub(crate) use smooth::Smoothing;

//! Lagged friction: normal forces and tangent planes are those of an earlier iterate.

mod contact;
mod smooth;

pub use contact::FrictionContact;
pub use smooth::Smoothing;

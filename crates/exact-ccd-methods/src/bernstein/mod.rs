//! Contact from the signs of polynomials in Bernstein form.
//!
//! The four points of a query are coplanar at the roots of a cubic Y, and the primitives meet at
//! such a root unless one of three quartics L is negative there. Both methods isolate the roots of
//! Y by its shape, and find the sign of L at a root without computing the root; they differ in
//! their arithmetic, at an inflection point of Y, and if Y is zero for all times.
//!
//! The notation follows M. Tang, R. Tong, Z. Wang and D. Manocha, *Fast and Exact Continuous
//! Collision Detection with Bernstein Sign Classification*, ACM Transactions on Graphics 33(6),
//! 2014.

mod bounded;
mod configuration;
mod curve;
mod inflection;
mod inside;
mod number;
mod sign_classification;
mod tight;

pub use sign_classification::BernsteinSignClassification;
pub use tight::TightCcd;

//! f64 with bounds: numbers and vectors, one or several side by side, and cubics in Bernstein form.
//!
//! [`roundoff`] has the conventions of the error bounds. Each bound is derived beside its code.

pub(crate) mod cubic;
pub(crate) mod determinant;
pub(crate) mod double_double;
pub(crate) mod number;
pub(crate) mod precise_cubic;
pub(crate) mod roundoff;
pub(crate) mod vector;

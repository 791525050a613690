//! Root parity: the methods before [`RootParity`](exact_ccd::parity::RootParity).
//!
//! F maps the domain of (t, u, v) to a solid, the image. If the origin is not on a face of it, F
//! has as many roots, mod 2, as a ray from the origin crosses faces. A face is a bilinear patch;
//! two triangles stand for it. The predicates are signs of a few polynomials in the corners: the
//! two methods compute them in different numbers, cast different rays, and differ in flat faces.

mod brochu;
mod culling;
mod expansion;
mod fold;
mod image;
mod number;
mod patch;
mod rational;
mod ray;

pub use brochu::BrochuRootParity;
pub use rational::RationalRootParity;

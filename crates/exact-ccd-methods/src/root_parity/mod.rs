//! Root parity, the methods before [`RootParity`](crate::RootParity).
//!
//! F maps the domain of (t, u, v) to a solid, the image. If the origin is not on a face of it, F
//! has as many roots, mod 2, as a ray from the origin crosses faces. A face is a bilinear patch;
//! two triangles stand for it. All that counts is the signs of a few polynomials in the corners:
//! the two methods compute them in different numbers, cast different rays, and differ in faces that
//! are flat.

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

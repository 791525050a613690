//! Root parity: the number of contacts mod 2, fast and exactly.
//!
//! The method of B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider, *Fast and
//! Exact Root Parity for Continuous Collision Detection*, Computer Graphics Forum 41(2), 2022. F
//! maps the domain of (t, u, v), a prism or a hexahedron, to a solid with bilinear faces. If the
//! origin is not on a face, then F has as many roots, mod 2, as a ray from the origin has crossings
//! with the faces. The crossings follow from signs of determinants of corners of the solid, if
//! these are exact: for that, the input is rounded first ([`Rounded`]).
//!
//! Zero contacts, two contacts and one grazing contact have the same parity.
//! [`Query::collides`](exact_ccd::Query::collides) and
//! [`Query::intervals`](exact_ccd::Query::intervals) distinguish them, without rounding; this
//! module is for comparison with the paper. The chapter `docs/parity.md` of the repository explains the
//! method.
//!
//! The rounding of the input needs the [default environment](exact_ccd::environment): to nearest, with
//! gradual underflow. [`Rounded::parity`] is right on any thread, and so is [`rational`], which needs no
//! rounding.
//!
//! [`RootParity`] is the method of the paper. [`BrochuRootParity`] and [`RationalRootParity`] are the
//! methods before it. The three have the same domain, patches, rays and predicates. Each predicate is a
//! polynomial; the methods differ in the numbers for which it is evaluated: f64 with an error bound or
//! intervals, then expansions, or integers.
//!
//! ```
//! use exact_ccd::{Query, VertexFace};
//! use exact_ccd_methods::parity::{Parity, Rounded};
//!
//! let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
//! let at = |point| [point, face[0], face[1], face[2]];
//! let falls = |end| Query::<VertexFace>::new(at([1.0, 1.0, 1.0]), at(end));
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, -1.0])?)?.parity(), Parity::Odd);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.5])?)?.parity(), Parity::Even);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.0])?)?.parity(), Parity::Boundary);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod approximate;
mod brochu;
mod culling;
mod decide;
mod expansion;
mod floats;
mod fold;
mod image;
mod intervals;
mod patch;
mod rational;
mod ray;
mod rounding;
mod signs;

pub use brochu::BrochuRootParity;
pub use decide::RootParity;
pub use rational::{RationalRootParity, rational};
pub use rounding::{Displacement, Rounded, RoundingError};

/// The number of contacts, mod 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parity {
    /// No contact, or an even number of them, counted with multiplicity: a grazing contact counts
    /// as two.
    Even,
    /// An odd number of contacts, counted with multiplicity, hence one at least.
    Odd,
    /// There is a contact on the boundary of the domain: at t = 0 or t = 1, or with an edge of the
    /// face or an end of an edge. Other contacts are not counted.
    Boundary,
}

impl Parity {
    /// The verdict of the paper's Algorithm 1: a collision unless the parity is even.
    #[must_use]
    pub fn is_collision(self) -> bool {
        self != Self::Even
    }
}

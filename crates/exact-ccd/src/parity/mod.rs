//! Root parity: whether the number of contacts is even or odd, fast and exactly.
//!
//! The method of B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider, *Fast and Exact Root Parity for
//! Continuous Collision Detection*, Computer Graphics Forum 41(2), 2022. F maps the domain of (t, u, v), a prism or a
//! hexahedron, to a solid with bilinear faces. If the origin is not on a face, then F has as many roots, mod 2, as a ray
//! from the origin has crossings with the faces. All that it takes are signs of determinants of corners of the solid, if
//! these are exact: for that, the input is rounded first ([`Rounded`]).
//!
//! Zero contacts and two look the same. [`Query::collides`] and [`Query::contact_times`] tell them apart, without rounding,
//! and faster; this module is for comparison, and for who wants the paper's answer.
//!
//! ```
//! use exact_ccd::VertexFace;
//! use exact_ccd::parity::{Parity, Rounded};
//!
//! let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
//! let falls = |end| VertexFace::new([[1.0, 1.0, 1.0], face[0], face[1], face[2]], [end, face[0], face[1], face[2]]);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, -1.0])?)?.parity(), Parity::Odd);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.5])?)?.parity(), Parity::Even);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.0])?)?.parity(), Parity::Boundary);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod corner;
mod patch;
mod planar;
mod ray;
mod rounding;

use core::cmp::Ordering;

pub use rounding::{Displacement, Rounded, RoundingError};

use crate::exact::to_integers;
use crate::kind::Kind;
use crate::query::Query;
use arrayvec::ArrayVec;
use corner::{Corner, Integers};

/// The number of contacts, mod 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parity {
    /// No contact, or an even number of them.
    Even,
    /// An odd number of contacts, hence one at least.
    Odd,
    /// There is a contact on the boundary of the domain: at t = 0 or t = 1, or with an edge of the face or an end of an
    /// edge. Other contacts are not counted.
    Boundary,
}

impl Parity {
    /// What the paper's Algorithm 1 makes of it: a collision unless the parity is even.
    #[must_use]
    pub fn is_collision(self) -> bool {
        self != Self::Even
    }
}

impl<K: Kind> Rounded<K> {
    /// The parity of the number of contacts of the rounded query.
    #[must_use]
    pub fn parity(&self) -> Parity {
        parity::<K, _>(self.corners())
    }
}

/// The parity of the number of contacts of a query as it is, in integers: slow, without filter and without rounding.
#[must_use]
pub fn rational<K: Kind>(query: &Query<K>) -> Parity {
    let axes = [0, 1, 2].map(|axis: usize| {
        to_integers([0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| query.points()[i / 4][i % 4][axis])).0
    });
    let corners: [Integers; 8] = core::array::from_fn(|index| {
        let (i, j) = K::CORNERS[index % 4];
        let first = index - index % 4;
        [0, 1, 2].map(|axis: usize| &axes[axis][first + i] - &axes[axis][first + j])
    });
    parity::<K, _>(&corners)
}

/// The most faces of a domain.
const MOST_PATCHES: usize = 6;

fn parity<K: Kind, C: Corner>(corners: &[C; 8]) -> Parity {
    let signs = Signs::new(corners);
    if signs.exclude_origin(u8::MAX) {
        return Parity::Even;
    }
    let mut triangles = ArrayVec::<[usize; 3], { 2 * MOST_PATCHES }>::new();
    for patch in K::PATCHES {
        let is_near = !signs.exclude_origin(mask(patch));
        let Some(pair) = patch::stand_in(patch.map(|corner| &corners[corner]), is_near) else {
            return Parity::Boundary;
        };
        triangles.extend(pair.map(|triangle| triangle.map(|corner| patch[corner])));
    }
    let crossings = |k| {
        let ray = ray::direction::<C>(k);
        let mut is_odd = false;
        for triangle in &triangles {
            if !signs.exclude_ray(&ray, mask(triangle)) {
                is_odd ^= ray::crosses(&ray, triangle.map(|corner| &corners[corner]))?;
            }
        }
        Some(if is_odd { Parity::Odd } else { Parity::Even })
    };
    // One of the first directions serves; see `ray`.
    (0..).find_map(crossings).unwrap_or(Parity::Even)
}

/// Which corners have positive and which negative coordinates, as sets of bits by axis.
struct Signs {
    positive: [u8; 3],
    negative: [u8; 3],
}

fn mask(corners: &[usize]) -> u8 {
    corners.iter().fold(0, |mask, corner| mask | 1 << corner)
}

impl Signs {
    fn new<C: Corner>(corners: &[C; 8]) -> Self {
        let with = |sign: Ordering| {
            [0, 1, 2].map(|axis: usize| {
                let bit = |index: usize| u8::from(corners[index].sign(axis) == sign) << index;
                (0..8).map(bit).fold(0, |mask, bit| mask | bit)
            })
        };
        Self {
            positive: with(Ordering::Greater),
            negative: with(Ordering::Less),
        }
    }

    /// Whether the bounding box of some corners leaves out the origin.
    fn exclude_origin(&self, mask: u8) -> bool {
        (0..3).any(|axis| self.positive[axis] & mask == mask || self.negative[axis] & mask == mask)
    }

    /// Whether it leaves out the ray, of which no coordinate is negative.
    fn exclude_ray<C: Corner>(&self, ray: &C, mask: u8) -> bool {
        (0..3).any(|axis| {
            self.negative[axis] & mask == mask
                || (self.positive[axis] & mask == mask && ray.sign(axis).is_eq())
        })
    }
}

//! Root parity: the number of contacts mod 2, fast and exactly.
//!
//! The method of B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider, *Fast and
//! Exact Root Parity for Continuous Collision Detection*, Computer Graphics Forum 41(2), 2022. F
//! maps the domain of (t, u, v), a prism or a hexahedron, to a solid with bilinear faces. If the
//! origin is not on a face, then F has as many roots, mod 2, as a ray from the origin has crossings
//! with the faces. The crossings follow from signs of determinants of corners of the solid, if
//! these are exact: for that, the input is rounded first ([`Rounded`]).
//!
//! Zero contacts, two contacts and one grazing contact have the same parity. [`Query::collides`]
//! and [`Query::contact_times`] distinguish them, without rounding; this module is for comparison
//! with the paper. The chapter `docs/parity.md` of the repository explains the method.
//!
//! The rounding of the input, unlike all other answers of this crate, needs the [default
//! environment](crate::environment): to nearest, with gradual underflow. [`Rounded::parity`] is right on any
//! thread, and so is [`rational`], which needs no rounding.
//!
//! ```
//! use exact_ccd::{Query, VertexFace};
//! use exact_ccd::parity::{Parity, Rounded};
//!
//! let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
//! let at = |point| [point, face[0], face[1], face[2]];
//! let falls = |end| Query::<VertexFace>::new(at([1.0, 1.0, 1.0]), at(end));
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, -1.0])?)?.parity(), Parity::Odd);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.5])?)?.parity(), Parity::Even);
//! assert_eq!(Rounded::shift(&falls([1.0, 1.0, 0.0])?)?.parity(), Parity::Boundary);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod corner;
mod decide;
mod patch;
mod planar;
mod ray;
mod rounding;

pub use decide::RootParity;
pub use rounding::{Displacement, Rounded, RoundingError};

use crate::environment;
use crate::exact::to_integers;
use crate::kind::Kind;
use crate::predicates::Integers;
use crate::query::Query;
use corner::Corner;
use ray::Ray;

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

impl<K: Kind> Rounded<K> {
    /// The parity of the number of contacts of the rounded query.
    #[must_use]
    pub fn parity(&self) -> Parity {
        if environment::is_default() {
            parity::<K, _>(self.corners())
        } else {
            rational(self.query())
        }
    }
}

/// The parity of the number of contacts of a query as it is, in integers: slow, without filter and
/// without rounding.
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

fn parity<K: Kind, C: Corner>(corners: &[C; 8]) -> Parity {
    let signs = Signs::new(corners);
    if signs.exclude_origin(u8::MAX) || C::certainly_exclude_origin(corners) {
        return Parity::Even;
    }
    // At least one of these rays is valid, as `ray` proves.
    let parity = (0..ray::COUNT).find_map(|k| cast::<K, C>(&Ray::new(k), corners, &signs));
    debug_assert!(parity.is_some(), "no ray is valid");
    // The conservative answer, for a case that cannot occur.
    parity.unwrap_or(Parity::Boundary)
}

/// The parity of the crossings of a ray, or `None` if it meets the boundary of a face.
fn cast<K: Kind, C: Corner>(ray: &Ray<C>, corners: &[C; 8], signs: &Signs) -> Option<Parity> {
    let mut parity = Some(false);
    for patch in K::PATCHES {
        let mask = mask(*patch);
        if signs.exclude_ray(ray.is_axis(), mask) {
            continue;
        }
        let corners = patch.map(|corner| &corners[corner]);
        let Some(passage) = ray.pass(corners) else {
            continue;
        };
        let Some(pair) = patch::stand_in(corners, !signs.exclude_origin(mask)) else {
            return Some(Parity::Boundary);
        };
        for triangle in pair {
            let crosses = ray.crosses(&passage, corners, triangle);
            parity = parity.zip(crosses).map(|(parity, crosses)| parity ^ crosses);
        }
    }
    parity.map(|is_odd| if is_odd { Parity::Odd } else { Parity::Even })
}

/// The corners with positive and with negative coordinates, as sets of bits by axis.
struct Signs {
    positive: [u8; 3],
    negative: [u8; 3],
}

/// Four of the corners as a set of bits.
#[inline]
fn mask([a, b, c, d]: [usize; 4]) -> u8 {
    1 << a | 1 << b | 1 << c | 1 << d
}

impl Signs {
    #[inline]
    fn new<C: Corner>(corners: &[C; 8]) -> Self {
        let mut signs = Self {
            positive: [0; 3],
            negative: [0; 3],
        };
        for (index, corner) in corners.iter().enumerate() {
            for axis in 0..3 {
                signs.positive[axis] |= u8::from(corner.is_positive(axis)) << index;
                signs.negative[axis] |= u8::from(corner.is_negative(axis)) << index;
            }
        }
        signs
    }

    /// Returns true if the bounding box of some corners does not contain the origin.
    #[inline]
    fn exclude_origin(&self, mask: u8) -> bool {
        (0..3).fold(false, |excluded, axis| {
            excluded | (self.positive[axis] & mask == mask) | (self.negative[axis] & mask == mask)
        })
    }

    /// Returns true if the bounding box of some corners excludes a ray all of whose coordinates are
    /// positive or, if it is the x axis, all but x are zero.
    #[inline]
    fn exclude_ray(&self, is_axis: bool, mask: u8) -> bool {
        let [_, y, z] = self.positive.map(|positive| positive & mask == mask);
        let is_behind = self.negative.map(|negative| negative & mask == mask) != [false; 3];
        is_behind | (is_axis & (y | z))
    }
}

#[cfg(test)]
mod tests {
    use proptest::array::{uniform2, uniform8};
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;
    use crate::point::Point;
    use crate::{EdgeEdge, VertexFace};

    /// The edges of the domain and the diagonals of its faces. Each rejects two rays at most.
    const LINES_OF_PRISM: u32 = 9 + 6;
    const LINES_OF_HEXAHEDRON: u32 = 12 + 12;

    /// The number of rays that are rejected before the first valid one.
    fn rejected<K: Kind>(corners: &[Point; 8]) -> u32 {
        let signs = Signs::new(corners);
        if signs.exclude_origin(u8::MAX) {
            return 0;
        }
        (0..ray::COUNT)
            .take_while(|&k| cast::<K, _>(&Ray::new(k), corners, &signs).is_none())
            .count() as u32
    }

    /// The number for a prism: corners 3 and 7 are replaced.
    fn rejected_by_prism(mut corners: [Point; 8]) -> u32 {
        (corners[3], corners[7]) = (corners[2], corners[6]);
        rejected::<VertexFace>(&corners)
    }

    /// A linear map that takes the k-th ray to the (k + shift)-th.
    fn forward(shift: f64, [x, y, z]: Point) -> Point {
        [x, y + shift * x, z + 2.0 * shift * y + shift * shift * x]
    }

    /// Each side of a triangle lies across two rays, and so does each side of a parallelogram.
    const TRIANGLE: [Point; 3] = [[2.0, 3.0, 3.0], [2.0, 7.0, 23.0], [-2.0, -5.0, -5.0]];
    const PARALLELOGRAM: [Point; 4] = [
        [2.0, 3.0, 3.0],
        [6.0, 21.0, 69.0],
        [-2.0, -7.0, -7.0],
        [2.0, 11.0, 59.0],
    ];

    #[test]
    fn edges_across_the_first_rays_reject_them() {
        let [a, b, c] = TRIANGLE;
        let face = [a, b, c, c];
        let later = face.map(|corner| forward(6.0, corner));
        let count = rejected_by_prism([face, later].as_flattened().try_into().unwrap());
        assert!((12..=2 * LINES_OF_PRISM).contains(&count), "{count}");

        let later = PARALLELOGRAM.map(|corner| forward(8.0, corner));
        let count = rejected::<EdgeEdge>([PARALLELOGRAM, later].as_flattened().try_into().unwrap());
        assert!((16..=2 * LINES_OF_HEXAHEDRON).contains(&count), "{count}");
    }

    /// On one of the first rays, opposite of one, or in the plane of two.
    fn corner() -> impl Strategy<Value = Point> {
        let ray = (0..6u8).prop_map(|k| [1, k, k * k].map(f64::from));
        (uniform2(ray), uniform2(-2..=2i8)).prop_map(|([a, b], factors)| {
            let [x, y] = factors.map(f64::from);
            [0, 1, 2].map(|axis: usize| x * a[axis] + y * b[axis])
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 50_000,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(0),
            ..ProptestConfig::default()
        })]

        #[test]
        fn few_rays_are_rejected(corners in uniform8(corner())) {
            prop_assert!(rejected_by_prism(corners) <= 2 * LINES_OF_PRISM);
            prop_assert!(rejected::<EdgeEdge>(&corners) <= 2 * LINES_OF_HEXAHEDRON);
        }
    }
}

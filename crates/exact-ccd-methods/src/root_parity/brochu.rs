//! The method as published.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::iter::successors;

use dashu_ratio::Relaxed;
use exact_ccd::{Ccd, Decide, Guarantees, Point, Query, TimeGuarantee};

use super::culling;
use super::expansion::Expansion;
use super::image::{Differences, Image, Predicate, RAY, Solid, Vectors, differences, vectors};
use super::number::{Number, Vector};
use super::patch::hull_contains_origin;
use super::ray::cast;
use crate::interval::Interval;

/// Root parity as it was first published: a ray from the origin, and signs in intervals first, then
/// in expansions.
///
/// T. Brochu, E. Edwards and R. Bridson, *Efficient Geometrically Exact Continuous Collision
/// Detection*, ACM Transactions on Graphics 31(4), 2012, and their code in El Topo
/// (`rootparitycollisiontest`, of 2011).
///
/// F maps the domain of (t, u, v) to a solid with bilinear faces, each of which is replaced by two
/// triangles. A query is free if the corners are on one side of one of a few planes through the
/// origin. Otherwise, it collides if a ray from the origin crosses the faces an odd number
/// of times. A ray that meets the boundary of a triangle is replaced; here the next one has a fixed
/// direction, not a random one.
///
/// Where expansions would overflow or underflow, signs come from rational numbers.
///
/// # When it fails
/// An even number of contacts is a false negative: 2797 of the 4179 colliding pairs of edges in the
/// scene rod-twist, and 5 of 145 among the handcrafted ones.
///
/// False positives are rare:
/// - The ray is a segment that is longer than the solid by 10, whatever the unit of length. If it
///   crosses the image of the face at t = 0 or t = 1, and the barycentric coordinate of the origin
///   on the segment is 1, rounded, then the origin counts as on the face: less than 10⁻¹⁵ between a
///   vertex and a face may be a contact. So are 2 of the 1558 handcrafted queries of a vertex and a
///   face that do not collide.
/// - If the origin is in one plane with the corners of a face, their hull replaces the face. The hull
///   is larger if a corner is reflex.
/// - All rays are horizontal. If horizontal edges surround the origin, all rays meet them, which
///   counts as a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrochuRootParity {
    /// The number of rays that are cast before a query counts as a contact.
    pub rays: u16,
    /// The length by which a ray, taken along one axis, exceeds the solid.
    pub margin: f64,
}

impl Default for BrochuRootParity {
    fn default() -> Self {
        Self {
            rays: 10,
            margin: 10.0,
        }
    }
}

/// The directions to try. Each is the one before, turned by an angle of the right triangle with the
/// sides 3, 4 and 5: no multiple of that is a full turn.
fn rays() -> impl Iterator<Item = Point> {
    successors(Some([1.0, 1.0, 0.0]), |[x, y, z]| {
        Some([0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, *z])
    })
}

/// An image in intervals, and exactly where these leave a sign open.
struct Filtered {
    differences: Differences,
    intervals: Vectors<Interval>,
    exact: OnceCell<Exact>,
}

enum Exact {
    Expansions(Box<Vectors<Expansion>>),
    /// Where expansions would overflow or underflow.
    Rationals(Box<Vectors<Relaxed>>),
}

impl Exact {
    fn new(differences: &Differences) -> Self {
        let mut coordinates = differences.as_flattened().as_flattened().iter();
        if coordinates.all(|&x| Expansion::can_hold(x)) {
            Self::Expansions(Box::new(vectors(differences)))
        } else {
            Self::Rationals(Box::new(vectors(differences)))
        }
    }

    fn sign(&self, predicate: Predicate) -> Ordering {
        let sign = match self {
            Self::Expansions(vectors) => predicate.value(vectors).certain_sign(),
            Self::Rationals(vectors) => predicate.value(vectors).certain_sign(),
        };
        sign.unwrap_or(Ordering::Equal)
    }
}

impl Image for Filtered {
    fn sign(&self, predicate: Predicate) -> Ordering {
        if predicate.vanishes() {
            return Ordering::Equal;
        }
        let sign = predicate.value(&self.intervals).certain_sign();
        sign.unwrap_or_else(|| {
            let exact = self.exact.get_or_init(|| Exact::new(&self.differences));
            exact.sign(predicate)
        })
    }

    fn flat_patch_contains_origin(&self, patch: [usize; 4]) -> bool {
        hull_contains_origin(self, patch)
    }
}

impl Filtered {
    fn new<K: Solid>(query: &Query<K>, ray: Point) -> Self {
        let differences = differences(query, ray);
        Self {
            intervals: vectors(&differences),
            differences,
            exact: OnceCell::new(),
        }
    }

    fn corners(&self) -> &[Vector<Interval>; 8] {
        let [corners @ .., _ray] = &self.intervals;
        corners
    }

    /// The larger distance from the origin to an extreme corner of the bounding box.
    fn extent(&self) -> f64 {
        let distance = |bound: fn(&Vector<Interval>, usize) -> f64| {
            let bounds = [0, 1, 2].map(|axis| {
                self.corners()
                    .iter()
                    .map(|corner| bound(corner, axis))
                    .fold(0.0, f64::max)
            });
            bounds.iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        distance(|corner, axis| corner[axis].upper).max(distance(|corner, axis| -corner[axis].lower))
    }

    /// True if the ray, as a segment of this length, meets a triangle at the origin, up to rounding.
    ///
    /// It meets it at V / (S₀ + S₁ + S₂), in units of the direction: V is the volume of the
    /// corners, Sᵢ that of the direction and an edge. What remains of the segment is the
    /// barycentric coordinate of the origin.
    fn starts_on_triangle(&self, [a, b, c]: [usize; 3], length: f64) -> bool {
        let estimate = |predicate: Predicate| {
            let Interval { lower, upper } = predicate.value(&self.intervals);
            0.5 * (lower + upper)
        };
        let volume = Predicate::Volume([a, b, c]);
        let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| Predicate::Volume([RAY, from, to]));
        let distance = estimate(volume) / sides.map(estimate).iter().sum::<f64>();
        1.0 - distance / length == 1.0 && {
            let backward = self.sign(volume).reverse();
            backward.is_ne() && sides.iter().all(|&side| self.sign(side) != backward)
        }
    }
}

impl<K: Solid> Decide<K> for BrochuRootParity {
    fn collides(&self, query: &Query<K>) -> bool {
        let domain = K::DOMAIN;
        let mut images = rays()
            .map(|ray| Filtered::new(query, ray))
            .take(self.rays.into())
            .peekable();
        if let Some(first) = images.peek()
            && culling::separates(first.corners(), domain.faces)
        {
            return false;
        }
        let collides = images.find_map(|image| {
            let length = image.extent() + self.margin;
            let starts_on_face = domain
                .triangles()
                .any(|triangle| image.starts_on_triangle(triangle, length));
            if starts_on_face {
                Some(true)
            } else {
                cast(&image, domain.faces)
            }
        });
        collides.unwrap_or(true)
    }
}

impl Ccd for BrochuRootParity {
    fn name(&self) -> &'static str {
        "RP"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: true,
            false_positives: true,
            time: TimeGuarantee::Absent,
        }
    }
}

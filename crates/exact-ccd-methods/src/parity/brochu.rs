//! The method as published.

use std::iter::successors;

use exact_ccd::{Decide, Kind, Point, Query};

use super::image::{Domain, Image, Predicate, RAY, with_ray};
use super::intervals::Intervals;
use super::ray::{along_ray, cast};
use super::{Parity, culling};
use crate::interval::Enclosure;
use crate::vector::Vector;

/// Root parity as it was first published: a ray from the origin, and signs in intervals first, then
/// in expansions.
///
/// T. Brochu, E. Edwards and R. Bridson, *Efficient Geometrically Exact Continuous Collision
/// Detection*, ACM Transactions on Graphics 31(4), 2012, and their code in El Topo
/// (`rootparitycollisiontest`, of 2011).
///
/// F maps the domain of (t, u, v) to a solid with bilinear faces. Each face is replaced by two triangles. A
/// query is free if the corners are on one side of one of a few planes through the origin. Otherwise, it
/// collides if a ray from the origin crosses the faces an odd number of times. A ray that meets the
/// boundary of a triangle is replaced; here the next one has a fixed direction, not a random one.
///
/// Where expansions would overflow or underflow, signs come from integers.
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

/// The larger distance from the origin to an extreme corner of the bounding box.
fn extent(corners: &[Vector<Enclosure>]) -> f64 {
    let distance = |bound: fn(&Vector<Enclosure>, usize) -> f64| {
        let bounds = [0, 1, 2].map(|axis| {
            corners
                .iter()
                .map(|corner| bound(corner, axis))
                .fold(0.0, f64::max)
        });
        bounds.iter().map(|x| x * x).sum::<f64>().sqrt()
    };
    distance(|corner, axis| corner[axis].upper).max(distance(|corner, axis| -corner[axis].lower))
}

/// Returns true if the ray, as a segment of this length, meets a triangle at the origin, up to rounding.
///
/// It meets it at V / (S₀ + S₁ + S₂), in units of the direction: V is the volume of the corners, Sᵢ the
/// volume of the direction and an edge. The rest of the segment, as a fraction, is the barycentric
/// coordinate of the origin.
fn starts_on_triangle(image: &Intervals, [a, b, c]: [usize; 3], length: f64) -> bool {
    let estimate = |predicate: Predicate| predicate.value(image.vectors()).middle();
    let volume = Predicate::Volume([a, b, c]);
    let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| Predicate::Volume([RAY, from, to]));
    let distance = estimate(volume) / sides.map(estimate).iter().sum::<f64>();
    1.0 - distance / length == 1.0 && {
        let backward = image.sign(volume).reverse();
        backward.is_ne() && sides.iter().all(|&side| image.sign(side) != backward)
    }
}

impl<K: Kind<Points = [Point; 4]>> Decide<K> for BrochuRootParity {
    fn collides(&self, query: &Query<K>) -> bool {
        let domain = Domain::of::<K>();
        let pairs = domain.pairs(query);
        let mut images = rays()
            .map(|ray| Intervals::new(&with_ray(&pairs, ray)))
            .take(self.rays.into())
            .peekable();
        if let Some(first) = images.peek() {
            let [corners @ .., _ray] = first.vectors();
            if culling::separates(corners, domain.faces) {
                return false;
            }
        }
        let collides = images.find_map(|image| {
            let length = extent(&image.vectors()[..RAY]) + self.margin;
            let mut triangles = domain.triangles();
            if triangles.any(|triangle| starts_on_triangle(&image, triangle, length)) {
                return Some(true);
            }
            let faces = domain.faces.iter().copied();
            cast(&image, faces, along_ray, |_| false, |_| true).map(Parity::is_collision)
        });
        collides.unwrap_or(true)
    }
}

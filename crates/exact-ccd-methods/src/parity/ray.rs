//! Rays from the origin, and their crossings with the faces (appendix A of the paper).
//!
//! A ray is valid if it meets no triangle at its boundary. Where it is not, the paper casts another
//! random one. Here, the directions are (1, k, k²), k = 0, 1, 2, …, and at least one of the first 49
//! is valid. A ray is rejected because of two corners of one face: it lies in the plane through them
//! and the origin or, if they are on a line through the origin, along that line. The faces have at
//! most 24 such pairs of corners: their edges and their diagonals. No plane through the origin
//! contains more than two of the directions, and no two directions are parallel. So each pair
//! rejects at most two of them.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use exact_ccd::Point;

use super::image::{Differences, Domain, Image, Predicate, RAY, integers, with_ray};
use super::patch::{AROUND_02, stand_in};
use super::signs::Signs;
use super::{Parity, fold};

/// The largest number of rays that a query rejects.
const MOST_REJECTED: u32 = 2 * 24;

/// The parity by the first valid ray, of the solid whose corners are these differences.
#[inline]
pub(super) fn parity<I: Image>(
    domain: &Domain,
    pairs: &[[Point; 2]; 8],
    image_of: impl Fn(&Differences) -> I,
) -> Parity {
    let signs = Signs::new(pairs);
    if signs.exclude_origin(&[0, 1, 2, 3, 4, 5, 6, 7]) {
        return Parity::Even;
    }
    let parity = (0..=MOST_REJECTED).find_map(|k| {
        let differences = with_ray(pairs, [1, k, k * k].map(f64::from));
        let faces = domain.faces.iter().copied();
        let faces = faces.filter(|face| !signs.exclude_ray(k == 0, face));
        let covers = |patch: [usize; 4]| {
            let corners = integers(&patch.map(|corner| differences[corner]));
            fold::contains_origin(corners.each_ref())
        };
        let is_far = |patch: [usize; 4]| signs.exclude_origin(&patch);
        let image = image_of(&differences);
        if k == 0 {
            cast(&image, faces, |edge| Predicate::Turn(0, edge), is_far, covers)
        } else {
            cast(&image, faces, along_ray, is_far, covers)
        }
    });
    debug_assert!(parity.is_some(), "no ray is valid");
    // The conservative answer, for a case that cannot occur.
    parity.unwrap_or(Parity::Boundary)
}

/// The side of the ray on which the line through two corners passes.
pub(super) fn along_ray([a, b]: [usize; 2]) -> Predicate {
    Predicate::Volume([RAY, a, b])
}

/// The parity of the crossings of the ray of an image with faces; `None` if it meets the boundary of a
/// triangle, so that they cannot be counted.
///
/// `side` is the side of the ray on which the line through two corners passes. `is_far` proves that the
/// origin is not in the hull of a patch, `covers` that it is on a patch in whose plane and hull it is.
#[inline]
pub(super) fn cast(
    image: &impl Image,
    faces: impl Iterator<Item = [usize; 4]>,
    side: impl Fn([usize; 2]) -> Predicate,
    is_far: impl Fn([usize; 4]) -> bool,
    covers: impl Fn([usize; 4]) -> bool,
) -> Option<Parity> {
    let mut is_odd = Some(false);
    for patch in faces {
        let Some(passage) = Passage::of(image, patch, &side) else {
            continue;
        };
        let triangles = if is_far(patch) {
            AROUND_02
        } else {
            let Some(triangles) = stand_in(image, patch, &covers) else {
                return Some(Parity::Boundary);
            };
            triangles
        };
        for triangle in triangles {
            is_odd = is_odd
                .zip(passage.crosses(image, triangle))
                .map(|(is_odd, crosses)| is_odd ^ crosses);
        }
    }
    is_odd.map(|is_odd| if is_odd { Parity::Odd } else { Parity::Even })
}

/// The line of a ray, and a patch.
struct Passage {
    patch: [usize; 4],
    /// For two corners of the patch, the side of the ray's line on which the line through them passes.
    sides: [[Ordering; 4]; 4],
}

impl Passage {
    /// `None` if the line misses the hull of the corners: as seen along it, all other corners are strictly
    /// on one side of the line through one of them.
    #[inline]
    fn of(image: &impl Image, patch: [usize; 4], side: &impl Fn([usize; 2]) -> Predicate) -> Option<Self> {
        let mut sides = [[Equal; 4]; 4];
        for i in 0..3 {
            for j in i + 1..4 {
                sides[i][j] = image.sign(side([patch[i], patch[j]]));
                sides[j][i] = sides[i][j].reverse();
            }
        }
        let is_outermost = |i: usize| {
            [Less, Greater]
                .into_iter()
                .any(|side| (0..4).all(|j| i == j || sides[i][j] == side))
        };
        (!(0..4).any(is_outermost)).then_some(Self { patch, sides })
    }

    /// True if the ray crosses a triangle of corners of the patch that does not contain the origin;
    /// `None` if it meets the boundary.
    ///
    /// The ray crosses the triangle if its volumes with the three edges have the sign of the volume of
    /// the triangle.
    #[inline]
    fn crosses(&self, image: &impl Image, triangle: [usize; 3]) -> Option<bool> {
        let [i, j, k] = triangle;
        let sides = [self.sides[i][j], self.sides[j][k], self.sides[k][i]];
        if sides.contains(&Less) && sides.contains(&Greater) {
            return Some(false);
        }
        let [a, b, c] = triangle.map(|corner| self.patch[corner]);
        match image.sign(Predicate::Volume([a, b, c])) {
            // The ray leaves the plane of the triangle, or is in it.
            Equal => {
                let meets = sides == [Equal; 3]
                    && [[a, b], [b, c], [c, a]]
                        .into_iter()
                        .any(|edge| meets_in_plane(image, edge));
                (!meets).then_some(false)
            }
            facing if sides.contains(&facing.reverse()) => Some(false),
            facing => (sides == [facing; 3]).then_some(true),
        }
    }
}

/// True if the ray meets an edge that is in one plane with it.
///
/// Seen along an axis, if the ends of the edge are not both on the line of the ray, they are on
/// different sides of it, or one is on it, and the turn from one end to the other is that from the
/// end to the ray, or a half turn. If both are on it, one is in front.
fn meets_in_plane(image: &impl Image, [a, b]: [usize; 2]) -> bool {
    for axis in 0..3 {
        let turn = |from: usize, to: usize| image.sign(Predicate::Turn(axis, [from, to]));
        let (to_ray, from_ray) = (turn(a, RAY), turn(RAY, b));
        let forward = to_ray.then(from_ray);
        if forward.is_ne() {
            return [to_ray, from_ray, turn(a, b)]
                .iter()
                .all(|&sign| sign != forward.reverse());
        }
    }
    [a, b]
        .into_iter()
        .any(|end| image.sign(Predicate::Dot([end, RAY])).is_ge())
}

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

use super::image::{Domain, Image, Predicate, RAY, integers};
use super::patch::{AROUND_02, stand_in};
use super::signs::Signs;
use super::{Parity, fold};

/// The largest number of rays that a query rejects.
const MOST_REJECTED: u32 = 2 * 24;

/// The parity by the first valid ray, of the solid whose corners are these differences, given its image
/// with a ray.
#[inline]
pub(super) fn parity<I: Image>(
    domain: &Domain,
    pairs: &[[Point; 2]; 8],
    with_ray: impl Fn(Point) -> I,
) -> Parity {
    let signs = Signs::new(pairs);
    if signs.exclude_origin(&[0, 1, 2, 3, 4, 5, 6, 7]) {
        return Parity::Even;
    }
    let parity = (0..=MOST_REJECTED).find_map(|k| by_ray(k, domain, pairs, &signs, &with_ray));
    debug_assert!(parity.is_some(), "no ray is valid");
    // The conservative answer, for a case that cannot occur.
    parity.unwrap_or(Parity::Boundary)
}

/// The parity by the k-th ray; `None` if it is not valid.
#[inline]
fn by_ray<I: Image>(
    k: u32,
    domain: &Domain,
    pairs: &[[Point; 2]; 8],
    signs: &Signs,
    with_ray: &impl Fn(Point) -> I,
) -> Option<Parity> {
    let faces = domain.faces.iter().copied();
    let faces = faces.filter(|face| !signs.exclude_ray(k == 0, face));
    let is_far = |patch: [usize; 4]| signs.exclude_origin(&patch);
    let covers = |patch: [usize; 4]| {
        let corners = integers(&patch.map(|corner| pairs[corner]));
        fold::contains_origin(corners.each_ref())
    };
    let image = with_ray([1, k, k * k].map(f64::from));
    if k == 0 {
        // The ray is the x axis.
        cast(&image, faces, |edge| Predicate::Turn(0, edge), is_far, covers)
    } else {
        cast(&image, faces, along_ray, is_far, covers)
    }
}

/// The side of the ray on which the line through two corners passes.
pub(super) fn along_ray([a, b]: [usize; 2]) -> Predicate {
    Predicate::Volume([RAY, a, b])
}

/// The parity of the crossings of the ray of an image with faces; `None` if it meets the boundary of a
/// triangle, so that they cannot be counted.
///
/// `side` is the side of the ray on which the line through two corners passes. `is_far` proves that the
/// origin is not in the hull of a patch. `covers` returns true if the origin is on a patch, and is called
/// only if the origin is in the plane and in the hull of this patch.
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
    /// For each corner, the corners to its left and to its right, as seen along the line, as sets of bits.
    left: [u8; 4],
    right: [u8; 4],
}

impl Passage {
    /// `None` if the line misses the hull of the corners: as seen along it, all other corners are strictly
    /// on one side of the line through one of them.
    #[inline]
    fn of(image: &impl Image, patch: [usize; 4], side: &impl Fn([usize; 2]) -> Predicate) -> Option<Self> {
        let (mut left, mut right) = ([0; 4], [0; 4]);
        for i in 0..3 {
            for j in i + 1..4 {
                let side = image.sign(side([patch[i], patch[j]]));
                let (is_left, is_right) = (u8::from(side.is_gt()), u8::from(side.is_lt()));
                left[i] |= is_left << j;
                right[i] |= is_right << j;
                left[j] |= is_right << i;
                right[j] |= is_left << i;
            }
        }
        let is_outermost = |i: usize| left[i].max(right[i]) == 0b1111 ^ 1 << i;
        (!(0..4).any(is_outermost)).then_some(Self { patch, left, right })
    }

    /// The side of the ray's line on which the line from one corner to another passes.
    fn side(&self, from: usize, to: usize) -> Ordering {
        let is_in = |set: u8| set >> to & 1;
        is_in(self.left[from]).cmp(&is_in(self.right[from]))
    }

    /// Returns true if the ray crosses a triangle of corners of the patch that does not contain the origin;
    /// `None` if it meets the boundary.
    ///
    /// The ray crosses the triangle if its volumes with the three edges have the sign of the volume of
    /// the triangle.
    #[inline]
    fn crosses(&self, image: &impl Image, triangle: [usize; 3]) -> Option<bool> {
        let [i, j, k] = triangle;
        let sides = [self.side(i, j), self.side(j, k), self.side(k, i)];
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

/// Returns true if the ray meets an edge that is in one plane with it.
///
/// Look along an axis. If the ends of the edge are not both on the line of the ray, the ray meets the edge
/// in two cases: the ends are on different sides of the line, or one is on it; and the turn from one end to
/// the other has the sense of the turn from that end to the ray, or is a half turn. If both are on the line,
/// the ray meets the edge if one end is in front.
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

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, Kind, VertexFace};
    use proptest::array::{uniform2, uniform8};
    use proptest::prelude::*;

    use super::*;
    use crate::parity::floats::Floats;

    /// The edges of the domain and the diagonals of its faces. Each rejects two rays at most.
    const LINES_OF_PRISM: usize = 9 + 6;
    const LINES_OF_HEXAHEDRON: usize = 12 + 12;

    /// The number of rays that are rejected before the first valid one.
    fn rejected<K: Kind<Points = [Point; 4]>>(corners: &[Point; 8]) -> usize {
        let pairs = corners.map(|corner| [corner, [0.0; 3]]);
        let signs = Signs::new(&pairs);
        let parity = |k| {
            by_ray(k, Domain::of::<K>(), &pairs, &signs, &|ray| {
                Floats::new(corners, ray)
            })
        };
        (0..=MOST_REJECTED).take_while(|&k| parity(k).is_none()).count()
    }

    /// The number for a prism: corners 3 and 7 are replaced.
    fn rejected_by_prism(mut corners: [Point; 8]) -> usize {
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
        #![proptest_config(ProptestConfig::with_cases(50_000))]

        #[test]
        fn few_rays_are_rejected(corners in uniform8(corner())) {
            prop_assert!(rejected_by_prism(corners) <= 2 * LINES_OF_PRISM);
            prop_assert!(rejected::<EdgeEdge>(&corners) <= 2 * LINES_OF_HEXAHEDRON);
        }
    }
}

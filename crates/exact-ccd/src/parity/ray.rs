//! Rays from the origin, and the triangles that they cross (appendix A of the paper).
//!
//! A ray serves if it meets no triangle at its boundary. The paper casts another random one if it does; here, the
//! directions are (1, k, k²), k = 0, 1, 2, …, and one of the first 49 serves. For each direction that is rejected, there are
//! two corners of one face such that it lies in the plane through them and the origin, or, if they are on a line through the
//! origin, along that line. The faces have at most 24 such pairs: their edges and their diagonals. No plane through the
//! origin contains more than two of the directions, and no two of these are parallel: each pair rejects two at most.

use core::cmp::Ordering;

use super::corner::Corner;

/// A ray from the origin.
pub(super) struct Ray<C> {
    direction: C,
    is_axis: bool,
}

/// Where a ray passes a patch: on which side of the line through each two corners, as a table.
pub(super) struct Passage([[Ordering; 4]; 4]);

impl Passage {
    /// The passage of a line, given the side of it on which the line through two corners passes; `None` if all of them
    /// are strictly on one side of a plane through the line.
    #[inline]
    pub(super) fn new<C>(corners: [&C; 4], side: impl Fn(&C, &C) -> Ordering) -> Option<Self> {
        let mut table = [[Ordering::Equal; 4]; 4];
        for i in 0..3 {
            for j in i + 1..4 {
                let side = side(corners[i], corners[j]);
                table[i][j] = side;
                table[j][i] = side.reverse();
            }
        }
        // Then, seen along the line, one corner is the outermost in either sense of rotation: all others are on one side.
        let is_outermost = |i: usize, side: Ordering| (0..4).all(|j| j == i || table[i][j] == side);
        let misses = (0..4).any(|i| is_outermost(i, Ordering::Greater) || is_outermost(i, Ordering::Less));
        (!misses).then_some(Self(table))
    }
}

impl<C: Corner> Ray<C> {
    /// The k-th ray to try.
    pub(super) fn new(k: u32) -> Self {
        Self {
            direction: C::small([1, k, k * k]),
            is_axis: k == 0,
        }
    }

    /// Whether the ray has no part in y > 0 and z > 0 and their like, but only in the closed x axis.
    pub(super) fn is_axis(&self) -> bool {
        self.is_axis
    }

    /// How the ray passes four corners, or `None` if the whole line through it passes them on one side.
    #[inline]
    pub(super) fn pass(&self, corners: [&C; 4]) -> Option<Passage> {
        if self.is_axis {
            Passage::new(corners, |a, b| C::turn(0, a, b))
        } else {
            Passage::new(corners, |a, b| C::orientation(&self.direction, a, b))
        }
    }

    /// Whether the ray crosses a triangle of the four corners that does not contain the origin; `None` if it meets the
    /// triangle at its boundary, or may.
    pub(super) fn crosses(&self, passage: &Passage, corners: [&C; 4], triangle: [usize; 3]) -> Option<bool> {
        let [i, j, k] = triangle;
        let sides = [passage.0[i][j], passage.0[j][k], passage.0[k][i]];
        if sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater) {
            return Some(false);
        }
        // The ray meets the plane in front of the origin if it is on that side of the origin on which the plane is.
        let triangle = triangle.map(|index| corners[index]);
        match C::orientation(triangle[0], triangle[1], triangle[2]) {
            Ordering::Equal => self.is_apart(triangle, sides).then_some(false),
            facing if sides.contains(&facing.reverse()) => Some(false),
            facing => (sides == [facing; 3]).then_some(true),
        }
    }

    /// Whether the ray stays away from a triangle whose plane contains the origin: either it leaves the plane, or there is
    /// no plane, and the triangle lies on a line through the origin in another direction.
    fn is_apart(&self, triangle: [&C; 3], sides: [Ordering; 3]) -> bool {
        if sides.iter().any(|side| side.is_ne()) {
            return true;
        }
        let Some(line) = triangle.into_iter().find(|corner| !corner.is_zero()) else {
            return true;
        };
        triangle.iter().all(|corner| C::are_parallel(line, corner)) && !C::are_parallel(line, &self.direction)
    }
}

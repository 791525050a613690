//! Rays from the origin, and the triangles that they cross (appendix A of the paper).
//!
//! A ray is valid if it meets no triangle at its boundary. Where it is not, the paper casts another
//! random one. Here, the directions are (1, k, k²), k = 0, 1, 2, …, and at least one of the first 49
//! is valid. A ray is rejected because of two corners of one face: it lies in the plane through them
//! and the origin or, if they are on a line through the origin, along that line. The faces have at
//! most 24 such pairs of corners: their edges and their diagonals. No plane through the origin
//! contains more than two of the directions, and no two directions are parallel. So each pair
//! rejects at most two of them.

use core::cmp::Ordering;

use super::corner::Corner;

/// The number of rays.
pub(super) const COUNT: u32 = 2 * 24 + 1;

/// A ray from the origin.
pub(super) struct Ray<C> {
    direction: C,
    is_axis: bool,
}

/// A line through the origin and a patch: the side of the line on which the line through each two
/// corners passes.
pub(super) struct Passage {
    /// For each corner, the corners to its left and to its right, as seen along the line, as sets
    /// of bits.
    left: [u8; 4],
    right: [u8; 4],
}

impl Passage {
    /// The passage of a line; `None` if it misses the hull of the corners.
    ///
    /// The line misses the hull if one corner is the outermost in a sense of rotation about the line:
    /// all others are strictly on one side of it, or in the same direction from the line.
    #[inline]
    pub(super) fn new<C>(
        corners: [&C; 4],
        side: impl Fn(&C, &C) -> Ordering,
        are_aligned: impl Fn(&C, &C) -> bool,
    ) -> Option<Self> {
        let (mut left, mut right, mut aligned) = ([0; 4], [0; 4], [0; 4]);
        for i in 0..3 {
            for j in i + 1..4 {
                let side = side(corners[i], corners[j]);
                let (is_left, is_right) = (u8::from(side.is_gt()), u8::from(side.is_lt()));
                left[i] |= is_left << j;
                right[i] |= is_right << j;
                left[j] |= is_right << i;
                right[j] |= is_left << i;
                if side.is_eq() && are_aligned(corners[i], corners[j]) {
                    aligned[i] |= 1 << j;
                    aligned[j] |= 1 << i;
                }
            }
        }
        let misses = (0..4).fold(false, |misses, i| {
            let others = 0b1111 & !(1 << i);
            misses | (left[i] | aligned[i] == others) | (right[i] | aligned[i] == others)
        });
        (!misses).then_some(Self { left, right })
    }

    /// The passage of an axis.
    #[inline]
    pub(super) fn of_axis<C: Corner>(axis: usize, corners: [&C; 4]) -> Option<Self> {
        Self::new(
            corners,
            |a, b| C::turn(axis, a, b),
            |a, b| C::are_on_one_ray(axis, a, b),
        )
    }

    /// Returns true if two corners are not on one line through the origin, as seen along the line.
    pub(super) fn turns(&self) -> bool {
        self.left != [0; 4]
    }

    /// The side on which the line from one corner to another passes.
    fn side(&self, from: usize, to: usize) -> Ordering {
        let is_in = |set: u8| set >> to & 1;
        is_in(self.left[from]).cmp(&is_in(self.right[from]))
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

    /// Returns true if the ray is the positive x axis.
    pub(super) fn is_axis(&self) -> bool {
        self.is_axis
    }

    /// The passage of the line of the ray by four corners, or `None` if it certainly misses their
    /// hull.
    #[inline]
    pub(super) fn pass(&self, corners: [&C; 4]) -> Option<Passage> {
        if self.is_axis {
            Passage::of_axis(0, corners)
        } else {
            let side = |a: &C, b: &C| C::orientation(&self.direction, a, b);
            Passage::new(corners, side, |_, _| false)
        }
    }

    /// Returns true if the ray crosses a triangle of the four corners that does not contain the
    /// origin; `None` if it may meet the triangle at its boundary.
    pub(super) fn crosses(&self, passage: &Passage, corners: [&C; 4], triangle: [usize; 3]) -> Option<bool> {
        let [i, j, k] = triangle;
        let sides = [passage.side(i, j), passage.side(j, k), passage.side(k, i)];
        if sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater) {
            return Some(false);
        }
        // The ray meets the plane if it leaves the origin towards the side on which the plane is.
        let triangle = triangle.map(|index| corners[index]);
        match C::orientation(triangle[0], triangle[1], triangle[2]) {
            Ordering::Equal => self.is_apart(triangle, sides).then_some(false),
            facing if sides.contains(&facing.reverse()) => Some(false),
            facing => (sides == [facing; 3]).then_some(true),
        }
    }

    /// Returns true if the ray does not meet a triangle whose plane contains the origin: either the
    /// ray leaves the plane, or the triangle lies on a line through the origin in another
    /// direction.
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

//! Vectors of the filters' numbers.

// Without closures: the closures of array methods are not inlined into code for vector instructions.

use core::ops::Mul;

use super::number::{Lanes, Number, Ring};

#[inline(always)]
pub(crate) fn add<T: Ring>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(crate) fn minus<T: Ring>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + b s.
#[inline(always)]
pub(crate) fn towards<T: Number + Mul<S, Output = T>, S: Copy>(a: [T; 3], b: [T; 3], s: S) -> [T; 3] {
    [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s]
}

#[inline(always)]
pub(crate) fn scaled<T: Number + Mul<S, Output = T>, S: Copy>(a: [T; 3], s: S) -> [T; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// One vector in the lanes of a mask, another one elsewhere.
#[inline(always)]
pub(crate) fn select<T: Lanes>(mask: T::Mask, yes: [T; 3], no: [T; 3]) -> [T; 3] {
    [
        T::select(mask, yes[0], no[0]),
        T::select(mask, yes[1], no[1]),
        T::select(mask, yes[2], no[2]),
    ]
}

#[inline(always)]
pub(crate) fn dot<T: Ring>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(crate) fn cross<T: Ring>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [cross_along(0, a, b), cross_along(1, a, b), cross_along(2, a, b)]
}

/// A component of a × b.
#[inline(always)]
pub(crate) fn cross_along<T: Ring>(axis: usize, a: [T; 3], b: [T; 3]) -> T {
    let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
    a[next] * b[last] - a[last] * b[next]
}

/// The sums of the magnitudes of the terms of a × b, given the same sums for a and b.
#[inline(always)]
pub(crate) fn cross_magnitude<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        cross_magnitude_along(0, a, b),
        cross_magnitude_along(1, a, b),
        cross_magnitude_along(2, a, b),
    ]
}

/// A component of [`cross_magnitude`].
#[inline(always)]
pub(crate) fn cross_magnitude_along<T: Number>(axis: usize, a: [T; 3], b: [T; 3]) -> T {
    let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
    a[next] * b[last] + a[last] * b[next]
}

/// The point between two that divides the step at t: (1 − t) a + t b, three roundings one after another.
#[inline(always)]
pub(crate) fn interpolate<T: Lanes>(start: T, end: T, t: T) -> T {
    (-t + 1.0) * start + t * end
}

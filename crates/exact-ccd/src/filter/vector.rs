//! Vectors of the filters' numbers.

// Without closures: those of arrays are not inlined into code for vector instructions.

use super::number::{Lanes, Ring};

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
pub(crate) fn towards<T: Lanes>(a: [T; 3], b: [T; 3], s: T) -> [T; 3] {
    [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s]
}

#[inline(always)]
pub(crate) fn scaled<T: Lanes>(a: [T; 3], s: T) -> [T; 3] {
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
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

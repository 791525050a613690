//! Vectors in space over the numbers of all methods.

use std::ops::{Add, Mul, Sub};

/// A vector of numbers.
pub(crate) type Vector<N> = [N; 3];

#[inline]
pub(crate) fn plus<N: Clone + Add<Output = N>>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|axis: usize| a[axis].clone() + b[axis].clone())
}

#[inline]
pub(crate) fn minus<N: Clone + Sub<Output = N>>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|axis: usize| a[axis].clone() - b[axis].clone())
}

#[inline(always)]
pub(crate) fn dot<N: Clone + Add<Output = N> + Mul<Output = N>>(a: &Vector<N>, b: &Vector<N>) -> N {
    let [x, y, z] = [0, 1, 2].map(|axis: usize| a[axis].clone() * b[axis].clone());
    x + y + z
}

/// The two products whose difference is the component of a × b along an axis.
#[inline(always)]
pub(crate) fn products<N: Clone + Mul<Output = N>>(axis: usize, a: &Vector<N>, b: &Vector<N>) -> [N; 2] {
    let [j, k] = [[1, 2], [2, 0], [0, 1]][axis];
    [a[j].clone() * b[k].clone(), a[k].clone() * b[j].clone()]
}

/// The component of a × b along an axis.
#[inline(always)]
pub(crate) fn turn<N: Clone + Sub<Output = N> + Mul<Output = N>>(
    axis: usize,
    a: &Vector<N>,
    b: &Vector<N>,
) -> N {
    let [forth, back] = products(axis, a, b);
    forth - back
}

#[inline(always)]
pub(crate) fn cross<N: Clone + Sub<Output = N> + Mul<Output = N>>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|axis| turn(axis, a, b))
}

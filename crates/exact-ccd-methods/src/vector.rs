//! Vectors in space over the numbers of all methods.

// Without closures: the closures of array methods are not always inlined.

use crate::ring::Ring;

/// A vector of numbers.
pub(crate) type Vector<N> = [N; 3];

#[inline(always)]
pub(crate) fn plus<N: Ring>([a, b, c]: &Vector<N>, [x, y, z]: &Vector<N>) -> Vector<N> {
    [
        a.clone() + x.clone(),
        b.clone() + y.clone(),
        c.clone() + z.clone(),
    ]
}

#[inline(always)]
pub(crate) fn minus<N: Ring>([a, b, c]: &Vector<N>, [x, y, z]: &Vector<N>) -> Vector<N> {
    [
        a.clone() - x.clone(),
        b.clone() - y.clone(),
        c.clone() - z.clone(),
    ]
}

#[inline(always)]
pub(crate) fn dot<N: Ring>([a, b, c]: &Vector<N>, [x, y, z]: &Vector<N>) -> N {
    a.clone() * x.clone() + b.clone() * y.clone() + c.clone() * z.clone()
}

/// The two products whose difference is the component of a × b along an axis.
#[inline(always)]
pub(crate) fn products<N: Ring>(axis: usize, a: &Vector<N>, b: &Vector<N>) -> [N; 2] {
    let [j, k] = [[1, 2], [2, 0], [0, 1]][axis];
    [a[j].clone() * b[k].clone(), a[k].clone() * b[j].clone()]
}

/// The component of a × b along an axis.
#[inline(always)]
pub(crate) fn turn<N: Ring>(axis: usize, a: &Vector<N>, b: &Vector<N>) -> N {
    let [forth, back] = products(axis, a, b);
    forth - back
}

#[inline(always)]
pub(crate) fn cross<N: Ring>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [turn(0, a, b), turn(1, a, b), turn(2, a, b)]
}

//! Memory for the sums of one element.

/// Calls a function with zeros, which are on the heap only if there are more than `FEW`.
pub(crate) fn with_zeros<const FEW: usize, T>(count: usize, f: impl FnOnce(&mut [f64]) -> T) -> T {
    if count <= FEW {
        f(&mut [0.0; FEW][..count])
    } else {
        f(&mut vec![0.0; count])
    }
}

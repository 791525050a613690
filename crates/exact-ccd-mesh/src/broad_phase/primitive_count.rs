//! The limit on the number of primitives.

/// A mesh has more primitives of one kind than 32-bit indices can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{count} vertices, edges or faces, expected at most 4294967295: split the mesh into parts")]
pub struct TooManyPrimitives {
    /// The number of primitives.
    pub count: usize,
}

/// Checks that all indices below `count` and `count` itself fit into a `u32`.
pub(crate) fn check_primitive_count(count: usize) -> Result<(), TooManyPrimitives> {
    u32::try_from(count).map_or(Err(TooManyPrimitives { count }), |_| Ok(()))
}

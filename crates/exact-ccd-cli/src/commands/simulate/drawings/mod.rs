//! The drawings of `--render`: pictures, animations and plots.

mod painter;
pub(super) mod pictures;
pub(super) mod plots;

//! The size of a system, which does not depend on the axes.

use super::System;
use super::ball::diameter;

impl System {
    /// The diameter of the smallest ball around all bodies with mass at the start, in m: the unit of
    /// relative lengths. It does not depend on the axes. For a box it is the diagonal, and for bodies in a
    /// box along the axes at most its diagonal, the unit of *Incremental Potential Contact*. If it is 0, or
    /// no body has mass, the unit is [`System::extent`].
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The diameter of the smallest ball around everything at the start, obstacles included, in m. 1 m for a
    /// single point.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// The system with its size and its extent. The nodes of affine bodies do not count: their places depend
    /// on the axes.
    pub(super) fn measured(self, is_obstacle: &[bool]) -> Self {
        let vertices = self.mesh_vertices();
        let of = |is_counted: &dyn Fn(u32) -> bool| {
            let counted = vertices.iter().filter(|&&vertex| is_counted(vertex));
            diameter(counted.map(|&vertex| self.start[vertex as usize]))
        };
        let positive = |length: f64, other: f64| if length > 0.0 { length } else { other };
        let extent = positive(of(&|_| true), 1.0);
        let size = positive(of(&|vertex| !is_obstacle[vertex as usize]), extent);
        Self { size, extent, ..self }
    }
}

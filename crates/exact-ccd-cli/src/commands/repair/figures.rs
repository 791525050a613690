//! The change of a mesh by a repair, in numbers.

use std::fmt;

use exact_ccd_repair::Change;
use serde::Serialize;

/// The change of the mesh, in the shape of the JSON object. Displacements are relative to the diagonal of its
/// box.
#[derive(Serialize)]
pub(super) struct Figures {
    pub(super) moved: usize,
    vertices: usize,
    displacement: Displacement,
    stretch: Spread,
    area: Spread,
    /// The pairs of neighbouring faces that are turned over against each other, and were not before.
    folds: usize,
    aspect: Aspect,
}

#[derive(Serialize)]
struct Displacement {
    mean: f64,
    p95: f64,
    max: f64,
}

/// The lengths of edges, or the areas of faces, relative to those before.
#[derive(Serialize)]
struct Spread {
    min: f64,
    p5: f64,
    p95: f64,
    max: f64,
}

/// The worst aspects of a face.
#[derive(Serialize)]
struct Aspect {
    before: f64,
    after: f64,
}

impl Figures {
    pub(super) fn new(change: &Change, vertices: usize) -> Self {
        Self {
            moved: change.moved,
            vertices,
            displacement: Displacement {
                mean: change.mean_displacement,
                p95: change.p95_displacement,
                max: change.max_displacement,
            },
            stretch: Spread {
                min: change.min_stretch,
                p5: change.p5_stretch,
                p95: change.p95_stretch,
                max: change.max_stretch,
            },
            area: Spread {
                min: change.min_area,
                p5: change.p5_area,
                p95: change.p95_area,
                max: change.max_area,
            },
            folds: change.folds,
            aspect: Aspect {
                before: change.worst_aspect_before,
                after: change.worst_aspect,
            },
        }
    }
}

/// Lines of text.
impl fmt::Display for Figures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { moved, vertices, .. } = self;
        let Displacement { mean, p95, max } = &self.displacement;
        writeln!(
            f,
            "moved: {moved} of {vertices} vertices, by {mean:.5} of the diagonal in the mean, {p95:.5} in 95 % of them at \
             most, {max:.5} at most"
        )?;
        writeln!(f, "lengths of edges: {}", self.stretch)?;
        writeln!(f, "areas of faces: {}", self.area)?;
        let Aspect { before, after } = &self.aspect;
        writeln!(
            f,
            "new folds: {}; worst aspect of a face: {after:.2}, {before:.2} before",
            self.folds
        )
    }
}

impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { min, p5, p95, max } = self;
        write!(
            f,
            "{min:.3} to {max:.3} of those before, {p5:.3} to {p95:.3} in 90 % of them"
        )
    }
}

//! The report of a step, and the searches that examine fewer pairs.

mod broad_phases;
mod motions;
mod properties;
mod queries;
mod reports;
mod truth;

use exact_ccd_mesh::{BroadPhase, Motion, Point, StepReport, TriangleMesh};

fn motion(x0: Vec<Point>, x1: Vec<Point>, faces: Vec<[u32; 3]>) -> Motion {
    let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
    Motion { mesh, x0, x1 }
}

fn report(motion: &Motion, broad_phase: &dyn BroadPhase) -> StepReport {
    StepReport::new(motion.step().unwrap(), broad_phase, &|_| ())
}

//! The audit of a recording: 20 bodies of 2,000 faces, close to each other, with 1,000 poses of each.

use exact_ccd::Point;
use exact_ccd::motion::Pose;
use exact_ccd_bench::seconds;
use exact_ccd_mesh::{Bodies, BodiesAudit};

use super::torus;

const FRAMES: u32 = 1000;

/// The tori are 0.8 high.
const DISTANCE: f64 = 0.82;

/// Prints the time of the audit.
pub(super) fn print() {
    let bodies = Bodies::new((0..20).map(|_| torus([40, 25]))).expect("meshes");
    let mut audit = BodiesAudit::new(bodies);
    let mut violation = None;
    let time = seconds(|| {
        for frame in 0..FRAMES {
            let poses: Vec<_> = (0..20).map(|body| pose(body, frame)).collect();
            violation = audit.examine(&poses).expect("a pose of each body");
            if violation.is_some() {
                break;
            }
        }
    });
    println!("\n1,000 poses of 20 bodies of 2,000 faces: {time:.2} s, {violation:?}");
}

/// A torus in a stack: it turns about its axis by about 3° in each frame, the stack by about 0.2° about the
/// x axis. Neighbours are 0.02 from each other, around the whole torus.
fn pose(body: u32, frame: u32) -> Pose {
    let (sin, cos) = (0.5 * (0.05 * f64::from(frame) + f64::from(body))).sin_cos();
    let tilt = 0.003 * f64::from(frame);
    let (s, c) = (0.5 * tilt).sin_cos();
    let height = DISTANCE * f64::from(body);
    let place: Point = [0.0, -tilt.sin() * height, tilt.cos() * height];
    Pose::new([c * cos, s * cos, -s * sin, c * sin], place).expect("a rotation")
}

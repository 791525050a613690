//! The audit of a recording: 20 bodies of 2,000 faces that tumble beside each other, 1,000 poses of each.

use exact_ccd::Point;
use exact_ccd::motion::Pose;
use exact_ccd_bench::seconds;
use exact_ccd_mesh::{Bodies, BodiesAudit};

use super::torus;

const FRAMES: u32 = 1000;

/// The radius of a torus is 1.4: neighbours almost touch.
const DISTANCE: f64 = 2.81;

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

/// A body in a grid, which has turned by about 3° in each frame, about an axis that turns slowly.
fn pose(body: u32, frame: u32) -> Pose {
    let half = 0.5 * (0.05 * f64::from(frame) + f64::from(body));
    let tilt = 0.003 * f64::from(frame) + 2.0 * f64::from(body);
    let axis = [tilt.cos(), tilt.sin() * tilt.cos(), tilt.sin() * tilt.sin()];
    let [x, y, z] = axis.map(|component| half.sin() * component);
    let place: Point = [
        DISTANCE * f64::from(body % 5),
        DISTANCE * f64::from(body / 5),
        0.0,
    ];
    Pose::new([half.cos(), x, y, z], place).expect("a rotation")
}

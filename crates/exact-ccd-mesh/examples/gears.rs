//! Two gears turn against each other, in steps of a twelfth of a turn: free for a whole turn, until one
//! turns a little faster.
//!
//! `cargo run -p exact-ccd-mesh --example gears`
//!
//! The teeth move on arcs, and the answers are exact: a step that is free has no contact at any time.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::f64::consts::TAU;

use exact_ccd::CONTACT;
use exact_ccd::motion::{Chain, Pose, RigidMotion};
use exact_ccd_mesh::{Bodies, Frame, Point};

const TEETH: usize = 12;
const STEPS: usize = 12;

/// A gear about the z axis: a prism over a star.
fn gear(height: f64) -> Result<Frame, Box<dyn Error>> {
    let count = 2 * TEETH;
    let corner = |i: usize, z: f64| {
        let angle = TAU * i as f64 / count as f64;
        let radius = if i.is_multiple_of(2) { 1.25 } else { 1.0 };
        [radius * angle.cos(), radius * angle.sin(), z]
    };
    let rings = [-height, height].into_iter();
    let mut positions: Vec<Point> = rings
        .flat_map(|z| (0..count).map(move |i| corner(i, z)))
        .collect();
    positions.extend([[0.0, 0.0, -height], [0.0, 0.0, height]]);
    let faces = (0..count).flat_map(|i| {
        let j = (i + 1) % count;
        let [a, b, c, d] = [i, j, i + count, j + count].map(|vertex| vertex as u32);
        let center = 2 * count as u32;
        [[a, b, d], [a, d, c], [b, a, center], [c, d, center + 1]]
    });
    Ok(Frame::new(positions, faces.collect())?)
}

/// The pose of a gear that has turned by an angle.
fn pose(angle: f64, center: Point) -> Result<Pose, Box<dyn Error>> {
    let half = 0.5 * angle;
    Ok(Pose::new([half.cos(), 0.0, 0.0, half.sin()], center)?)
}

/// Turns the gears by a whole turn, the second one `ratio` times as fast, until they touch.
fn turn(gears: &Bodies, ratio: f64) -> Result<(), Box<dyn Error>> {
    let motion = |speed: f64, phase: f64, center: Point, step: usize| -> Result<Chain, Box<dyn Error>> {
        let angle = |step: usize| phase + speed * TAU * step as f64 / STEPS as f64;
        let [start, end] = [pose(angle(step), center)?, pose(angle(step + 1), center)?];
        Ok(RigidMotion::between(&start, &end)?.into())
    };
    // A tooth of one between two of the other.
    let phase = 0.5 * TAU * (1.0 + 1.0 / TEETH as f64);
    for step in 0..STEPS {
        let motions = [
            motion(1.0, 0.0, [0.0; 3], step)?,
            motion(-ratio, phase, [2.3, 0.0, 0.0], step)?,
        ];
        if let Some(contact) = gears.collision(&motions, CONTACT)? {
            println!(
                "ratio {ratio}: step {step}, t = {}: {} of gears {:?}, primitives {:?}",
                contact.impact.time.lower(),
                contact.kind.name(),
                contact.bodies,
                contact.primitives
            );
            return Ok(());
        }
    }
    println!("ratio {ratio}: free for a whole turn");
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let gears = Bodies::new([gear(0.25)?, gear(0.5)?])?;
    turn(&gears, 1.0)?;
    turn(&gears, 1.02)
}

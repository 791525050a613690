//! The creep of a block that static friction holds on a slope, and its cost, for several static velocities.
//!
//! `cargo run --release -p exact-ccd-sim --example static_friction`

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;

use exact_ccd_sim::{Friction, Length, Settings, Simulation, System, shapes};

/// The number of time steps in which the block settles, and of measured time steps.
const STEPS: [u32; 2] = [50, 50];

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| static velocity | lags | slope / angle of friction | motion, mm/s | iterations in a time step |"
    );
    println!("|---:|---:|---:|---:|---:|");
    // The last block slides: its motion is no creep.
    for share in [0.5, 0.9, 1.5] {
        for lags in [1, 100] {
            for static_velocity in [1e-3, 1e-4, 1e-5, 1e-6] {
                print_row(share, lags, static_velocity)?;
            }
        }
    }
    Ok(())
}

fn print_row(share: f64, lags: usize, static_velocity: f64) -> Result<(), Box<dyn Error>> {
    let angle = 20.0_f64.to_radians();
    let block =
        shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.4]).placed(|[x, y, z]| [x + 1.0, y + 3e-4, z + 0.3]);
    let system = System::new(&[block, shapes::floor([1, 1], [6.0, 1.1])], &[])?;
    let settings = Settings {
        gravity: [9.81 * angle.sin(), -9.81 * angle.cos(), 0.0],
        friction: Friction {
            coefficient: angle.tan() / share,
            static_velocity: Length::Relative(static_velocity),
            lags,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings)?;
    for _ in 0..STEPS[0] {
        simulation.step()?;
    }
    let start = mean(&simulation);
    let mut iterations = 0;
    for _ in 0..STEPS[1] {
        iterations += simulation.step()?.iterations;
    }
    let seconds = f64::from(STEPS[1]) * simulation.settings().time_step;
    println!(
        "| {static_velocity:e} | {lags} | {share} | {:.4} | {:.1} |",
        1e3 * (mean(&simulation) - start) / seconds,
        iterations as f64 / f64::from(STEPS[1])
    );
    Ok(())
}

/// The mean position of the vertices of the block, down the slope.
fn mean(simulation: &Simulation) -> f64 {
    let masses = simulation.system().masses();
    let positions = simulation.state().positions.iter().zip(masses);
    positions.map(|(x, mass)| x[0] * mass).sum::<f64>() / masses.iter().sum::<f64>()
}

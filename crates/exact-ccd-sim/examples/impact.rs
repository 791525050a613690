//! The energy of a cube after impacts on a floor, for the integrators, several stiffnesses and time steps.
//!
//! `cargo run --release -p exact-ccd-sim --example impact`

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;

use exact_ccd_sim::{BodyKind, Integrator, Settings, Simulation, System, shapes};

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| integrator | E, Pa | time step, s | start, J | end, J | greatest gain, J | time steps with contact |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for (integrator, name) in [
        (Integrator::ImplicitEuler, "implicit Euler"),
        (Integrator::Bdf2, "BDF2"),
    ] {
        for young in [1e5, 1e6, 1e7, 1e8] {
            for time_step in [0.02, 0.01, 0.005, 0.0025] {
                let [start, end, gain, touching] = bounce(integrator, young, time_step)?;
                println!(
                    "| {name} | {young:e} | {time_step} | {start:.2} | {end:.2} | {gain:.4} | {touching} |"
                );
            }
        }
    }
    Ok(())
}

/// The mechanical energy of a cube of 0.2 m before it falls by 0.5 m and after one second, relative to a
/// cube at rest on the floor, the largest increase above an earlier energy, in J, and the number of time
/// steps that end in contact.
fn bounce(integrator: Integrator, young: f64, time_step: f64) -> Result<[f64; 4], Box<dyn Error>> {
    let mut cube = shapes::solid_box([1, 1, 1], [0.2; 3]).placed(|[x, y, z]| [x, y + 0.5, z]);
    if let BodyKind::Solid { material, .. } = &mut cube.kind {
        material.young = young;
    }
    let floor = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 1.4, y, z - 1.4]);
    let system = System::new(&[cube, floor], &[])?;
    let settings = Settings {
        integrator,
        time_step,
        ..Settings::default()
    };
    let weight = 9.81 * system.masses().iter().sum::<f64>();
    let start = weight * 0.5;
    let mut simulation = Simulation::new(system, settings)?;
    let (mut least, mut gain, mut end, mut touching) = (start, 0.0_f64, start, 0.0);
    for _ in 0..(1.0 / time_step).round() as u32 {
        let statistics = simulation.step()?;
        end = statistics.energies.mechanical() - weight * 0.1;
        gain = gain.max(end - least);
        least = least.min(end);
        touching += f64::from(u8::from(statistics.contacts > 0));
    }
    Ok([start, end, gain, touching])
}

//! The cost of Newton iterations: of a cloth of 289 vertices that hangs at two corners, of two such cloths
//! on a sphere, and of a beam of tetrahedra with 1,125 vertices that hangs at one end.
//!
//! Instructions do not depend on other load on the machine. All are in `minimise` and its callees:
//!
//! ```sh
//! CARGO_PROFILE_RELEASE_DEBUG=1 cargo build --release -p exact-ccd-sim --example newton
//! RAYON_NUM_THREADS=1 valgrind --tool=callgrind target/release/examples/newton cloth
//! callgrind_annotate --inclusive=yes callgrind.out.*
//! ```

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;

use exact_ccd_sim::{
    Friction, Integrator, Length, Script, ScriptedVertices, Settings, Simulation, System, shapes,
};

/// The time steps.
const STEPS: usize = 10;

fn main() -> Result<(), Box<dyn Error>> {
    let cloth = || shapes::cloth([16, 16], [1.0, 1.0]);
    let fixed = |vertices: Vec<u32>| -> Vec<ScriptedVertices> { vec![Script::Fixed.on(vertices)] };
    let (bodies, scripts, coefficient) = match std::env::args().nth(1).as_deref() {
        Some("cloth") => (vec![cloth()], fixed(vec![0, 16]), 0.0),
        Some("drape") => {
            let above = |height: f64| cloth().placed(move |[x, y, z]| [x - 0.5, y + height, z - 0.5]);
            let bodies = vec![above(0.302), above(0.305), shapes::sphere(3, 0.3)];
            (bodies, Vec::new(), 0.2)
        }
        Some("beam") => {
            let beam = shapes::solid_box([44, 4, 4], [1.1, 0.1, 0.1]);
            // The first of the 45 vertices of each row along x.
            (vec![beam], fixed((0..25).map(|row| 45 * row).collect()), 0.0)
        }
        _ => return Err("usage: newton cloth|drape|beam".into()),
    };
    let system = System::new(&bodies, &scripts)?;
    let settings = Settings {
        time_step: 0.02,
        integrator: Integrator::Bdf2,
        contact_distance: Length::Absolute(2e-3),
        friction: Friction {
            coefficient,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings)?;
    for _ in 0..STEPS {
        let statistics = simulation.step()?;
        println!(
            "step {}: {} iterations, {} contacts, {:.9e} J",
            statistics.step,
            statistics.iterations,
            statistics.contacts,
            statistics.energies.mechanical()
        );
    }
    Ok(())
}

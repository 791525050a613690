//! A cube falls onto a floor that a script lifts: bodies from code, and a callback for each increment.
//!
//! Run with `cargo run --release -p exact-ccd-sim --example drop`.

#![expect(clippy::print_stdout, reason = "the example prints its results")]

use std::error::Error;

use exact_ccd_sim::{BodyKind, Friction, Length, Script, Settings, Simulation, System, shapes};

fn main() -> Result<(), Box<dyn Error>> {
    let mut cube = shapes::solid_box([3, 3, 3], [0.3; 3]).placed(|[x, y, z]| [x + 0.35, y + 0.05, z + 0.35]);
    cube.velocity = [0.0, -1.0, 0.0];
    if let BodyKind::Solid { material, .. } = &mut cube.kind {
        material.young = 2e5;
    }
    let bodies = [cube, shapes::floor([1, 1], [1.0, 1.0])];

    // A system has the vertices of its bodies, one body after the other.
    let [cube, floor] = &System::ranges(&bodies)[..] else {
        return Err("there are two bodies".into());
    };
    let lift = Script::Moving {
        velocity: [0.0, 0.2, 0.0],
        until: Some(0.1),
    };
    let system = System::new(&bodies, &[lift.on(floor.clone())])?;
    let settings = Settings {
        contact_distance: Length::Absolute(1e-3),
        friction: Friction {
            coefficient: 0.3,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings)?;
    for _ in 0..20 {
        // Between two successive positions, all vertices move in straight lines without contact.
        let mut increments = 0;
        let statistics = simulation.step_along(&mut |_positions| increments += 1)?;
        let lowest = simulation.state().positions[cube.start as usize];
        println!(
            "{:.2} s: height of the first corner {:.4} m, {increments} increments, {} contacts, {:.3} J",
            statistics.time,
            lowest[1],
            statistics.contacts,
            statistics.energies.mechanical()
        );
    }
    Ok(())
}

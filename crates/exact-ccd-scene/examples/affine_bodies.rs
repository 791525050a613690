//! Scenes of affine bodies: a chain that swings, and a heap of convex pieces between walls.
//!
//! `cargo run --release -p exact-ccd-scene --example affine_bodies -- [chain|heap BODIES STEPS]`
//! prints a row for the scene, or for several sizes of both. All increments are audited. With `--scene` in
//! place of the number of steps, it prints the scene file.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use exact_ccd_mesh::Audit;
use exact_ccd_scene::Scene;
use exact_ccd_sim::StepFilter;

/// The scenes with the numbers of bodies and time steps.
const SCENES: [(&str, usize, usize); 6] = [
    ("chain", 10, 50),
    ("chain", 30, 50),
    ("chain", 100, 50),
    ("heap", 20, 50),
    ("heap", 100, 50),
    ("heap", 500, 50),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let scenes = match &arguments[..] {
        [name, bodies, steps] if steps == "--scene" => {
            print!("{}", scene(name, bodies.parse()?)?);
            return Ok(());
        }
        [name, bodies, steps] => vec![(name.as_str(), bodies.parse()?, steps.parse()?)],
        _ => SCENES.to_vec(),
    };
    println!(
        "| scene | bodies | vertices | time steps | iterations a step | contacts at the end | least distance, m | s a step | solve | ccd | unconverged | audit |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|");
    for (name, bodies, steps) in scenes {
        run(name, bodies, steps)?;
    }
    Ok(())
}

fn scene(name: &str, bodies: usize) -> Result<String, Box<dyn Error>> {
    match name {
        "chain" => chain(bodies),
        "heap" => heap(bodies),
        _ => Err(format!("found the scene `{name}`, expected `chain` or `heap`").into()),
    }
}

/// A chain of rings, straight, at 40° to the vertical. Its first link is held.
fn chain(links: usize) -> Result<String, Box<dyn Error>> {
    const RADIUS: f64 = 0.04;
    const TUBE: f64 = 0.008;
    const GAP: f64 = 0.003;
    let degrees = 40.0_f64;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let mut text = "duration = 2.0

[settings]
time-step = 0.01
contact-distance = { absolute = 1e-3 }
tolerance = { absolute = 5e-3 }
"
    .to_owned();
    for link in 0..links {
        let along = (2.0 * (RADIUS - TUBE) - GAP) * link as f64;
        let rotation = if link % 2 == 0 {
            "{ axis = [1.0, 0.0, 0.0], degrees = 90.0 }".to_owned()
        } else {
            format!("{{ axis = [0.0, 0.0, 1.0], degrees = {} }}", degrees - 90.0)
        };
        write!(
            text,
            "
[[body]]
name = \"link-{link}\"
shape = {{ torus = {{ segments = [12, 6], radius = {RADIUS}, tube = {TUBE} }} }}
affine = {{ density = 7800.0, stiffness = 1e8 }}
rotate = {rotation}
translate = [{}, {}, 0.0]
",
            sin * along,
            -cos * along
        )?;
        if link == 0 {
            text += "\n[[body.script]]\nmotion = \"fixed\"\n";
        }
    }
    Ok(text)
}

/// Icosahedra of three shapes in a lattice that is five pieces wide, which fall between four walls.
fn heap(pieces: usize) -> Result<String, Box<dyn Error>> {
    const ACROSS: usize = 5;
    const PITCH: f64 = 0.12;
    let width = PITCH * ACROSS as f64;
    let mut text = "duration = 1.0

[settings]
time-step = 0.01
contact-distance = { absolute = 1e-3 }
tolerance = { absolute = 5e-3 }

[settings.friction]
coefficient = 0.3
"
    .to_owned();
    for (point, normal) in [
        ([0.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([width, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        ([0.0, 0.0, width], [0.0, 0.0, -1.0]),
    ] {
        write!(text, "\n[[half-space]]\npoint = {point:?}\nnormal = {normal:?}\n")?;
    }
    for piece in 0..pieces {
        let place = [piece % ACROSS, piece / (ACROSS * ACROSS), piece / ACROSS % ACROSS];
        let center = place.map(|place| PITCH * (place as f64 + 0.5));
        // The golden angle and multiples of it turn each piece in another way.
        let turn = 137.507_764 * piece as f64 % 360.0;
        let scale = [[1.0, 1.0, 1.0], [0.6, 1.0, 0.8], [1.1, 0.5, 0.5]][piece % 3];
        let (sin, cos) = turn.to_radians().sin_cos();
        write!(
            text,
            "
[[body]]
name = \"piece-{piece}\"
shape = {{ sphere = {{ subdivisions = 0, radius = 0.05 }} }}
affine = {{ density = 1000.0, stiffness = 1e8 }}
scale = {scale:?}
rotate = {{ axis = [{cos}, 0.5, {sin}], degrees = {turn} }}
translate = {center:?}
",
        )?;
    }
    Ok(text)
}

fn run(name: &str, bodies: usize, steps: usize) -> Result<(), Box<dyn Error>> {
    let text = scene(name, bodies)?;
    let exact = |_: &mut exact_ccd_sim::Settings, _: &exact_ccd_sim::System| Ok(StepFilter::default());
    let scene = Scene::parse(&text, Path::new("scene.toml"), None, &exact)?;
    let mut simulation = scene.simulation;
    let mut audit = Audit::default();
    let mut is_free = audit
        .examine(simulation.system().surface_frame(&simulation.state().positions)?)?
        .is_none();
    let (mut iterations, mut unconverged, mut contacts, mut least) = (0, 0, 0, f64::INFINITY);
    let (mut seconds, mut solve, mut ccd) = (0.0, 0.0, 0.0);
    for _ in 0..steps {
        let mut increments = Vec::new();
        let clock = Instant::now();
        let statistics = simulation.step_along(&mut |positions| increments.push(positions.to_vec()))?;
        seconds += clock.elapsed().as_secs_f64();
        solve += statistics.seconds.solve;
        ccd += statistics.seconds.ccd;
        iterations += statistics.iterations;
        unconverged += usize::from(!statistics.converged);
        contacts = statistics.contacts;
        least = statistics
            .minimal_distance
            .map_or(least, |distance| least.min(distance));
        for positions in increments {
            is_free &= audit
                .examine(simulation.system().surface_frame(&positions)?)?
                .is_none();
        }
    }
    let count = steps as f64;
    println!(
        "| {name} | {bodies} | {} | {steps} | {:.1} | {contacts} | {least:.1e} | {:.3} | {:.3} | {:.3} | {unconverged} | {} |",
        simulation.system().surface().vertex_count() - 4 * bodies,
        iterations as f64 / count,
        seconds / count,
        solve / count,
        ccd / count,
        if is_free { "free" } else { "contact" },
    );
    Ok(())
}

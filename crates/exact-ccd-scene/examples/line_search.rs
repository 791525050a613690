//! The line searches `common` and `vertex` side by side, on scenes of the folder `examples/scenes`.
//!
//! `cargo run --release -p exact-ccd-scene --example line_search -- MESHES [SCENE STEPS]`
//!
//! MESHES is the folder of the mesh files. Both simulations take their time steps in turns. The increments
//! of both are audited: every pair of primitives, and every half space.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use exact_ccd_mesh::{Audit, MinDistance, Point};
use exact_ccd_scene::Scene;
use exact_ccd_sim::{LineSearch, Settings, Simulation, Statistics, StepFilter, System};

use exact_ccd::Thickness;

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The scenes with the numbers of their time steps.
const SCENES: [(&str, u64); 5] = [
    ("octocats", 6),
    ("mat-twist", 60),
    ("cloth-on-sphere", 50),
    ("cloth-knot-particles", 60),
    ("pressed-balloon", 75),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let meshes = arguments.next().map(PathBuf::from);
    let chosen = match (arguments.next(), arguments.next()) {
        (Some(name), Some(steps)) => vec![(name, steps.parse()?)],
        _ => SCENES.map(|(name, steps)| (name.to_owned(), steps)).to_vec(),
    };
    println!(
        "| scene, time steps | line search | iterations | time | least step | mean step | elastic, J | sum, J | unconverged | audit |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|---|");
    for (name, steps) in chosen {
        compare(&name, steps, meshes.as_deref())?;
    }
    Ok(())
}

fn compare(name: &str, steps: u64, meshes: Option<&Path>) -> Result<(), Box<dyn Error>> {
    let path = Path::new(REPOSITORY).join(format!("examples/scenes/{name}.toml"));
    let mut runs = Vec::new();
    for (text, line_search) in [("common", LineSearch::Common), ("vertex", LineSearch::Vertex)] {
        let with_line_search = |settings: &mut Settings, _: &System| {
            settings.line_search = line_search;
            Ok(StepFilter::default())
        };
        let scene = Scene::read(&path, meshes, &with_line_search)?;
        runs.push(Run::new(text, scene.simulation)?);
    }
    for _ in 0..steps {
        runs.iter_mut().try_for_each(Run::step)?;
    }
    let seconds = runs[0].sum(|statistics| statistics.seconds.total);
    for run in &runs {
        run.print(&format!("{name}, {steps}"), seconds);
    }
    Ok(())
}

/// A simulation with its audit.
struct Run {
    name: &'static str,
    simulation: Simulation,
    audit: Audit,
    statistics: Vec<Statistics>,
    violation: Option<String>,
}

impl Run {
    fn new(name: &'static str, simulation: Simulation) -> Result<Self, Box<dyn Error>> {
        let system = simulation.system();
        let thickness = Thickness::new(&system.surface_offsets())?;
        let mut audit = Audit::default().with_min_distance(MinDistance::thickness(thickness));
        let violation = audit.examine(system.surface_frame(system.start())?)?;
        Ok(Self {
            name,
            audit,
            statistics: Vec::new(),
            violation: violation.map(|violation| format!("{violation:?}")),
            simulation,
        })
    }

    fn step(&mut self) -> Result<(), Box<dyn Error>> {
        let path = Mutex::new(Vec::new());
        let statistics = self.simulation.step_along(&mut |positions| {
            path.lock().expect("no holder panics").push(positions.to_vec());
        })?;
        self.statistics.push(statistics);
        for positions in path.into_inner()? {
            self.examine(&positions)?;
        }
        Ok(())
    }

    fn examine(&mut self, positions: &[Point]) -> Result<(), Box<dyn Error>> {
        let system = self.simulation.system();
        let surface = system.surface_frame(positions)?;
        let violation = self.audit.examine_positions(surface.positions)?;
        let violation = violation.map(|violation| format!("{violation:?}"));
        let grounded = system.first_grounded(positions);
        let violation = violation.or(grounded.map(|vertex| format!("{vertex:?}")));
        if self.violation.is_none() {
            self.violation = violation;
        }
        Ok(())
    }

    fn sum(&self, part: impl Fn(&Statistics) -> f64) -> f64 {
        self.statistics.iter().map(part).sum()
    }

    /// Prints a row of the table. Times are relative to `seconds`.
    fn print(&self, scene: &str, seconds: f64) {
        let iterations: usize = self.statistics.iter().map(|step| step.iterations).sum();
        let unconverged = self.statistics.iter().filter(|step| !step.converged).count();
        let sizes = || self.statistics.iter().flat_map(|step| &step.step_sizes);
        let taken = sizes().filter(|&&size| size > 0.0);
        let least = taken.fold(1.0_f64, |least, &size| least.min(size));
        let mean = sizes().sum::<f64>() / sizes().count() as f64;
        let energies = self
            .statistics
            .last()
            .map(|step| step.energies)
            .unwrap_or_default();
        println!(
            "| {scene} | {} | {iterations} | {:.2} | {least:.1e} | {mean:.3} | {:.5} | {:.5} | {unconverged} | {} |",
            self.name,
            self.sum(|step| step.seconds.total) / seconds,
            energies.elastic,
            energies.mechanical(),
            self.violation.as_deref().unwrap_or("free"),
        );
    }
}

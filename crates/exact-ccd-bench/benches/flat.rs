//! Steps of flat worlds, where things are flat, parallel and in touch, on one thread.
//!
//! `cargo bench -p exact-ccd-bench --bench flat [-- FOLDER]`
//!
//! A time is the median of some rounds, in milliseconds. The second table has, for a sample of the
//! candidates, the share of each stage in % and the mean time of a decision there, in nanoseconds. The scenes
//! are generated. With a folder, they are only written there, as frames for `bench/peers/step`.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::fs::{self, File};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Kind, Query, Stage, VertexFace};
use exact_ccd_bench::{median, seconds};
use exact_ccd_files::write_ply;
use exact_ccd_mesh::{Bvh, Candidates, Detector, Frame, Step, StepReport, TriangleMesh};
use rayon::ThreadPoolBuilder;

use exact_ccd_testing::meshes::flat::{Scene, scenes};
use exact_ccd_testing::meshes::general::general_scenes;

const ROUNDS: usize = 5;
const SAMPLE: usize = 20_000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    if let Some(folder) = folder {
        for scene in scenes(1).iter().chain(&general_scenes(1)) {
            write(Path::new(&folder), scene)?;
        }
        return Ok(());
    }
    ThreadPoolBuilder::new().num_threads(1).build_global()?;
    let scenes: Vec<(Scene, TriangleMesh)> = scenes(1)
        .into_iter()
        .chain(general_scenes(1))
        .map(|scene| {
            let mesh = TriangleMesh::new(scene.ends[0].len(), scene.faces.clone());
            (scene, mesh.expect("the faces have vertices"))
        })
        .collect();
    println!(
        "| scene | candidates | contacts | all contacts | ns a candidate | with places | earliest contact |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    scenes.iter().for_each(|(scene, mesh)| print_times(scene, mesh));
    let stages: Vec<String> = Stage::ALL.iter().map(|stage| format!("{stage:?}")).collect();
    println!("\n| scene | {} |", stages.join(" | "));
    println!("|---|{}", "---:|".repeat(stages.len()));
    scenes.iter().for_each(|(scene, mesh)| print_stages(scene, mesh));
    Ok(())
}

fn write(folder: &Path, scene: &Scene) -> Result<(), Box<dyn std::error::Error>> {
    let folder = folder
        .join(scene.name.replace(", ", " ").replace(' ', "-"))
        .join("frames");
    fs::create_dir_all(&folder)?;
    for (end, positions) in scene.ends.iter().enumerate() {
        let mesh = TriangleMesh::new(positions.len(), scene.faces.clone())?;
        let frame = Frame {
            mesh,
            positions: positions.clone(),
        };
        write_ply(File::create(folder.join(format!("{end}.ply")))?, &frame)?;
    }
    Ok(())
}

fn print_times(scene: &Scene, mesh: &TriangleMesh) {
    let [x0, x1] = &scene.ends;
    let step = Step::new(mesh, x0, x1).expect("all positions are finite");
    let report = StepReport::new(step, &Bvh, &|_| ());
    let all = milliseconds(|| StepReport::new(step, &Bvh, &|_| ()));
    let places = milliseconds(|| Candidates::new(step, &Bvh).collisions(step, CONTACT));
    let mut detector = Detector::new(mesh.clone());
    let earliest = milliseconds(|| detector.collision(x0, x1, CONTACT));
    let candidates = report.candidates.total();
    println!(
        "| {} | {candidates} | {} | {all:.1} | {:.0} | {places:.1} | {earliest:.1} |",
        scene.name,
        report.colliding.total(),
        1e6 * all / candidates as f64
    );
}

/// The median time of a task.
fn milliseconds<T>(mut task: impl FnMut() -> T) -> f64 {
    1e3 * median(&[(); ROUNDS].map(|()| seconds(&mut task)))
}

/// The count and the seconds of each stage.
type Settled = [(usize, f64); Stage::ALL.len()];

fn print_stages(scene: &Scene, mesh: &TriangleMesh) {
    let [x0, x1] = &scene.ends;
    let step = Step::new(mesh, x0, x1).expect("all positions are finite");
    let candidates = Candidates::new(step, &Bvh);
    let stride = candidates.counts().total() / SAMPLE + 1;
    let mut settled = Settled::default();
    for &pair in candidates.of_kind(AnyKind::VertexFace).iter().step_by(stride) {
        decide(step.query::<VertexFace>(pair), &mut settled);
    }
    for &pair in candidates.of_kind(AnyKind::EdgeEdge).iter().step_by(stride) {
        decide(step.query::<EdgeEdge>(pair), &mut settled);
    }
    let all: usize = settled.iter().map(|(count, _)| count).sum();
    let cells = settled.map(|(count, seconds)| match count {
        0 => String::new(),
        _ => format!(
            "{:.2} % {:.0} ns",
            100.0 * count as f64 / all as f64,
            1e9 * seconds / count as f64
        ),
    });
    println!("| {} | {} |", scene.name, cells.join(" | "));
}

fn decide<K: Kind>(query: Option<Query<K>>, settled: &mut Settled) {
    let query = query.expect("a candidate is a pair of the mesh");
    let clock = Instant::now();
    let (_, stage) = black_box(&query).decide(CONTACT);
    let time = clock.elapsed().as_secs_f64();
    let (count, sum) = &mut settled[stage as usize];
    *count += 1;
    *sum += time;
}

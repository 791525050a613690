//! The cost of one question on one mesh.

use std::env;
use std::error::Error;
use std::process::{Command, Stdio};

use exact_ccd_bench::{median, seconds};
use exact_ccd_mesh::{Bvh, Detector, StepReport};
use serde::{Deserialize, Serialize};

use crate::memory::Memory;
use crate::question::Question;
use exact_ccd_bench::cloth::Cloth;

/// The number of repetitions. The median time counts, and the peak memory of the first run.
const ROUNDS: usize = 3;

/// Meshes with so many triangles take long enough to be measured once.
const MANY: usize = 500_000;

/// The argument with which this program runs a single measurement, in a separate process.
pub(crate) const MEASURE: &str = "--measure";

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Measurement {
    pub(crate) triangles: usize,
    /// Vertices, edges and faces.
    pub(crate) primitives: usize,
    pub(crate) candidates: usize,
    pub(crate) colliding: usize,
    pub(crate) seconds: f64,
    /// The peak memory minus the memory before the step, in bytes.
    pub(crate) memory: Option<u64>,
}

impl Measurement {
    /// Measures in this process.
    pub(crate) fn here(question: Question, side: usize) -> Self {
        let cloth = Cloth::new(side, question.nearest());
        let step = cloth.step();
        let mesh = step.mesh();
        let detector = Detector::new(mesh.clone());
        let memory = Memory::now();
        let rounds = if mesh.faces().len() < MANY { ROUNDS } else { 1 };
        let mut times = vec![0.0; rounds];
        let mut rise = None;
        for time in &mut times {
            *time = seconds(|| question.answer(step, detector.clone()));
            rise = rise.or_else(|| memory.rise());
        }
        let report = StepReport::new(step, &Bvh, &|_| ());
        assert_eq!(
            report.is_free(),
            question == Question::Free,
            "the cloth is made so"
        );
        Self {
            triangles: mesh.faces().len(),
            primitives: mesh.vertex_count() + mesh.edges().len() + mesh.faces().len(),
            candidates: report.candidates.total(),
            colliding: report.colliding.total(),
            seconds: median(&times),
            memory: rise,
        }
    }

    /// Measures in a separate process, so that no other question contributes to the peak memory.
    pub(crate) fn apart(question: Question, side: usize) -> Result<Self, Box<dyn Error>> {
        let output = Command::new(env::current_exe()?)
            .args([MEASURE, question.word(), &side.to_string()])
            .stderr(Stdio::inherit())
            .output()?;
        if !output.status.success() {
            return Err(format!("measuring {}: {}", question.title(), output.status).into());
        }
        Ok(serde_json::from_slice(&output.stdout)?)
    }
}

//! Repair of a mesh that intersects itself.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use exact_ccd::Separation;
use exact_ccd_mesh::{Intersection, Pair};
use exact_ccd_repair::repair_recording as recording;
use exact_ccd_repair::{Change, Outcome, Phase, Progress, Reason, RepairError, RepairOptions};
use exact_ccd_repair::{Repaired, Unrepaired, repair as repaired, repair_in_f32};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::compute::{Watch, compute};
use crate::contacts::{PairColumns, PairRow, pair_columns};
use crate::error::refused;
use crate::mesh::{Mesh, Table, rows};
use crate::positions::Positions;

/// The minimum distance, the most rounds of a phase, the seconds after which the repair is stopped, and the
/// number of threads.
type Settings = (f64, usize, Option<f64>, Option<usize>);

/// The positions, the numbers of crossings and contacts before, the name of the reason and the sentence, the
/// crossings and contacts that remain, and the change.
type Columns<'py> = (
    Table<'py, f64>,
    Option<(usize, usize)>,
    Option<(&'static str, String)>,
    Table<'py, u32>,
    PairColumns<'py>,
    Option<Numbers>,
);

/// Positions of one world, near the given ones, in which the mesh is free; with `single`, their coordinates
/// are float32, except for pinned vertices. `stop` is called before each round, and ends the repair if its
/// answer is true.
#[pyfunction]
pub(crate) fn repair<'py>(
    py: Python<'py>,
    mesh: &Mesh,
    positions: Positions<'py>,
    pinned: PyReadonlyArray1<'py, u32>,
    single: bool,
    settings: Settings,
    stop: Option<Py<PyAny>>,
) -> PyResult<Columns<'py>> {
    let world = positions.rows();
    let outcome = with_options(py, mesh, &pinned, settings, stop, |options| {
        let run = if single { repair_in_f32 } else { repaired };
        run(mesh.mesh(), &world.row(0), options)
    })?;
    match outcome {
        Outcome::Repaired(Repaired {
            positions,
            crossings,
            contacts,
            change,
            ..
        }) => Ok((
            rows(py, positions)?,
            Some((crossings, contacts)),
            None,
            edges_and_faces(py, &[])?,
            remaining(py, mesh, &[])?,
            Some(change.into()),
        )),
        Outcome::Unrepaired(Unrepaired {
            positions,
            crossings,
            contacts,
            reason,
            ..
        }) => Ok((
            rows(py, positions)?,
            None,
            Some((name(reason), reason.to_string())),
            edges_and_faces(py, &crossings)?,
            remaining(py, mesh, &contacts)?,
            None,
        )),
    }
}

/// The positions of all repaired frames, one after the other, the change of each, and the frame that is
/// blocked, with its crossings and contacts.
type Frames<'py> = (
    Table<'py, f64>,
    Vec<Numbers>,
    Option<(usize, Table<'py, u32>, PairColumns<'py>)>,
);

/// Positions near the given ones of each world, in which the mesh is free, as is the straight motion from
/// each to the next one. `stop` is called before each round and each frame.
#[pyfunction]
pub(crate) fn repair_recording<'py>(
    py: Python<'py>,
    mesh: &Mesh,
    positions: Positions<'py>,
    pinned: PyReadonlyArray1<'py, u32>,
    settings: Settings,
    stop: Option<Py<PyAny>>,
) -> PyResult<Frames<'py>> {
    let worlds = positions.rows();
    let recording = with_options(py, mesh, &pinned, settings, stop, |options| {
        let frames: Vec<_> = (0..worlds.count())
            .map(|frame| worlds.row(frame).to_vec())
            .collect();
        recording(mesh.mesh(), &frames, options)
    })?;
    let blocked = recording.blocked.map(|blocked| {
        let crossings = edges_and_faces(py, &blocked.crossings)?;
        PyResult::Ok((blocked.frame, crossings, remaining(py, mesh, &blocked.contacts)?))
    });
    Ok((
        rows(py, recording.frames.into_iter().flatten())?,
        recording.changes.into_iter().map(Numbers::from).collect(),
        blocked.transpose()?,
    ))
}

/// Runs a repair with the options of its caller, whose `stop` is asked, as are the seconds and Ctrl-C.
fn with_options<T: Send>(
    py: Python<'_>,
    mesh: &Mesh,
    pinned: &PyReadonlyArray1<'_, u32>,
    (min_distance, max_rounds, seconds, threads): Settings,
    stop: Option<Py<PyAny>>,
    run: impl FnOnce(&RepairOptions<'_>) -> Result<T, RepairError> + Send,
) -> PyResult<T> {
    let min_distance =
        Separation::new(min_distance).map_err(|error| refused(format_args!("min_distance: {error}")))?;
    if let Some(seconds) = seconds.filter(|seconds| seconds.is_nan() || *seconds < 0.0) {
        return Err(refused(format_args!(
            "seconds is {seconds}, expected a number of at least 0"
        )));
    }
    let watch = Arc::<Watch>::default();
    let failure = Arc::<Mutex<Option<PyErr>>>::default();
    let asked = |progress| -> PyResult<bool> {
        let Some(stop) = &stop else { return Ok(false) };
        Python::attach(|py| stop.call1(py, fields(progress))?.is_truthy(py))
    };
    let began = Instant::now();
    let ends = |progress| {
        let is_late = seconds.is_some_and(|seconds| began.elapsed().as_secs_f64() >= seconds);
        if is_late || watch.is_cancelled() {
            return true;
        }
        asked(progress).unwrap_or_else(|error| {
            let mut first = failure.lock().unwrap_or_else(PoisonError::into_inner);
            first.get_or_insert(error);
            true
        })
    };
    let options = RepairOptions::default()
        .with_min_distance(min_distance)
        .with_pinned(pinned.as_slice()?.to_vec())
        .with_can_collide(mesh.ruled(mesh.shared_rule(py), &watch, &failure))
        .with_max_rounds(max_rounds)
        .with_stop(&ends);
    let outcome = compute(py, threads, None, &watch, || run(&options));
    let failure = failure.lock().unwrap_or_else(PoisonError::into_inner).take();
    failure.map_or(outcome, Err)?.map_err(refused)
}

/// The phase of a repair, its round, and the number of pairs.
fn fields(progress: Progress) -> (&'static str, usize, usize) {
    let phase = match progress.phase {
        Phase::Loosen => "loosen",
        Phase::Separate => "separate",
        Phase::Return => "return",
        Phase::Follow => "follow",
    };
    (phase, progress.round, progress.pairs)
}

fn name(reason: Reason) -> &'static str {
    match reason {
        Reason::Pinned => "pinned",
        Reason::OneSided { .. } => "one-sided",
        Reason::Linked { .. } => "linked",
        Reason::Stalled => "stalled",
        Reason::Rounds(_) => "rounds",
        Reason::Rounding => "rounding",
        Reason::Stopped(_) => "stopped",
        _ => "other",
    }
}

fn edges_and_faces<'py>(py: Python<'py>, crossings: &[Intersection]) -> PyResult<Table<'py, u32>> {
    rows(py, crossings.iter().map(|pair| [pair.edge, pair.face]))
}

fn remaining<'py>(py: Python<'py>, mesh: &Mesh, contacts: &[Pair]) -> PyResult<PairColumns<'py>> {
    let contacts: Vec<_> = contacts
        .iter()
        .map(|&pair| PairRow::new(mesh.mesh(), pair))
        .collect();
    pair_columns(py, contacts.iter())
}

/// A [`Change`] as a dictionary.
#[derive(IntoPyObject)]
pub(crate) struct Numbers {
    moved: usize,
    mean_displacement: f64,
    p95_displacement: f64,
    max_displacement: f64,
    min_stretch: f64,
    p5_stretch: f64,
    p95_stretch: f64,
    max_stretch: f64,
    min_area: f64,
    p5_area: f64,
    p95_area: f64,
    max_area: f64,
    folds: usize,
    worst_aspect_before: f64,
    worst_aspect: f64,
}

impl From<Change> for Numbers {
    fn from(change: Change) -> Self {
        Self {
            moved: change.moved,
            mean_displacement: change.mean_displacement,
            p95_displacement: change.p95_displacement,
            max_displacement: change.max_displacement,
            min_stretch: change.min_stretch,
            p5_stretch: change.p5_stretch,
            p95_stretch: change.p95_stretch,
            max_stretch: change.max_stretch,
            min_area: change.min_area,
            p5_area: change.p5_area,
            p95_area: change.p95_area,
            max_area: change.max_area,
            folds: change.folds,
            worst_aspect_before: change.worst_aspect_before,
            worst_aspect: change.worst_aspect,
        }
    }
}

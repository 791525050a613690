//! Contact of rigid bodies.

use std::sync::{Arc, Mutex, MutexGuard, TryLockError};

use exact_ccd::motion::{Chain, Pose};
use exact_ccd::{Options, Separation};
use exact_ccd_mesh::{Bodies as Search, BodiesError, BodyContact, Frame, GroupMatrix};
use numpy::{PyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::compute::{Watch, compute};
use crate::detector::by_kind;
use crate::error::refused;
use crate::mesh::{List, Mesh, Table, rows};
use crate::positions::points;

/// The poses of all bodies: the place, and the quaternion, scalar first.
type Poses<'py> = PyReadonlyArray2<'py, f64>;

/// The kinds of the contacts, the bodies, the primitives, and the impacts: time, u, v and the normal.
type Columns<'py> = (List<'py, u8>, Table<'py, i64>, Table<'py, u32>, Table<'py, f64>);

/// The numbers of pairs, by their kinds.
type Counts = [i64; 4];

/// Finds contact between rigid bodies, for one call at a time.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct Bodies {
    bodies: Search,
    separation: Separation,
    /// The search asks it for each pair of bodies.
    watch: Arc<Watch>,
    work: Mutex<()>,
    threads: Option<usize>,
}

impl Bodies {
    fn begin(&self) -> PyResult<MutexGuard<'_, ()>> {
        match self.work.try_lock() {
            Ok(guard) => Ok(guard),
            // A panic ends its own call only.
            Err(TryLockError::Poisoned(error)) => Ok(error.into_inner()),
            Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(
                "the bodies are at work for another thread: make others for each",
            )),
        }
    }

    /// The result of `work` with the poses at both ends.
    fn search<T: Send>(
        &self,
        py: Python<'_>,
        ends: [&Poses<'_>; 2],
        work: impl FnOnce(&Search, [&[Pose]; 2]) -> Result<T, BodiesError> + Send,
    ) -> PyResult<T> {
        let _guard = self.begin()?;
        let [start, end] = [poses("poses0", ends[0])?, poses("poses1", ends[1])?];
        self.watch.reset();
        compute(py, self.threads, None, &self.watch, || {
            work(&self.bodies, [&start, &end])
        })?
        .map_err(refused)
    }

    /// The result of `work` with the motions between the poses.
    fn between<T: Send>(
        &self,
        py: Python<'_>,
        ends: [&Poses<'_>; 2],
        until: f64,
        work: impl FnOnce(&Search, &[Chain], Options) -> Result<T, BodiesError> + Send,
    ) -> PyResult<T> {
        let options = Options::within(self.separation).until(until);
        self.search(py, ends, |bodies, [start, end]| {
            work(bodies, &bodies.motions(start, end)?, options)
        })
    }
}

#[pymethods]
impl Bodies {
    /// Each body is a mesh with its positions. The matrix says which pairs of bodies can collide.
    #[new]
    fn new(
        py: Python<'_>,
        meshes: Vec<(PyRef<'_, Mesh>, PyReadonlyArray2<'_, f64>)>,
        matrix: Option<PyReadonlyArray2<'_, bool>>,
        min_distance: f64,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let separation =
            Separation::new(min_distance).map_err(|error| refused(format_args!("min_distance: {error}")))?;
        let matrix = match matrix {
            Some(matrix) => Some(
                GroupMatrix::new(matrix.shape()[0], matrix.as_slice()?.to_vec())
                    .map_err(|error| refused(format_args!("can_collide: {error}")))?,
            ),
            None => None,
        };
        let frames = meshes.iter().map(|(mesh, positions)| {
            Ok(Frame {
                mesh: mesh.mesh().as_ref().clone(),
                positions: points(positions)?.to_vec(),
            })
        });
        let frames: Vec<Frame> = frames.collect::<PyResult<_>>()?;
        let watch = Arc::<Watch>::default();
        let ended = watch.clone();
        let bodies = py.detach(|| Search::new(frames)).map_err(refused)?;
        let bodies = bodies.with_can_collide(move |a, b| {
            let is_allowed = |matrix: &GroupMatrix| matrix.allows(a as u32, b as u32);
            !ended.is_cancelled() && matrix.as_ref().is_none_or(is_allowed)
        });
        Ok(Self {
            bodies,
            separation,
            watch,
            work: Mutex::default(),
            threads,
        })
    }

    /// Contact or none.
    fn collides(&self, py: Python<'_>, poses0: Poses<'_>, poses1: Poses<'_>, until: f64) -> PyResult<bool> {
        self.between(py, [&poses0, &poses1], until, Search::collides)
    }

    /// The earliest contact, at most one row.
    fn collision<'py>(
        &self,
        py: Python<'py>,
        poses0: Poses<'py>,
        poses1: Poses<'py>,
        until: f64,
    ) -> PyResult<Columns<'py>> {
        let contact = self.between(py, [&poses0, &poses1], until, Search::collision)?;
        columns(py, contact.as_slice())
    }

    /// All contacts.
    fn collisions<'py>(
        &self,
        py: Python<'py>,
        poses0: Poses<'py>,
        poses1: Poses<'py>,
        until: f64,
    ) -> PyResult<Columns<'py>> {
        let contacts = self.between(py, [&poses0, &poses1], until, Search::collisions)?;
        columns(py, &contacts)
    }

    /// The numbers of colliding and of touching pairs, and the earliest contact.
    fn step<'py>(
        &self,
        py: Python<'py>,
        poses0: Poses<'py>,
        poses1: Poses<'py>,
    ) -> PyResult<([Counts; 2], Columns<'py>)> {
        let options = Options::within(self.separation);
        let report = self.search(py, [&poses0, &poses1], |bodies, [start, end]| {
            bodies.step(start, end, options)
        })?;
        let counts = [report.colliding, report.touching].map(by_kind);
        Ok((counts, columns(py, report.earliest.as_slice())?))
    }

    /// The pairs of bodies within the cut-off, the bounds of their distances, and a point of each body.
    fn distances<'py>(
        &self,
        py: Python<'py>,
        poses: Poses<'py>,
        cut_off: f64,
    ) -> PyResult<(Table<'py, i64>, Table<'py, f64>, Table<'py, f64>)> {
        let cut_off = Separation::new(cut_off).map_err(|error| refused(format_args!("cut_off: {error}")))?;
        let found = self.search(py, [&poses, &poses], |bodies, [poses, _]| {
            bodies.distances(poses, cut_off)
        })?;
        let found = || found.iter();
        Ok((
            rows(py, found().map(|one| one.bodies.map(|body| body as i64)))?,
            rows(py, found().map(|one| [one.bounds.lower, one.bounds.upper]))?,
            rows(py, found().flat_map(|one| one.points))?,
        ))
    }

    /// The size and the poses of a certified step, and the earliest contact of the full one.
    fn free_step<'py>(
        &self,
        py: Python<'py>,
        poses0: Poses<'py>,
        poses1: Poses<'py>,
        keep: f64,
    ) -> PyResult<(f64, Table<'py, f64>, Columns<'py>)> {
        let options = Options::within(self.separation);
        let free = self.search(py, [&poses0, &poses1], |bodies, [start, end]| {
            bodies.free_step(start, end, keep, options)
        })?;
        let row = |pose: &Pose| {
            let ([x, y, z], [w, a, b, c]) = (pose.place(), pose.rotation());
            [x, y, z, w, a, b, c]
        };
        Ok((
            free.size,
            rows(py, free.poses.iter().map(row))?,
            columns(py, free.contact.as_slice())?,
        ))
    }
}

/// The poses in the rows of an array.
fn poses(name: &str, array: &Poses<'_>) -> PyResult<Vec<Pose>> {
    let rows = array.as_slice()?.as_chunks::<7>().0.iter();
    let pose = |(body, &[x, y, z, w, a, b, c]): (usize, &[f64; 7])| {
        if let Some(axis) = [x, y, z].iter().position(|coordinate| !coordinate.is_finite()) {
            return Err(refused(format_args!(
                "{name}: body {body}: coordinate {axis} of the place is not finite"
            )));
        }
        Pose::new([w, a, b, c], [x, y, z])
            .map_err(|error| refused(format_args!("{name}: body {body}: {error}")))
    };
    rows.enumerate().map(pose).collect()
}

fn columns<'py>(py: Python<'py>, contacts: &[BodyContact]) -> PyResult<Columns<'py>> {
    let impact = |contact: &BodyContact| {
        let [u, v] = contact.impact.parameters;
        let [x, y, z] = contact.impact.normal.unwrap_or([f64::NAN; 3]);
        [contact.impact.time.lower(), u, v, x, y, z]
    };
    let bodies = |contact: &BodyContact| contact.bodies.map(|body| body as i64);
    Ok((
        PyArray1::from_iter(py, contacts.iter().map(|contact| contact.kind as u8)),
        rows(py, contacts.iter().map(bodies))?,
        rows(py, contacts.iter().map(|contact| contact.primitives))?,
        rows(py, contacts.iter().map(impact))?,
    ))
}

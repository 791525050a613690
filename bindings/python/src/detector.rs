//! Contact in successive steps of a mesh.

use std::array::from_fn;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};

use exact_ccd::{AnyKind, Point, Separation};
use exact_ccd_mesh::{Meeting, PairCounts, Precision, TriangleMesh, Worlds};
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use pyo3::{PyTraverseError, PyVisit};
use rayon::prelude::*;

use crate::compute::{Watch, compute};
use crate::contacts::{Columns, PairColumns, PairRow, Row, into_columns, pair_columns};
use crate::distance::Distance;
use crate::error::{Refusal, refused, room};
use crate::mesh::{List, Mesh, Table, rows};
use crate::page::Page;
use crate::positions::Positions;
use crate::search::{Rules, Search};

/// Finds contact in steps of many worlds, which have one mesh and positions of their own; for one call at a
/// time.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct Detector {
    mesh: Arc<TriangleMesh>,
    /// A search that has not begun.
    new: Search,
    /// The searches: at work, the detector is locked.
    worlds: Mutex<Worlds<Search>>,
    /// The reference of the detector to the rule of its mesh, which its searches share.
    rule: Option<Arc<Py<PyAny>>>,
    failure: Arc<Mutex<Option<PyErr>>>,
    watch: Arc<Watch>,
    threads: Option<usize>,
}

impl Detector {
    /// The searches, unless the detector works for another call.
    fn begin(&self) -> PyResult<MutexGuard<'_, Worlds<Search>>> {
        match self.worlds.try_lock() {
            Ok(worlds) => Ok(worlds),
            // A panic ends its own call only.
            Err(TryLockError::Poisoned(error)) => Ok(error.into_inner()),
            Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(
                "the detector is at work, for another thread or for the call whose rule or progress this is: \
                 make a detector for each",
            )),
        }
    }

    /// The results of `work` for the positions of each world; the exception of the rule, if there is one, or
    /// of the first world.
    fn each<T: Send>(
        &self,
        py: Python<'_>,
        x0: &Positions<'_>,
        x1: &Positions<'_>,
        progress: Option<&Py<PyAny>>,
        work: impl Fn(&mut Search, &[Point], &[Point]) -> Result<T, Refusal> + Sync,
    ) -> PyResult<Vec<T>> {
        let mut worlds = self.begin()?;
        let [x0, x1] = Positions::ends(x0, x1)?;
        let count = x0.count();
        let mut results = room(count)?;
        results.resize_with(count, || None);
        self.watch.reset();
        let outcome = compute(py, self.threads, progress, &self.watch, || {
            let worlds = &*worlds;
            results.par_iter_mut().enumerate().for_each(|(world, result)| {
                if !self.watch.is_cancelled() {
                    let work = |search: &mut Search| work(search, &x0.row(world), &x1.row(world));
                    *result = Some(worlds.search(&self.new, work));
                }
            });
        });
        if self.watch.is_cancelled() {
            // A search that ended early may have recorded a start that it has not checked.
            *worlds = Worlds::default();
        }
        let failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner).take();
        failure.map_or(outcome, Err)?;
        let named = |world| (count > 1).then_some(world);
        let results = results.into_iter().enumerate();
        results
            .map(|(world, result)| match result {
                Some(result) => result.map_err(|refusal| refusal.into_exception(py, named(world))),
                None => Err(PyKeyboardInterrupt::new_err(())),
            })
            .collect()
    }
}

#[pymethods]
impl Detector {
    /// The distance is one for all pairs, or a thickness for each vertex; the inner one is for pairs
    /// that start within it. With `start_check`, no edge may pass through a face at the start of a step.
    #[new]
    fn new(
        py: Python<'_>,
        mesh: &Mesh,
        min_distance: Distance<'_>,
        inner_distance: Option<f64>,
        threads: Option<usize>,
        start_check: bool,
    ) -> PyResult<Self> {
        let min_distance = min_distance.with_inner(inner_distance)?;
        let watch = Arc::<Watch>::default();
        let failure = Arc::default();
        let rule = mesh.shared_rule(py);
        let rules = Rules {
            groups: mesh.by_groups(),
            every: mesh.ruled(rule.clone(), &watch, &failure),
            has_rule: rule.is_some(),
        };
        let new = Search::new(mesh.mesh(), rules, min_distance, watch.clone(), start_check);
        Ok(Self {
            mesh: mesh.mesh().clone(),
            new: new.map_err(refused)?,
            worlds: Mutex::default(),
            rule,
            failure,
            watch,
            threads,
        })
    }

    /// As of a [`Mesh`].
    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(self.rule.as_deref())
    }

    /// Contact or none.
    fn collides<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        until: f64,
    ) -> PyResult<List<'py, bool>> {
        let collides = self.each(py, &x0, &x1, None, |search, x0, x1| {
            search.collides(x0, x1, until)
        })?;
        Ok(PyArray1::from_vec(py, collides))
    }

    /// The earliest contact: one row or none for each world.
    fn collision<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        until: f64,
    ) -> PyResult<Columns<'py>> {
        let contacts = self.each(py, &x0, &x1, None, |search, x0, x1| {
            let contact = search.collision(x0, x1, until)?;
            Ok(contact.map(|contact| Row::new(&self.mesh, [x0, x1], &contact)))
        })?;
        into_columns(py, &contacts)
    }

    /// All contacts.
    fn collisions<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        until: f64,
    ) -> PyResult<Columns<'py>> {
        let contacts = self.each(py, &x0, &x1, None, |search, x0, x1| {
            let contacts = search.collisions(x0, x1, until)?;
            let row = |contact| Row::new(&self.mesh, [x0, x1], contact);
            Ok(contacts.iter().map(row).collect::<Vec<_>>())
        })?;
        into_columns(py, &contacts)
    }

    /// The size and the positions of a certified step, the earliest contact of the full one, and the
    /// numbers of pairs that touch at the start.
    #[expect(clippy::type_complexity, reason = "the arrays are named in Python")]
    fn free_step<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        keep: f64,
        is_single: bool,
    ) -> PyResult<(
        List<'py, f64>,
        Bound<'py, PyArray3<f64>>,
        Columns<'py>,
        Table<'py, i64>,
    )> {
        let steps = self.each(py, &x0, &x1, None, |search, x0, x1| {
            let free = search.free_step(x0, x1, keep, precision(is_single))?;
            let row = free
                .contact
                .map(|contact| Row::new(&self.mesh, [x0, x1], &contact));
            Ok((free, row))
        })?;
        let (steps, contacts): (Vec<_>, Vec<_>) = steps.into_iter().unzip();
        let shape = [steps.len(), self.mesh.vertex_count(), 3];
        let positions: Vec<f64> = match &steps[..] {
            [one] => one.positions.as_flattened().to_vec(),
            all => all
                .iter()
                .flat_map(|step| step.positions.as_flattened())
                .copied()
                .collect(),
        };
        Ok((
            PyArray1::from_iter(py, steps.iter().map(|step| step.size)),
            PyArray1::from_vec(py, positions).reshape(shape)?,
            into_columns(py, &contacts)?,
            rows(py, steps.iter().map(|step| by_kind(step.touching)))?,
        ))
    }

    /// The sizes and the positions of the steps of all vertices of one world, the number of rounds, and the
    /// blocked pairs.
    fn free_steps<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        keep: f64,
        is_single: bool,
        pinned: PyReadonlyArray1<'py, u32>,
    ) -> PyResult<(List<'py, f64>, Table<'py, f64>, usize, PairColumns<'py>)> {
        let pinned = pinned.as_slice()?;
        let steps = self.each(py, &x0, &x1, None, |search, x0, x1| {
            search.free_steps(x0, x1, keep, precision(is_single), pinned)
        })?;
        let steps = steps.iter();
        let blocked = steps.clone().flat_map(|taken| &taken.blocked);
        let blocked: Vec<_> = blocked.map(|&pair| PairRow::new(&self.mesh, pair)).collect();
        Ok((
            PyArray1::from_iter(py, steps.clone().flat_map(|taken| taken.sizes.iter().copied())),
            rows(
                py,
                steps.clone().flat_map(|taken| taken.positions.iter().copied()),
            )?,
            steps.map(|taken| taken.rounds).sum(),
            pair_columns(py, blocked.iter())?,
        ))
    }

    /// The clearances of all vertices of one world.
    fn clearances<'py>(&self, py: Python<'py>, x: Positions<'py>, cut_off: f64) -> PyResult<List<'py, f64>> {
        let cut_off = Separation::new(cut_off).map_err(|error| refused(format_args!("cut_off: {error}")))?;
        let clearances = self.each(py, &x, &x, None, |search, x, _| search.clearances(x, cut_off))?;
        Ok(PyArray1::from_vec(py, clearances.concat()))
    }

    /// The numbers of candidates, of colliding pairs and of touching ones, and the earliest contact.
    fn step<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<([Table<'py, i64>; 3], Columns<'py>)> {
        let reports = self.each(py, &x0, &x1, progress.as_ref(), |search, x0, x1| {
            let report = search.step(x0, x1)?;
            let row = report
                .earliest
                .map(|contact| Row::new(&self.mesh, [x0, x1], &contact));
            Ok(([report.candidates, report.colliding, report.touching], row))
        })?;
        let (counts, contacts): (Vec<_>, Vec<_>) = reports.into_iter().unzip();
        let column = |place: usize| rows(py, counts.iter().map(|counts| by_kind(counts[place])));
        Ok(([column(0)?, column(1)?, column(2)?], into_columns(py, &contacts)?))
    }

    /// The proof of the answer to a step of one world: a certificate, or a part that continues one.
    fn certificate<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        at_rest: bool,
        is_continued: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let certificates = self.each(py, &x0, &x1, None, |search, x0, x1| {
            search.certificate(x0, x1, at_rest, is_continued)
        })?;
        Ok(PyBytes::new(py, &certificates.concat()))
    }

    /// Any edge and face that meet at rest, of one world.
    fn has_intersections(&self, py: Python<'_>, x: Positions<'_>) -> PyResult<bool> {
        let found = self.each(py, &x, &x, None, |search, x, _| search.has_intersections(x))?;
        Ok(found.contains(&true))
    }

    /// The edges and faces of one world that meet at rest: all that touch, or only the edges that pass
    /// through faces.
    fn intersections<'py>(
        &self,
        py: Python<'py>,
        x: Positions<'py>,
        crossing: bool,
    ) -> PyResult<Table<'py, u32>> {
        let meeting = if crossing {
            Meeting::Crossing
        } else {
            Meeting::Touching
        };
        let found = self.each(py, &x, &x, None, |search, x, _| search.intersections(x, meeting))?;
        rows(py, found.iter().flatten().map(|pair| [pair.edge, pair.face]))
    }

    /// Adds the edges that pass through faces in the last frame to a page.
    fn show_intersections(
        &self,
        py: Python<'_>,
        mut page: PyRefMut<'_, Page>,
        x: Positions<'_>,
    ) -> PyResult<()> {
        let found = self.each(py, &x, &x, None, |search, x, _| {
            search.intersections(x, Meeting::Crossing)
        })?;
        page.add_intersections(&found.concat())
    }

    /// Adds the contacts between the last two frames to a page: all of them, or the earliest.
    fn show_contacts(
        &self,
        py: Python<'_>,
        mut page: PyRefMut<'_, Page>,
        x0: Positions<'_>,
        x1: Positions<'_>,
        all: bool,
    ) -> PyResult<()> {
        let contacts = self.each(py, &x0, &x1, None, |search, x0, x1| {
            if all {
                search.collisions(x0, x1, 1.0)
            } else {
                Ok(search.collision(x0, x1, 1.0)?.into_iter().collect())
            }
        })?;
        page.add_contacts(&contacts.concat())
    }
}

pub(crate) fn by_kind(counts: PairCounts) -> [i64; AnyKind::ALL.len()] {
    from_fn(|number| counts[AnyKind::ALL[number]] as i64)
}

/// The precision of positions.
fn precision(is_single: bool) -> Precision {
    if is_single {
        Precision::Single
    } else {
        Precision::Double
    }
}

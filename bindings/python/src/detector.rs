//! Contact in successive steps of a mesh.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};

use exact_ccd::{Options, Point, Separation, Thickness};
use exact_ccd_mesh::{
    CanCollide, CandidateOptions, Contact, FreeStepOptions, Intersection, IntersectionOptions, Meeting,
    MinDistance, Pair, PairCounts, Step, StepError, StepReport, TriangleMesh, intersections,
};
use numpy::{PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::broad_phase::Interruptible;
use crate::compute::{Watch, compute};
use crate::contacts::{Columns, Table};
use crate::error::{refused, refused_search, refused_step};
use crate::mesh::{Mesh, rows};
use crate::page::Page;
use crate::pool;

type Inner = exact_ccd_mesh::Detector<Interruptible>;
type Positions<'py> = PyReadonlyArray2<'py, f64>;

/// Finds contact in successive steps of one mesh, for one call at a time.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct Detector(Mutex<Work>);

impl Detector {
    /// The detector, unless it works for another call.
    fn begin(&self) -> PyResult<MutexGuard<'_, Work>> {
        match self.0.try_lock() {
            Ok(work) => Ok(work),
            // A panic ends its own call only.
            Err(TryLockError::Poisoned(error)) => Ok(error.into_inner()),
            Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(
                "the detector is at work, for another thread or for the call whose rule or progress this is: \
                 make a detector for each",
            )),
        }
    }
}

/// The detectors of a mesh.
///
/// A rule of the caller is a function in Python, too slow for every candidate. Hence the first search
/// ignores it, and its answer stands if it has no contact or if the rule holds for the contact.
struct Work {
    mesh: Arc<TriangleMesh>,
    /// Ignores the rule.
    open: Inner,
    /// Obeys it, if there is one.
    ruled: Option<Inner>,
    groups: CanCollide,
    rule: CanCollide,
    min_distance: MinDistance,
    failure: Arc<Mutex<Option<PyErr>>>,
    watch: Arc<Watch>,
    threads: Option<usize>,
    /// True if the start of each step is checked. Without a rule, `open` does so, and knows the ends of free
    /// steps.
    checks_start: bool,
    /// The bits of the last start that was checked here.
    checked: Vec<[u64; 3]>,
}

impl Work {
    /// The result of `work`; the exception of the rule, if there is one.
    fn compute<T: Send>(
        &mut self,
        py: Python<'_>,
        progress: Option<&Py<PyAny>>,
        work: impl FnOnce(&mut Self) -> T + Send,
    ) -> PyResult<T> {
        let (watch, threads) = (self.watch.clone(), self.threads);
        watch.reset();
        let result = compute(py, threads, progress, &watch, || work(self));
        if watch.is_cancelled() {
            self.forget_checks();
        }
        let failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner).take();
        failure.map_or(result, Err)
    }

    /// The columns of contacts of a step.
    fn table(&self, x0: &[Point], x1: &[Point], contacts: &[Contact]) -> PyResult<Table> {
        let step = Step::new(&self.mesh, x0, x1).map_err(refused)?;
        Ok(Table::new(&step, contacts))
    }

    /// Makes certain that no edge passes through a face at the start of a step, if that is to be checked. The
    /// rule is asked for the edges and faces that were found.
    fn check_start(&mut self, x0: &[Point]) -> PyResult<()> {
        let bits: Vec<_> = x0.iter().map(|point| point.map(f64::to_bits)).collect();
        if !self.checks_start || bits == self.checked {
            return Ok(());
        }
        let (mesh, watch) = (&self.mesh, self.watch.clone());
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let options = options.with_can_collide(self.groups.clone());
        let found = intersections(mesh, x0, &Interruptible { watch }, &options);
        for Intersection { edge, face } in found.map_err(|error| refused_step(error.into()))? {
            let (ends, corners) = (mesh.edges()[edge as usize], mesh.faces()[face as usize]);
            if self.rule.allows(&ends, &corners) {
                return Err(refused_step(StepError::Crossing {
                    edge,
                    ends,
                    face,
                    corners,
                }));
            }
        }
        self.checked = bits;
        Ok(())
    }

    /// The same for a search, in which the detector without a rule makes the check.
    fn check_start_of_search(&mut self, x0: &[Point]) -> PyResult<()> {
        if self.ruled.is_some() {
            self.check_start(x0)
        } else {
            Ok(())
        }
    }

    /// Forgets the positions that were checked, in a computation that may not have come to its end.
    fn forget_checks(&mut self) {
        self.checked = Vec::new();
        if self.open.start_passes() > 0 {
            self.open.set_start_check(false);
            self.open.set_start_check(true);
        }
    }

    /// The minimum distance, and the whole step.
    fn options(&self) -> Options<MinDistance> {
        Options::within(self.min_distance.clone())
    }

    /// The earliest contact of a step.
    fn earliest(&mut self, x0: &[Point], x1: &[Point]) -> PyResult<Option<Contact>> {
        self.check_start_of_search(x0)?;
        let options = self.options();
        let run = |inner: &mut Inner| inner.collision(x0, x1, options.clone()).map_err(refused_step);
        self.search(run, |contact| *contact)
    }

    /// All contacts of a step until a time.
    fn contacts(&mut self, x0: &[Point], x1: &[Point], until: f64) -> PyResult<Vec<Contact>> {
        self.check_start_of_search(x0)?;
        let options = self.options().until(until);
        let mut contacts = self.open.collisions(x0, x1, options).map_err(refused_step)?;
        if self.ruled.is_some() {
            contacts.retain(|contact| allows(&self.rule, &self.mesh, contact.pair));
        }
        Ok(contacts)
    }

    /// The edges and faces that meet at rest.
    fn intersections(&self, x: &[Point]) -> PyResult<Vec<Intersection>> {
        let (mesh, watch) = (&self.mesh, self.watch.clone());
        let broad_phase = Interruptible { watch };
        let mut found =
            intersections(mesh, x, &broad_phase, &IntersectionOptions::default()).map_err(refused)?;
        found.retain(|pair| {
            let (edge, face) = (mesh.edges()[pair.edge as usize], mesh.faces()[pair.face as usize]);
            !self.watch.is_cancelled() && self.rule.allows(&edge, &face)
        });
        Ok(found)
    }

    /// The result of a search, first without the rule.
    fn search<T>(
        &mut self,
        run: impl Fn(&mut Inner) -> PyResult<T>,
        contact: impl Fn(&T) -> Option<Contact>,
    ) -> PyResult<T> {
        let result = run(&mut self.open)?;
        match (&mut self.ruled, contact(&result)) {
            (Some(ruled), Some(contact)) if !allows(&self.rule, &self.mesh, contact.pair) => run(ruled),
            _ => Ok(result),
        }
    }
}

/// Returns true if the rule holds for a pair.
fn allows(rule: &CanCollide, mesh: &TriangleMesh, pair: Pair) -> bool {
    let first = match pair {
        Pair::EdgeEdge { .. } => 2,
        Pair::VertexFace { .. } | Pair::VertexEdge { .. } | Pair::VertexVertex { .. } => 1,
    };
    pair.vertices(mesh).is_some_and(|vertices| {
        let (a, b) = vertices.split_at(first);
        rule.allows(a, b)
    })
}

/// A thickness for each vertex, or one distance for all pairs.
#[derive(FromPyObject)]
enum Distance<'py> {
    Thickness(PyReadonlyArray1<'py, f64>),
    Uniform(f64),
}

impl Distance<'_> {
    fn with_inner(&self, inner: Option<f64>) -> PyResult<MinDistance> {
        let outer = match self {
            Self::Thickness(values) => {
                MinDistance::thickness(Thickness::new(values.as_slice()?).map_err(refused)?)
            }
            Self::Uniform(d) => MinDistance::uniform(Separation::new(*d).map_err(refused)?),
        };
        let inner = inner.map(Separation::new).transpose().map_err(refused)?;
        Ok(match inner {
            Some(inner) => outer.with_inner(inner),
            None => outer,
        })
    }
}

#[pymethods]
impl Detector {
    /// The distance is one for all pairs, or a thickness for each vertex; the inner one is for pairs
    /// that start within it. With `start_check`, no edge may pass through a face at the start of a step.
    #[new]
    fn new(
        mesh: &Mesh,
        min_distance: Distance<'_>,
        inner_distance: Option<f64>,
        threads: Option<usize>,
        start_check: bool,
    ) -> PyResult<Self> {
        pool::check(threads)?;
        let min_distance = min_distance.with_inner(inner_distance)?;
        let watch = Arc::<Watch>::default();
        let failure = Arc::default();
        let rule = mesh.rule(&watch, &failure);
        min_distance.check(mesh.mesh()).map_err(refused)?;
        let detector = |can_collide| {
            let broad_phase = Interruptible { watch: watch.clone() };
            Inner::with_broad_phase(mesh.mesh().clone(), broad_phase).with_can_collide(can_collide)
        };
        Ok(Self(Mutex::new(Work {
            mesh: mesh.mesh().clone(),
            open: detector(mesh.groups()).with_start_check(start_check && !mesh.has_rule()),
            ruled: mesh.has_rule().then(|| detector(rule.clone())),
            min_distance,
            groups: mesh.groups(),
            rule,
            failure,
            watch,
            threads,
            checks_start: start_check,
            checked: Vec::new(),
        })))
    }

    /// The earliest contact: one row or none.
    fn earliest_contact<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
    ) -> PyResult<Columns<'py>> {
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        let table = self.begin()?.compute(py, None, |detector| {
            let contact = detector.earliest(x0, x1)?;
            detector.table(x0, x1, contact.as_slice())
        })??;
        table.into_arrays(py)
    }

    /// Free of contact.
    fn is_free(&self, py: Python<'_>, x0: Positions<'_>, x1: Positions<'_>) -> PyResult<bool> {
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        self.begin()?.compute(py, None, |detector| {
            let options = detector.options();
            let collides = if detector.ruled.is_none() {
                detector.open.collides(x0, x1, options)
            } else {
                detector.check_start(x0)?;
                let (rule, mesh) = (&detector.rule, &detector.mesh);
                let counts = |pair| allows(rule, mesh, pair);
                detector.open.collides_if(x0, x1, options, counts)
            };
            Ok(!collides.map_err(refused_step)?)
        })?
    }

    /// All contacts until a time.
    fn contacts<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        until: f64,
    ) -> PyResult<Columns<'py>> {
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        let table = self.begin()?.compute(py, None, |detector| {
            let contacts = detector.contacts(x0, x1, until)?;
            detector.table(x0, x1, &contacts)
        })??;
        table.into_arrays(py)
    }

    /// The size and the positions of a certified step, the earliest contact of the full one, and the
    /// numbers of pairs that touch at the start.
    #[expect(clippy::type_complexity, reason = "a tuple for Python")]
    fn free_step<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        keep: f64,
    ) -> PyResult<(f64, Bound<'py, PyArray2<f64>>, Columns<'py>, [usize; 4])> {
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        let options = FreeStepOptions::default().with_keep(keep);
        let (free, table) = self.begin()?.compute(py, None, |detector| {
            detector.check_start_of_search(x0)?;
            let options = options.with_min_distance(detector.min_distance.clone());
            let run = |inner: &mut Inner| inner.free_step(x0, x1, &options).map_err(refused_search);
            let mut free = detector.search(run, |free| free.contact)?;
            // The pairs that touch at the start have been counted without the rule.
            if free.touching.total() > 0
                && let Some(ruled) = &mut detector.ruled
            {
                free = run(ruled)?;
            }
            let table = detector.table(x0, x1, free.contact.as_slice())?;
            Ok::<_, PyErr>((free, table))
        })??;
        let positions = rows(py, &free.positions)?;
        Ok((
            free.size,
            positions,
            table.into_arrays(py)?,
            by_kind(free.touching),
        ))
    }

    /// The numbers of candidates, of colliding pairs and of touching ones, and the earliest contact.
    fn step<'py>(
        &self,
        py: Python<'py>,
        x0: Positions<'py>,
        x1: Positions<'py>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<([[usize; 4]; 3], Columns<'py>)> {
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        let (report, table) = self.begin()?.compute(py, progress.as_ref(), |detector| {
            detector.check_start(x0)?;
            let broad_phase = Interruptible {
                watch: detector.watch.clone(),
            };
            let options = CandidateOptions::default().with_can_collide(detector.rule.clone());
            let options = options.with_min_distance(detector.min_distance.clone());
            let progress = |count| detector.watch.add(count);
            let step = Step::new(&detector.mesh, x0, x1).map_err(refused)?;
            let report =
                StepReport::with_options(step, &broad_phase, &options, &progress).map_err(refused)?;
            let table = Table::new(&step, report.earliest.as_slice());
            Ok::<_, PyErr>((report, table))
        })??;
        let counts = [report.candidates, report.colliding, report.touching];
        Ok((counts.map(by_kind), table.into_arrays(py)?))
    }

    /// The edges and faces that meet at rest.
    fn intersections<'py>(&self, py: Python<'py>, x: Positions<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let x = points(&x)?;
        let found = self
            .begin()?
            .compute(py, None, |detector| detector.intersections(x))??;
        let pairs: Vec<[u32; 2]> = found.iter().map(|pair| [pair.edge, pair.face]).collect();
        rows(py, &pairs)
    }

    /// Adds the edges and faces that meet in the last frame to a page.
    fn show_intersections(
        &self,
        py: Python<'_>,
        mut page: PyRefMut<'_, Page>,
        x: Positions<'_>,
    ) -> PyResult<()> {
        let x = points(&x)?;
        let found = self
            .begin()?
            .compute(py, None, |detector| detector.intersections(x))??;
        page.add_intersections(&found)
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
        let (x0, x1) = (points(&x0)?, points(&x1)?);
        let contacts = self.begin()?.compute(py, None, |detector| {
            if all {
                detector.contacts(x0, x1, 1.0)
            } else {
                Ok(detector.earliest(x0, x1)?.into_iter().collect())
            }
        })??;
        page.add_contacts(&contacts)
    }
}

pub(crate) fn points<'a>(positions: &'a Positions<'_>) -> PyResult<&'a [Point]> {
    Ok(positions.as_slice()?.as_chunks().0)
}

fn by_kind(counts: PairCounts) -> [usize; 4] {
    let PairCounts {
        vertex_face,
        edge_edge,
        vertex_edge,
        vertex_vertex,
    } = counts;
    [vertex_face, edge_edge, vertex_edge, vertex_vertex]
}

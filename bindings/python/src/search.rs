//! The search for contact in the steps of one world.

use std::sync::Arc;

use exact_ccd::{Options, Point, Separation};
use exact_ccd_certify::{Maker, MakerError};
use exact_ccd_mesh::{
    CanCollide, CandidateOptions, Contact, Detector, FreeStep, FreeStepOptions, FreeSteps, Intersection,
    IntersectionOptions, Meeting, MinDistance, Pair, Precision, Step, StepError, StepReport, ThicknessCount,
    TriangleMesh, has_intersections, intersections,
};

use crate::broad_phase::Interruptible;
use crate::compute::Watch;
use crate::error::Refusal;

/// The detectors of a mesh.
///
/// A rule of the caller is a function in Python, too slow for every candidate. Hence the first search
/// ignores it, and its answer stands if it has no contact or if the rule holds for the contact.
#[derive(Clone)]
pub(crate) struct Search {
    /// Ignores the rule.
    open: Detector,
    /// Obeys it, if there is one.
    ruled: Option<Detector>,
    rules: Rules,
    min_distance: MinDistance,
    watch: Arc<Watch>,
}

/// The pairs that can collide: by the groups, and by the groups and the rule of the caller.
#[derive(Clone)]
pub(crate) struct Rules {
    pub(crate) groups: CanCollide,
    pub(crate) every: CanCollide,
    /// True if there is a rule of the caller.
    pub(crate) has_rule: bool,
}

impl Rules {
    /// Returns true if a pair can collide.
    fn allow(&self, mesh: &TriangleMesh, pair: Pair) -> bool {
        pair.vertices(mesh).is_some_and(|vertices| {
            let (a, b) = vertices.split_at(pair.kind().sizes()[0]);
            self.every.allows(a, b)
        })
    }

    /// Returns true if an edge and a face that meet can collide.
    fn count(&self, watch: &Watch, mesh: &TriangleMesh, pair: Intersection) -> bool {
        let allows = |(ends, corners): ([u32; 2], [u32; 3])| self.every.allows(&ends, &corners);
        !watch.is_cancelled() && pair.vertices(mesh).is_some_and(allows)
    }
}

impl Search {
    pub(crate) fn new(
        mesh: &Arc<TriangleMesh>,
        rules: Rules,
        min_distance: MinDistance,
        watch: Arc<Watch>,
        checks_start: bool,
    ) -> Result<Self, ThicknessCount> {
        min_distance.check(mesh)?;
        let detector = |can_collide: &CanCollide| {
            let broad_phase = Interruptible { watch: watch.clone() };
            Detector::with_broad_phase(mesh.clone(), Arc::new(broad_phase))
                .with_can_collide(can_collide.clone())
        };
        Ok(Self {
            open: detector(&rules.groups).with_start_check(checks_start),
            ruled: rules.has_rule.then(|| detector(&rules.every)),
            rules,
            min_distance,
            watch,
        })
    }

    fn mesh(&self) -> &Arc<TriangleMesh> {
        self.open.mesh()
    }

    fn broad_phase(&self) -> Interruptible {
        let watch = self.watch.clone();
        Interruptible { watch }
    }

    /// The minimum distance, and the last time that counts.
    fn options(&self, until: f64) -> Options<MinDistance> {
        Options::within(self.min_distance.clone()).until(until)
    }

    /// Makes certain that no edge passes through a face at the start of a step, if that is to be checked. The
    /// rule is asked for the edges and faces that were found.
    fn check_start(&mut self, x0: &[Point]) -> Result<(), StepError> {
        let Self {
            open, rules, watch, ..
        } = self;
        let mesh = open.mesh().clone();
        open.check_start(x0, |pair| rules.count(watch, &mesh, pair))
    }

    /// The result of a search, first without the rule.
    fn search<T, E: From<StepError>>(
        &mut self,
        x0: &[Point],
        run: impl Fn(&mut Detector) -> Result<T, E>,
        contact: impl Fn(&T) -> Option<Contact>,
    ) -> Result<T, E> {
        if self.ruled.is_some() {
            self.check_start(x0)?;
        }
        let result = run(&mut self.open)?;
        match (&mut self.ruled, contact(&result)) {
            (Some(ruled), Some(contact)) if !self.rules.allow(ruled.mesh(), contact.pair) => run(ruled),
            _ => Ok(result),
        }
    }

    /// Contact or none.
    pub(crate) fn collides(&mut self, x0: &[Point], x1: &[Point], until: f64) -> Result<bool, Refusal> {
        let options = self.options(until);
        if self.ruled.is_none() {
            return Ok(self.open.collides(x0, x1, options)?);
        }
        self.check_start(x0)?;
        let (rules, mesh) = (&self.rules, self.mesh().clone());
        let counts = |pair| rules.allow(&mesh, pair);
        Ok(self.open.collides_if(x0, x1, options, counts)?)
    }

    /// The earliest contact of a step.
    pub(crate) fn collision(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        until: f64,
    ) -> Result<Option<Contact>, Refusal> {
        let options = self.options(until);
        let run = |inner: &mut Detector| inner.collision(x0, x1, options.clone()).map_err(Refusal::from);
        self.search(x0, run, |contact| *contact)
    }

    /// All contacts of a step.
    pub(crate) fn collisions(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        until: f64,
    ) -> Result<Vec<Contact>, Refusal> {
        let options = self.options(until);
        let run = |inner: &mut Detector| inner.collisions(x0, x1, options.clone()).map_err(Refusal::from);
        let mut contacts = self.search(x0, run, |_| None)?;
        if self.ruled.is_some() {
            contacts.retain(|contact| self.rules.allow(self.mesh(), contact.pair));
        }
        Ok(contacts)
    }

    fn free_step_options(&self, keep: f64, precision: Precision) -> FreeStepOptions<'static> {
        let options = FreeStepOptions::default()
            .with_keep(keep)
            .with_precision(precision);
        options.with_min_distance(self.min_distance.clone())
    }

    /// A certified step.
    pub(crate) fn free_step(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        keep: f64,
        precision: Precision,
    ) -> Result<FreeStep, Refusal> {
        let options = self.free_step_options(keep, precision);
        let run = |inner: &mut Detector| inner.free_step(x0, x1, &options).map_err(Refusal::from);
        let free = self.search(x0, run, |free| free.contact)?;
        match &mut self.ruled {
            // The pairs that touch at the start have been counted without the rule.
            Some(ruled) if free.touching.total() > 0 => run(ruled),
            _ => Ok(free),
        }
    }

    /// A certified step for each vertex.
    pub(crate) fn free_steps(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        keep: f64,
        precision: Precision,
        pinned: &[u32],
    ) -> Result<FreeSteps, Refusal> {
        let options = self.free_step_options(keep, precision);
        let run = |inner: &mut Detector| inner.free_steps(x0, x1, pinned, &options).map_err(Refusal::from);
        let taken = self.search(x0, run, |_| None)?;
        match &mut self.ruled {
            // A contact of the first round may be one that the rule forbids.
            Some(ruled) if taken.rounds > 1 => run(ruled),
            _ => Ok(taken),
        }
    }

    /// The clearance of each vertex at rest.
    pub(crate) fn clearances(&mut self, x: &[Point], cut_off: Separation) -> Result<Vec<f64>, Refusal> {
        if self.ruled.is_some() {
            self.check_start(x)?;
        }
        let inner = self.ruled.as_mut().unwrap_or(&mut self.open);
        Ok(inner.clearances(x, cut_off)?)
    }

    /// The contacts of a step, counted.
    pub(crate) fn step(&mut self, x0: &[Point], x1: &[Point]) -> Result<StepReport, Refusal> {
        self.check_start(x0)?;
        let options = CandidateOptions::default().with_can_collide(self.rules.every.clone());
        let options = options.with_min_distance(self.min_distance.clone());
        let progress = |count| self.watch.add(count);
        let step = Step::new(self.mesh(), x0, x1)?;
        StepReport::with_options(step, &self.broad_phase(), &options, &progress).map_err(Refusal::new)
    }

    /// The proof of the answer to a step, as a certificate or as a part that continues one. With `rest`, it
    /// says that no edge passes through a face at the start.
    pub(crate) fn certificate(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        rest: bool,
        is_continued: bool,
    ) -> Result<Vec<u8>, Refusal> {
        let distance = Maker::distance(&self.min_distance)?;
        if self.rules.has_rule {
            return Err(MakerError::Rules.into());
        }
        let mut maker = if is_continued {
            Maker::continued(distance)
        } else {
            Maker::new(distance)
        };
        maker.add_step_of(&mut self.open, x0, x1, rest)?;
        Ok(maker.finish()?)
    }

    /// The edges and faces that meet at rest in this way.
    pub(crate) fn intersections(&self, x: &[Point], meeting: Meeting) -> Result<Vec<Intersection>, Refusal> {
        let options = IntersectionOptions::default().with_meeting(meeting);
        let mut found = intersections(self.mesh(), x, &self.broad_phase(), &options).map_err(Refusal::new)?;
        found.retain(|&pair| self.rules.count(&self.watch, self.mesh(), pair));
        Ok(found)
    }

    /// Any edge and face that meet at rest.
    pub(crate) fn has_intersections(&self, x: &[Point]) -> Result<bool, Refusal> {
        let options = IntersectionOptions::default();
        let counts = |pair| self.rules.count(&self.watch, self.mesh(), pair);
        has_intersections(self.mesh(), x, &self.broad_phase(), &options, &counts).map_err(Refusal::new)
    }
}

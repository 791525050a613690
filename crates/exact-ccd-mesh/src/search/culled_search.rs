//! A search that examines few candidates: it leaves out pairs that cannot touch before a contact found.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd::{AnyKind, Point, Separation, with_kind};

use super::candidates::Candidates;
use super::collect::Collect;
use super::kept::Kept;
use super::narrow_phase::{Examiner, NarrowPhase};
use super::screen::Screen;
use crate::at_rest::{Intersection, StartCheck};
use crate::broad_phase::{BoxPairs, BroadPhase};
use crate::overlaps::{self, CandidateOptions, Margin, Primitives, StepBoxes};
use crate::pairs::{CanCollide, MinDistance, Receive, Searched};
use crate::steps::{Step, StepError};
use crate::vector::minus;

/// A search in successive steps of one mesh.
#[derive(Clone)]
pub(crate) struct CulledSearch {
    broad_phase: Arc<dyn BroadPhase>,
    memory: Memory,
}

/// The memory of earlier steps, for one predicate.
#[derive(Clone, Debug)]
struct Memory {
    narrow_phase: NarrowPhase,
    screen: Screen,
    primitives: Primitives,
    resting: StepBoxes<1>,
    moving: StepBoxes<2>,
    /// The candidates of the last search, if they were kept.
    kept: Option<Candidates>,
}

/// One block of primitives in this many is examined first: enough to find an early contact among
/// many.
const SAMPLE_STRIDE: usize = 64;

/// Displacements count as short if their mean is below the first multiple of the mean edge length, and the
/// longest one below the second multiple. The box around a short path is hardly larger than a box that moves
/// along it, and its tests are cheaper.
const SHORT_DISPLACEMENTS: [f64; 2] = [0.25, 1.0];

/// Boxes, and the screen, are placed anew if the time until which contacts matter has shrunk to this
/// fraction.
const SHRUNK_TIME: f64 = 0.5;

impl Memory {
    /// No step yet.
    fn new(can_collide: CanCollide) -> Self {
        Self {
            narrow_phase: NarrowPhase::new(can_collide),
            screen: Screen::default(),
            primitives: Primitives::default(),
            resting: StepBoxes::default(),
            moving: StepBoxes::default(),
            kept: None,
        }
    }
}

impl CulledSearch {
    /// A search among all pairs.
    pub(crate) fn new(broad_phase: Arc<dyn BroadPhase>) -> Self {
        Self {
            broad_phase,
            memory: Memory::new(CanCollide::all()),
        }
    }

    pub(crate) fn can_collide(&self) -> &CanCollide {
        self.memory.narrow_phase.can_collide()
    }

    /// Replaces the pairs that can collide, without memory of earlier steps.
    pub(crate) fn set_can_collide(&mut self, can_collide: CanCollide) {
        self.memory = Memory::new(can_collide);
    }

    /// Makes certain that nothing that counts crosses at the start of a step.
    ///
    /// # Errors
    /// As [`StartCheck::examine`].
    pub(crate) fn check_start(
        &mut self,
        step: &Step<'_>,
        check: &mut StartCheck,
        counts: &dyn Fn(Intersection) -> bool,
    ) -> Result<(), StepError> {
        let Self { broad_phase, memory } = self;
        let can_collide = memory.narrow_phase.can_collide();
        check.examine(&**broad_phase, step, &mut memory.primitives, can_collide, counts)
    }

    /// Passes to the collector all candidates that come within their distance until its time, and possibly
    /// others. The search ends early if the collector breaks.
    pub(crate) fn run(&mut self, step: &Step<'_>, min_distance: &MinDistance, collector: &impl Collect) {
        self.memory.kept = None;
        self.pass(step, min_distance, collector, None);
    }

    /// Passes all candidates within a distance to a receiver, which is made of the narrow phase of the step.
    pub(crate) fn pass_within<'a, R: Receive>(
        &'a mut self,
        step: &Step<'_>,
        distance: Separation,
        receiver: impl FnOnce(&'a NarrowPhase) -> R,
    ) {
        let narrow_phase = &mut self.memory.narrow_phase;
        narrow_phase.begin(step, distance.into());
        let options = CandidateOptions {
            min_distance: distance.into(),
            can_collide: narrow_phase.can_collide().clone(),
            ..CandidateOptions::default()
        };
        let _ = overlaps::stream(*step, &*self.broad_phase, &options, &receiver(narrow_phase));
    }

    /// The same, for a search in a part of the step afterwards, which [`run_in_part`](Self::run_in_part)
    /// makes.
    pub(crate) fn run_keeping(
        &mut self,
        step: &Step<'_>,
        min_distance: &MinDistance,
        collector: &impl Collect,
    ) {
        let kept = Kept::new(step.mesh(), self.memory.kept.take().unwrap_or_default());
        self.pass(step, min_distance, collector, Some(&kept));
        self.memory.kept = kept.into_candidates();
    }

    /// Passes the candidates in a part of the last step to the collector: the candidates that the last
    /// search kept, if it did.
    ///
    /// The part is straight, from the same positions to the result of [`Step::at`] or
    /// [`advance`](crate::advance) at a time at which the collector of the last search ended, or before.
    /// This result is at most 3 ε (|x₀| + |x₁|) off the path, in any direction of rounding. So the boxes of
    /// the last search contain the part (`overlaps/path.rs`), and pairs that its [`Screen`] held back do not
    /// touch in it.
    pub(crate) fn run_in_part(
        &mut self,
        part: &Step<'_>,
        min_distance: &MinDistance,
        collector: &impl Collect,
    ) {
        let Memory {
            narrow_phase, kept, ..
        } = &mut self.memory;
        let Some(kept) = kept else {
            return self.run(part, min_distance, collector);
        };
        let _ = rayon::scope(|_| {
            narrow_phase.begin(part, min_distance.clone());
            kept.pass_to(&Examiner {
                narrow_phase,
                mesh: part.mesh(),
                collector,
            })
        });
    }

    fn pass(
        &mut self,
        step: &Step<'_>,
        min_distance: &MinDistance,
        collector: &impl Collect,
        kept: Option<&Kept>,
    ) {
        let Self { broad_phase, memory } = self;
        let Memory {
            narrow_phase,
            screen,
            primitives,
            resting,
            moving,
            ..
        } = memory;
        // All on threads of the pool: entering it from outside costs a context switch each time.
        let _ = rayon::scope(|_| {
            narrow_phase.begin(step, min_distance.clone());
            primitives.begin(step, narrow_phase.can_collide());
            let margin = Margin::new(min_distance.clone(), 0.0);
            resting.end(&margin);
            moving.end(&margin);
            let mut pass = Pass {
                step,
                min_distance,
                broad_phase: &**broad_phase,
                narrow_phase: &*narrow_phase,
                screen,
                primitives,
                collector,
                kept,
                short: time_of_short_displacements(step, primitives.origin()),
                until: collector.until(),
                screened: None,
            };
            let mut kinds = AnyKind::ALL.iter();
            kinds.try_for_each(|&kind| with_kind!(kind, K => pass.examine::<K>(resting, moving)))
        });
    }
}

impl CulledSearch {
    /// Searches the pairs that have a marked vertex, in all of the step. The step of the search before
    /// differs at most in the ends of marked vertices, and that search kept no candidates.
    pub(crate) fn run_marked(
        &mut self,
        step: &Step<'_>,
        min_distance: &MinDistance,
        marked: &[bool],
        collector: &impl Collect,
    ) {
        let Self { broad_phase, memory } = self;
        let Memory {
            narrow_phase,
            primitives,
            moving,
            ..
        } = memory;
        let _ = rayon::scope(|_| {
            narrow_phase.begin(step, min_distance.clone());
            let is_placed = moving.move_marked(step, marked);
            if !is_placed {
                primitives.begin(step, narrow_phase.can_collide());
                moving.end(&Margin::new(min_distance.clone(), 0.0));
            }
            let marked = Marked {
                is_placed,
                step,
                broad_phase: &**broad_phase,
                narrow_phase: &*narrow_phase,
                primitives,
                collector,
                marked,
            };
            let mut kinds = AnyKind::ALL.iter();
            kinds.try_for_each(|&kind| with_kind!(kind, K => marked.examine::<K>(moving)))
        });
    }
}

impl fmt::Debug for CulledSearch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = formatter.debug_struct("CulledSearch");
        text.field("memory", &self.memory).finish_non_exhaustive()
    }
}

/// The time until which all displacements, relative to the displacement of the origin, are short.
fn time_of_short_displacements(step: &Step<'_>, origin: Option<u32>) -> f64 {
    let [x0, x1] = step.positions();
    let length = |a: Point, b: Point| {
        let axes = minus(a, b).into_iter();
        axes.fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    let common = origin.map_or([0.0; 3], |vertex| minus(x1[vertex as usize], x0[vertex as usize]));
    let displacements = x0.iter().zip(x1).map(|(&a, &b)| length(common, minus(b, a)));
    let (sum, longest) = displacements.fold((0.0, 0.0), |(sum, longest): (f64, f64), length| {
        (sum + length, longest.max(length))
    });
    let mean = sum / x0.len() as f64;
    let edges = step.mesh().edges().iter().step_by(SAMPLE_STRIDE);
    let count = edges.len() as f64;
    let sum: f64 = edges
        .map(|edge| edge.map(|v| x0[v as usize]))
        .map(|[a, b]| length(a, b))
        .sum();
    let edge = sum / count;
    let [of_mean, of_longest] = SHORT_DISPLACEMENTS;
    (of_mean * edge / mean).min(of_longest * edge / longest)
}

/// One pass over the candidates of a step.
struct Pass<'a, C> {
    step: &'a Step<'a>,
    min_distance: &'a MinDistance,
    broad_phase: &'a dyn BroadPhase,
    narrow_phase: &'a NarrowPhase,
    screen: &'a mut Screen,
    primitives: &'a Primitives,
    collector: &'a C,
    kept: Option<&'a Kept>,
    /// The time until which all displacements, relative to the displacement of the origin, are short.
    short: f64,
    /// The collector's time before the search.
    until: f64,
    /// The time until which the screen is placed.
    screened: Option<f64>,
}

impl<C: Collect> Pass<'_, C> {
    /// Examines the candidates of one kind. It examines a sample first, if that may shorten the search and
    /// if no other kind has shortened it.
    fn examine<K: Searched>(
        &mut self,
        resting: &mut StepBoxes<1>,
        moving: &mut StepBoxes<2>,
    ) -> ControlFlow<()> {
        if self.primitives.lack::<K>() {
            return ControlFlow::Continue(());
        }
        let profits = C::PROFITS_FROM_SAMPLE && self.collector.until() >= self.until;
        let of_sample = profits.then_some(Some(SAMPLE_STRIDE));
        let mut placed = None;
        for sample in of_sample.into_iter().chain([None]) {
            let time = self.collector.until();
            // The better boxes.
            let is_short = time < self.short;
            let stay = placed
                .is_some_and(|(was_short, before)| was_short == is_short && time >= SHRUNK_TIME * before);
            let new_time = (!stay).then_some(time);
            if is_short {
                self.examine_among::<K, 1>(resting, self.broad_phase, new_time, sample)?;
            } else {
                self.examine_among::<K, 2>(moving, self.broad_phase, new_time, sample)?;
            }
            if sample.is_some() {
                self.collector.forget_sample::<K>();
            }
            if !stay {
                placed = Some((is_short, time));
            }
        }
        ControlFlow::Continue(())
    }

    /// Examines the candidates of one kind, or of a sample, after the boxes have been placed for a new time.
    fn examine_among<K: Searched, const T: usize>(
        &mut self,
        boxes: &mut StepBoxes<T>,
        broad_phase: &dyn BoxPairs<T>,
        new_time: Option<f64>,
        sample: Option<usize>,
    ) -> ControlFlow<()> {
        let (mesh, can_collide) = (self.step.mesh(), self.narrow_phase.can_collide());
        if let Some(time) = new_time {
            boxes.place::<K>(self.step, self.primitives, time);
        }
        let examiner = Examiner {
            narrow_phase: self.narrow_phase,
            mesh,
            collector: self.collector,
        };
        let examine = |pairs: &[_]| examiner.receive::<K>(pairs);
        let Some(kept) = self.kept.filter(|_| sample.is_none()) else {
            return boxes.pairs::<K>(mesh, broad_phase, sample, &examine);
        };
        let time = self.collector.until();
        if self.screened.is_none_or(|before| time < SHRUNK_TIME * before) {
            self.screen.place(self.step, time, self.min_distance);
            self.screened = Some(time);
        }
        boxes.pairs::<K>(mesh, broad_phase, sample, &|pairs: &[_]| {
            // After a contact at t = 0 there is no search in a part.
            if self.collector.until().to_bits() == 0 {
                return examine(pairs);
            }
            let passing = self.screen.passing::<K>(mesh, can_collide, pairs);
            kept.add::<K>(&passing);
            examine(&passing)
        })
    }
}

/// A search among the pairs that have a marked vertex.
struct Marked<'a, C> {
    step: &'a Step<'a>,
    broad_phase: &'a dyn BroadPhase,
    narrow_phase: &'a NarrowPhase,
    primitives: &'a Primitives,
    collector: &'a C,
    marked: &'a [bool],
    /// True if the boxes of the vertices belong to the step.
    is_placed: bool,
}

impl<C: Collect> Marked<'_, C> {
    fn examine<K: Searched>(&self, boxes: &mut StepBoxes<2>) -> ControlFlow<()> {
        if self.primitives.lack::<K>() {
            return ControlFlow::Continue(());
        }
        let mesh = self.step.mesh();
        if self.is_placed {
            boxes.place_marked::<K>(mesh, self.marked);
        } else {
            boxes.place::<K>(self.step, self.primitives, 1.0);
        }
        let examiner = Examiner {
            narrow_phase: self.narrow_phase,
            mesh,
            collector: self.collector,
        };
        boxes.pairs_of_marked::<K>(mesh, self.broad_phase, self.marked, &|pairs: &[_]| {
            examiner.receive::<K>(pairs)
        })
    }
}

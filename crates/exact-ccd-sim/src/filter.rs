//! Continuous collision detection in the line search.

use std::fmt;
use std::sync::Arc;

use exact_ccd::{Ccd, Exact, Options, TimeGuarantee};
use exact_ccd_mesh::{Candidates, MinDistance, Pair, Step, Tolerance, bisect};

/// The bound on each Newton step, by a method of continuous collision detection.
///
/// A simulation guarantees as much as its method: a method with false negatives lets primitives pass through
/// each other.
///
/// ```
/// use std::sync::Arc;
///
/// use exact_ccd_methods::parity::RootParity;
/// use exact_ccd_sim::StepFilter;
///
/// assert_eq!(StepFilter::default().name(), "exact");
/// assert_eq!(StepFilter::new("parity", Arc::new(RootParity::default())).name(), "parity");
/// ```
#[derive(Clone)]
pub struct StepFilter {
    name: String,
    method: Arc<dyn Ccd>,
    search: Search,
    observer: Option<Arc<Observer>>,
}

type Observer = dyn Fn(&Candidates, Step<'_>) + Send + Sync;

/// The algorithm that finds the free part of a step.
#[derive(Clone, Copy)]
enum Search {
    /// By the earliest time of impact of the full step.
    TimeOfImpact,
    /// By decisions alone: algorithm 2 of the paper, see [`bisect`].
    Bisection,
}

/// The largest size of a step that is not free of contact, even of one that touches at its very end.
const LARGEST_BLOCKED: f64 = 1.0_f64.next_down();

/// The width of the interval at which a bisection stops.
const TOLERANCE: Tolerance = Tolerance::Relative(0.125);

impl Default for StepFilter {
    /// The filter with the exact method.
    fn default() -> Self {
        Self::new("exact", Arc::new(Exact))
    }
}

impl StepFilter {
    /// The filter with a method: by its times of impact if it has times, otherwise by bisection.
    #[must_use]
    pub fn new(name: &str, method: Arc<dyn Ccd>) -> Self {
        let search = match method.guarantees().time {
            TimeGuarantee::Absent => Search::Bisection,
            TimeGuarantee::Approximate | TimeGuarantee::Conservative | TimeGuarantee::Exact => {
                Search::TimeOfImpact
            }
        };
        Self {
            name: name.to_owned(),
            method,
            search,
            observer: None,
        }
    }

    /// The filter with a method by bisection, even if the method has times of impact.
    #[must_use]
    pub fn by_bisection(name: &str, method: Arc<dyn Ccd>) -> Self {
        Self {
            search: Search::Bisection,
            ..Self::new(name, method)
        }
    }

    /// The same filter with a callback for each step that it decides: the full step of a line search, and
    /// the steps that the line search takes. The callback runs on one thread at a time, in the order of the
    /// decisions.
    #[must_use]
    pub fn observed(self, observer: impl Fn(&Candidates, Step<'_>) + Send + Sync + 'static) -> Self {
        Self {
            observer: Some(Arc::new(observer)),
            ..self
        }
    }

    /// The name of the filter, for settings, checkpoints and messages.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns true if the times of the method are exact. The kernel computes the same times then, also
    /// within the offsets of surfaces, and takes the place of the method.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.method.guarantees().time == TimeGuarantee::Exact
    }

    /// The part of a step that is free of contact, from 0 to 1, according to the method. It is 1 only if
    /// all of the step is free. `candidates` has all pairs that can touch in the step.
    ///
    /// The exact method decides for the minimum distance, which is the sum of the offsets of two surfaces.
    /// Other methods decide contact, whatever the minimum distance.
    #[must_use]
    pub fn free_part(&self, candidates: &Candidates, step: Step<'_>, min_distance: &MinDistance) -> f64 {
        self.observe(candidates, step);
        self.part(candidates, step, min_distance)
    }

    /// A pair for which no part of a step is free, found by halving the list of all pairs. `None` if the
    /// method rejects every part for several pairs only.
    pub(crate) fn blocking_pair(
        &self,
        candidates: &Candidates,
        step: Step<'_>,
        min_distance: &MinDistance,
    ) -> Option<Pair> {
        let is_blocked = |pairs: &[Pair]| {
            let candidates = pairs.iter().copied().collect();
            self.part(&candidates, step, min_distance) <= 0.0
        };
        let mut pairs: Vec<Pair> = candidates.pairs().collect();
        while pairs.len() > 1 {
            let last = pairs.split_off(pairs.len() / 2);
            if !is_blocked(&pairs) {
                pairs = last;
            }
        }
        is_blocked(&pairs).then(|| pairs.pop()).flatten()
    }

    fn part(&self, candidates: &Candidates, step: Step<'_>, min_distance: &MinDistance) -> f64 {
        if let Search::Bisection = self.search {
            return self.bisect(candidates, step, min_distance);
        }
        let earliest = if self.is_exact() {
            let contact = candidates.collision(step, Options::within(min_distance.clone()));
            contact.map(|contact| contact.impact.time.lower())
        } else {
            candidates.time_of_impact_by(step, &*self.method)
        };
        match earliest {
            None => 1.0,
            Some(time) if time > 0.0 || self.is_exact() => time.min(LARGEST_BLOCKED),
            // A conservative time of 0 is no proof of contact at the start.
            Some(_) => self.bisect(candidates, step, min_distance),
        }
    }

    /// Returns true if a step is free of contact, as for [`free_part`](Self::free_part).
    #[must_use]
    pub fn is_free(&self, candidates: &Candidates, step: Step<'_>, min_distance: &MinDistance) -> bool {
        self.observe(candidates, step);
        self.decide(candidates, step, min_distance)
    }

    fn decide(&self, candidates: &Candidates, step: Step<'_>, min_distance: &MinDistance) -> bool {
        if self.is_exact() {
            !candidates.collides(step, Options::within(min_distance.clone()))
        } else {
            !candidates.collides_by(step, &*self.method)
        }
    }

    fn bisect(&self, candidates: &Candidates, step: Step<'_>, min_distance: &MinDistance) -> f64 {
        bisect(TOLERANCE, |part| {
            let end = step.at(part);
            let part = Step::new(step.mesh(), step.positions()[0], &end);
            part.is_ok_and(|part| self.decide(candidates, part, min_distance))
        })
    }

    fn observe(&self, candidates: &Candidates, step: Step<'_>) {
        if let Some(observer) = &self.observer {
            observer(candidates, step);
        }
    }
}

impl fmt::Debug for StepFilter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StepFilter")
            .field("name", &self.name)
            .finish_non_exhaustive()
    }
}

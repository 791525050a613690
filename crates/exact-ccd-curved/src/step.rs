//! A step of a mesh whose vertices move on curves.

use exact_ccd::separation::Separation;
use exact_ccd::{EdgeEdge, Point, VertexFace};
use exact_ccd_mesh::{
    Bvh, CanCollide, CandidateOptions, Candidates, Pair, PairKind, Step, StepError, TriangleMesh,
};
use rayon::prelude::*;

use crate::answer::{Answer, End};
use crate::error::SearchError;
use crate::kind::CurvedKind;
use crate::options::SearchOptions;
use crate::rounding::{above, flushes_subnormals};
use crate::search::search;
use crate::straight::Straight;
use crate::trajectory::{Chord, Trajectory};

/// The certified part of a step of a mesh whose vertices move on curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedStep {
    /// The pair with the earliest time until which it is certainly free, if a pair is not free.
    pub pair: Option<Pair>,
    /// The answer for that pair: all pairs are certainly farther than d apart before
    /// [`free_until`](Answer::free_until), and in the whole step if it [is free](Answer::is_free). The
    /// number of chords is that of all pairs.
    pub answer: Answer,
    /// The number of intervals of time with a broad phase of their own.
    pub intervals: usize,
    /// The number of pairs that the broad phases found.
    pub candidates: usize,
}

/// The reason why a step has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvedStepError {
    /// The positions at the ends of an interval are not a step of the mesh.
    #[error("for the times from {start} to {end}: {source}")]
    Step {
        /// The start of the interval.
        start: f64,
        /// The end of the interval.
        end: f64,
        /// The reason.
        source: StepError,
    },
    /// A bound of a trajectory is not valid: the point is the index of the vertex.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// The search of a pair failed: the points are those of the pair.
    #[error("{pair:?}: {source}")]
    Pair {
        /// The pair.
        pair: Pair,
        /// The reason.
        source: SearchError,
    },
}

/// Options of [`curved_step`].
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct CurvedStepOptions {
    /// The end of the search of each pair.
    pub search: SearchOptions,
    /// The pairs that can collide. For rigid bodies, those of
    /// [`Instances::can_collide`](crate::Instances::can_collide).
    pub can_collide: CanCollide,
}

impl CurvedStepOptions {
    /// The same options with other options of the searches.
    #[must_use]
    pub fn with_search(self, search: SearchOptions) -> Self {
        Self { search, ..self }
    }

    /// The same options with another predicate.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }
}

/// The first time at which two primitives of a mesh, whose vertices move on curves, are at most d
/// apart, between certain bounds.
///
/// The step is cut into intervals of time in which the deviations are small compared with the motion. In
/// each, the pairs near each other are found by boxes around the chords, larger by d and the deviations;
/// those whose chords come within d and the deviations are searched as by
/// [`first_within`](crate::first_within). Primitives that share a vertex are left out. The result does not
/// depend on the number of threads.
///
/// # Errors
/// [`CurvedStepError`], if the trajectories are not as many as the vertices, if a position is not finite,
/// or if a bound or the tolerance is not valid.
pub fn curved_step<T: Trajectory + Sync>(
    mesh: &TriangleMesh,
    trajectories: &[T],
    d: Separation,
    options: &CurvedStepOptions,
) -> Result<CurvedStep, CurvedStepError> {
    options.search.check()?;
    if flushes_subnormals() {
        return Err(SearchError::FlushedSubnormals.into());
    }
    let answer = Answer {
        free_until: 0.0,
        within: None,
        end: End::Free,
        chords: 0,
    };
    let mut step = CurvedStep {
        pair: None,
        answer,
        intervals: 0,
        candidates: 0,
    };
    let mut ends = vec![1.0];
    while let (Some(&end), None) = (ends.last(), step.pair) {
        let start = step.answer.free_until;
        let moving = Moving::new(mesh, trajectories, start, end)?;
        if !moving.is_fine() {
            ends.push(start + 0.5 * (end - start));
            continue;
        }
        ends.pop();
        step.intervals += 1;
        moving.advance(d, options, &mut step)?;
    }
    Ok(step)
}

/// The mesh in an interval of time.
struct Moving<'a, T> {
    mesh: &'a TriangleMesh,
    trajectories: &'a [T],
    chords: Vec<Chord>,
    start: f64,
    end: f64,
}

/// The shortest interval that is cut.
const SHORTEST: f64 = 1.0 / 65536.0;

impl<'a, T: Trajectory + Sync> Moving<'a, T> {
    fn new(mesh: &'a TriangleMesh, trajectories: &'a [T], start: f64, end: f64) -> Result<Self, SearchError> {
        let chords: Vec<Chord> = trajectories
            .par_iter()
            .map(|x| Chord::of(x, start, end))
            .collect();
        if let Some(point) = chords.iter().position(|chord| chord.deviation.is_nan()) {
            return Err(SearchError::Bound { point, start, end });
        }
        Ok(Self {
            mesh,
            trajectories,
            chords,
            start,
            end,
        })
    }

    fn deviation(&self) -> f64 {
        self.chords
            .iter()
            .fold(0.0, |largest, chord| largest.max(chord.deviation))
    }

    /// Returns true if boxes around the chords are not much larger by the deviations: by at most an eighth
    /// of the longest chord, or 2⁻³⁰ of the largest coordinate. Shorter intervals have smaller boxes, and
    /// cost a broad phase each.
    fn is_fine(&self) -> bool {
        let largest = |of: fn(&Chord) -> f64| self.chords.iter().map(of).fold(0.0, f64::max);
        let deviation = self.deviation();
        let coordinate = |chord: &Chord| {
            let coordinates = chord.ends.as_flattened().iter();
            coordinates.fold(0.0, |largest: f64, x| largest.max(x.abs()))
        };
        self.end - self.start <= SHORTEST
            || deviation <= 0.125 * largest(Chord::length)
            || deviation <= largest(coordinate) / (1 << 30) as f64
    }

    /// Decides this interval: `step` is free until its start.
    fn advance(
        &self,
        d: Separation,
        options: &CurvedStepOptions,
        step: &mut CurvedStep,
    ) -> Result<(), CurvedStepError> {
        let Self { start, end, .. } = *self;
        let ends = [0, 1].map(|time: usize| self.chords.iter().map(|x| x.ends[time]).collect::<Vec<Point>>());
        let chords = Step::new(self.mesh, &ends[0], &ends[1]);
        let chords = chords.map_err(|source| CurvedStepError::Step { start, end, source })?;
        let candidate_options = CandidateOptions::default()
            .with_distance(above(d.get() + 2.0 * self.deviation()))
            .with_can_collide(options.can_collide.clone());
        // The distance is not negative.
        let candidates = Candidates::with_options(chords, &Bvh, &candidate_options).unwrap_or_default();
        step.candidates += candidates.counts().total();
        step.answer.free_until = end;
        self.search_all::<VertexFace>(candidates.vertex_face(), d, options, step)?;
        self.search_all::<EdgeEdge>(candidates.edge_edge(), d, options, step)
    }

    /// Searches some pairs until the time until which all before them are free.
    fn search_all<K: PairKind + CurvedKind<Trajectories<T> = [T; 4]>>(
        &self,
        pairs: &[[u32; 2]],
        d: Separation,
        options: &CurvedStepOptions,
        step: &mut CurvedStep,
    ) -> Result<(), CurvedStepError> {
        let start = self.start;
        let near = pairs.par_iter().filter(|ids| self.may_come_within::<K>(**ids, d));
        let near: Vec<[u32; 2]> = near.copied().collect();
        step.answer.chords += pairs.len();
        for ids in near {
            let Some(vertices) = K::vertices(self.mesh, ids) else {
                continue;
            };
            let trajectories = vertices.map(|vertex| &self.trajectories[vertex as usize]);
            let until = step.answer.free_until;
            if until <= start {
                break;
            }
            let answer = search::<K, _>(&trajectories, d, &options.search, [start, until]);
            let pair = <K as PairKind>::pair(ids);
            let answer = answer.map_err(|source| CurvedStepError::Pair { pair, source })?;
            let chords = step.answer.chords + answer.chords;
            if !answer.is_free() && (step.pair.is_none() || answer.free_until < until) {
                (step.pair, step.answer) = (Some(pair), answer);
            }
            step.answer.chords = chords;
        }
        Ok(())
    }

    /// Returns false if the curves of a pair are certainly farther than d apart in this interval.
    fn may_come_within<K: PairKind + CurvedKind>(&self, ids: [u32; 2], d: Separation) -> bool {
        let Some(vertices) = K::vertices(self.mesh, ids) else {
            return false;
        };
        let chords = vertices.map(|vertex| self.chords[vertex as usize]);
        Straight::<K>::new(&chords, self.start, self.end)
            .map_or(true, |straight| straight.free_until(d).is_some())
    }
}

//! A mesh in an interval of time, in which its vertices are near their chords.

use exact_ccd::batch::Trajectories;
use exact_ccd::{AnyKind, Point, Separation, Thickness, with_kind};
use exact_ccd_mesh::{Bvh, CandidateOptions, Candidates, MinDistance, Pair, PairKind, Step, TriangleMesh};
use rayon::prelude::*;

use crate::answer::Answer;
use crate::error::SearchError;
use crate::kind::CurvedKind;
use crate::options::SearchOptions;
use crate::rounding::add_up;
use crate::search::search;
use crate::step_answer::{CurvedStep, CurvedStepError, CurvedStepOptions};
use crate::straight::time_before;
use crate::trajectory::{Chord, Trajectory};

/// A mesh, and the chords of its vertices.
pub(crate) struct Interval<'a, T> {
    mesh: &'a TriangleMesh,
    trajectories: &'a [T],
    chords: Vec<Chord>,
    start: f64,
    end: f64,
}

/// The shortest interval that is cut.
const SHORTEST: f64 = 1.0 / 65536.0;

/// The number of pairs that a thread decides at a time.
const GRAIN: usize = 2048;

impl<'a, T: Trajectory + Sync> Interval<'a, T> {
    pub(crate) fn new(
        mesh: &'a TriangleMesh,
        trajectories: &'a [T],
        start: f64,
        end: f64,
    ) -> Result<Self, SearchError> {
        let chords = trajectories.par_iter().map(|x| Chord::of(x, start, end));
        let chords = chords.collect::<Result<Vec<_>, _>>()?;
        Chord::check(&chords, start, end)?;
        Ok(Self {
            mesh,
            trajectories,
            chords,
            start,
            end,
        })
    }

    /// Returns true if the deviations make the boxes around the chords much larger: by more than an eighth
    /// of the longest chord, and 2⁻³⁰ of the largest coordinate. Shorter intervals have smaller boxes, but
    /// each of them costs a broad phase.
    pub(crate) fn is_coarse(&self) -> bool {
        let largest = |of: fn(&Chord) -> f64| self.chords.iter().map(of).fold(0.0, f64::max);
        let coordinate = |chord: &Chord| {
            let coordinates = chord.ends.as_flattened().iter();
            coordinates.fold(0.0, |largest: f64, x| largest.max(x.abs()))
        };
        let small = (0.125 * largest(Chord::length)).max(largest(coordinate) / f64::from(1 << 30));
        self.end - self.start > SHORTEST && largest(|chord| chord.deviation) > small
    }

    /// Decides this interval. The step is free until its start; afterwards it has a pair, or is free until
    /// the end.
    pub(crate) fn advance(
        &self,
        d: Separation,
        options: &CurvedStepOptions,
        step: &mut CurvedStep,
    ) -> Result<(), CurvedStepError> {
        step.answer.free_until = self.end;
        for (relative, pair) in self.near(d, options, step)? {
            let until = step.answer.free_until;
            if step.pair.is_some() && time_before(relative, self.start, self.end) >= until {
                break;
            }
            let answer = self.search(pair, d, &options.search, until);
            let answer = answer.map_err(|source| CurvedStepError::Pair { pair, source })?;
            let chords = step.answer.chords + answer.chords;
            if !answer.is_free() && (step.pair.is_none() || answer.free_until < until) {
                (step.pair, step.answer) = (Some(pair), answer);
            }
            step.answer.chords = chords;
        }
        Ok(())
    }

    /// The pairs whose chords come within d and their deviations, each with the time at which they first
    /// do, relative to the interval and rounded down; the earliest first.
    fn near(
        &self,
        d: Separation,
        options: &CurvedStepOptions,
        step: &mut CurvedStep,
    ) -> Result<Vec<(f64, Pair)>, CurvedStepError> {
        let Self { start, end, .. } = *self;
        let [x0, x1] =
            [0, 1].map(|time: usize| self.chords.iter().map(|x| x.ends[time]).collect::<Vec<Point>>());
        let chords = Step::new(self.mesh, &x0, &x1);
        let chords = chords.map_err(|source| CurvedStepError::Step { start, end, source })?;
        let half = 0.5 * d.get();
        // Half of a subnormal number may be rounded down.
        let half = if half + half < d.get() {
            half.next_up()
        } else {
            half
        };
        let thickness = |half: f64| {
            let of = |chord: &Chord| add_up(chord.deviation, half);
            let thickness = Thickness::new(&self.chords.iter().map(of).collect::<Vec<f64>>());
            thickness.map_err(|source| CurvedStepError::Deviation { start, end, source })
        };
        let (thickness, bare) = (thickness(half)?, thickness(0.0)?);
        let candidate_options = CandidateOptions::default()
            .with_min_distance(MinDistance::thickness(thickness.clone()))
            .with_can_collide(options.can_collide.clone());
        let candidates = Candidates::with_options(chords, &Bvh, &candidate_options);
        let candidates = candidates.expect("each vertex has a thickness");
        let trajectories = Trajectories::new(&x0, &x1).expect("the positions belong to a step");
        step.candidates += candidates.counts().total();
        step.answer.chords += candidates.counts().total();
        let mut near = Vec::new();
        for &kind in AnyKind::ALL {
            with_kind!(kind, K => {
                let (connected, others): (Vec<_>, Vec<_>) =
                    candidates.of_kind(kind).iter().partition(|&&ids| self.are_connected::<K>(ids));
                near.extend(self.near_of::<K>(&trajectories, &thickness, &others));
                near.extend(self.near_of::<K>(&trajectories, &bare, &connected));
            });
        }
        near.sort_unstable_by(|(s, p), (t, q)| s.total_cmp(t).then(p.cmp(q)));
        Ok(near)
    }

    /// Returns true if a vertex and an edge touch at distance 0 only: see
    /// [`PairKind::are_connected`].
    fn are_connected<K: PairKind>(&self, ids: [u32; 2]) -> bool {
        let vertices = K::vertices(self.mesh, ids);
        vertices.is_some_and(|vertices| K::are_connected(self.mesh, &vertices))
    }

    fn near_of<K: PairKind>(
        &self,
        trajectories: &Trajectories,
        thickness: &Thickness,
        pairs: &[[u32; 2]],
    ) -> Vec<(f64, Pair)> {
        let near_among = |pairs: &[[u32; 2]]| {
            let exists = |&ids: &[u32; 2]| Some((ids, K::vertices(self.mesh, ids)?));
            let (ids, queries): (Vec<_>, Vec<_>) = pairs.iter().filter_map(exists).unzip();
            let mut near = Vec::new();
            let found = trajectories.collisions::<K>(&queries, thickness, |index, collision| {
                near.push((collision.time().lower(), Pair::new(K::KIND, ids[index])));
            });
            found.expect("the vertices belong to the mesh");
            near
        };
        pairs.par_chunks(GRAIN).flat_map_iter(near_among).collect()
    }

    /// The search of a pair from the start of the interval.
    fn search(
        &self,
        pair: Pair,
        d: Separation,
        options: &SearchOptions,
        until: f64,
    ) -> Result<Answer, SearchError> {
        with_kind!(pair.kind(), K => self.search_of::<K>(pair.ids(), d, options, until))
    }

    fn search_of<K: PairKind + CurvedKind>(
        &self,
        ids: [u32; 2],
        d: Separation,
        options: &SearchOptions,
        until: f64,
    ) -> Result<Answer, SearchError> {
        let d = if self.are_connected::<K>(ids) {
            Separation::default()
        } else {
            d
        };
        // The pair is one of the mesh.
        let vertices = K::vertices(self.mesh, ids);
        let vertices = vertices.as_ref().map_or(&[][..], AsRef::as_ref);
        let trajectories: Vec<&T> = vertices
            .iter()
            .map(|&vertex| &self.trajectories[vertex as usize])
            .collect();
        search::<K, _>(&trajectories, d, options, [self.start, until])
    }
}

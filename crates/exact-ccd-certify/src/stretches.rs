//! The stretches of time in which directions separate a pair.

use exact_ccd::Point;
use exact_ccd_check::grid::Grid;
use exact_ccd_check::motion::{Motion, Time};
use exact_ccd_check::separation::Stretch;
use exact_ccd_check::{Kind, Pair};

use crate::{direction, feature};

/// The most stretches of a pair.
const MOST: usize = 512;

/// The bits of the components of rounded directions.
const BITS: [u32; 4] = [8, 16, 32, 48];

/// A step up to a time.
pub(crate) struct Step<'a> {
    pub(crate) motion: &'a Motion,
    pub(crate) grid: &'a Grid,
    pub(crate) positions: [&'a [Point]; 2],
    pub(crate) distance: f64,
    pub(crate) until: f64,
}

impl Step<'_> {
    /// Stretches that prove a pair to be apart, if they are found.
    pub(crate) fn stretches(&self, kind: Kind, pair: &Pair) -> Option<Vec<Stretch>> {
        let until = if kind == Kind::EdgeFace { 0.0 } else { self.until };
        let (mut stretches, mut start, mut ends) = (Vec::new(), 0.0, vec![until]);
        while let Some(&end) = ends.last() {
            if let Some(stretch) = self.stretch(kind, pair, [start, end]) {
                stretches.push(stretch);
                start = end;
                ends.pop();
            } else {
                let middle = start + (end - start) / 2.0;
                if !(start < middle && middle < end) || stretches.len() + ends.len() >= MOST {
                    return None;
                }
                ends.push(middle);
            }
        }
        Some(stretches)
    }

    /// One stretch: its direction is constant, or turns, or is a direction between the closest features at
    /// the end or at the start.
    fn stretch(&self, kind: Kind, pair: &Pair<'_>, times: [f64; 2]) -> Option<Stretch> {
        let [start, end] = times;
        let holds = |stretch: &Stretch| stretch.holds(self.motion, kind, pair, start);
        let [at_start, at_end] = times.map(|time| self.corners(pair, time));
        let d = if pair.has_distance { self.distance } else { 0.0 };
        // The margins are rounded.
        let best = |points: &[Point]| {
            direction::best(points)
                .filter(|(_, margin)| *margin >= d * (1.0 - 1e-9))
                .map(|(g, _)| g)
        };

        let both = if start == end {
            at_start.clone()
        } else {
            [&at_start[..], &at_end].concat()
        };
        if let Some(g) = best(&both) {
            for bits in BITS {
                let g = direction::rounded(g, bits).map(Into::into);
                let ends: &[usize] = if kind == Kind::EdgeFace { &[0] } else { &[0, 1] };
                let is_whole = start == 0.0 && (end == self.until || kind == Kind::EdgeFace);
                let stretch = constant(end, g);
                if is_whole && self.grid.separates(pair, &stretch.from, ends) || holds(&stretch) {
                    return Some(stretch);
                }
            }
        }

        let guesses = [best(&at_start), best(&at_end)];
        if let [Some(from), Some(to)] = guesses
            && start < end
        {
            for bits in BITS {
                let [from, to] = [from, to].map(|g| direction::rounded(g, bits).map(Into::into));
                let stretch = Stretch { end, from, to };
                if holds(&stretch) {
                    return Some(stretch);
                }
            }
        }

        // Shorter stretches are easier, unless rounded directions fail at a single time.
        let is_enough = |time: f64, guess: Option<Point>| {
            guess.is_some_and(|g| {
                constant(time, direction::rounded(g, BITS[3]).map(Into::into)).holds(
                    self.motion,
                    kind,
                    pair,
                    time,
                )
            })
        };
        if is_enough(start, guesses[0]) && is_enough(end, guesses[1]) {
            return None;
        }
        let [from, to] = Time::together(times).map(|time| feature::directions(self.motion, pair, &time));
        let constants = to
            .iter()
            .chain(&from)
            .map(|g| constant(end, feature::reduced([g])[0].clone()));
        let turning = from.iter().zip(&to).map(|(from, to)| {
            let [from, to] = feature::reduced([from, to]);
            Stretch { end, from, to }
        });
        constants.chain(turning).find(holds)
    }

    /// The differences of the vertices of both primitives, rounded.
    fn corners(&self, pair: &Pair<'_>, time: f64) -> Vec<Point> {
        let at = |vertex: &u32| {
            let [a, b] = self.positions.map(|x| x[*vertex as usize]);
            [0, 1, 2].map(|axis: usize| a[axis] + time * (b[axis] - a[axis]))
        };
        let second: Vec<Point> = pair.second.iter().map(at).collect();
        let difference = |a: Point, b: Point| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        pair.first
            .iter()
            .map(at)
            .flat_map(|a| second.iter().map(move |&b| difference(a, b)))
            .collect()
    }
}

/// A stretch with one direction.
fn constant(end: f64, g: exact_ccd_check::motion::Point) -> Stretch {
    Stretch {
        end,
        from: g.clone(),
        to: g,
    }
}

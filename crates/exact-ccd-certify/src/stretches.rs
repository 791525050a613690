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

    /// One stretch: a constant direction, or one that turns, or that of closest features at the end or
    /// at the start.
    fn stretch(&self, kind: Kind, pair: &Pair, times: [f64; 2]) -> Option<Stretch> {
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
                let g = direction::rounded(g, bits);
                let ends: &[usize] = if kind == Kind::EdgeFace { &[0] } else { &[0, 1] };
                let is_whole = start == 0.0 && (end == self.until || kind == Kind::EdgeFace);
                let stretch = Stretch {
                    end,
                    from: g.map(Into::into),
                    to: None,
                };
                if is_whole && self.grid.separates(pair, g, ends) || holds(&stretch) {
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
                let stretch = Stretch {
                    end,
                    from,
                    to: Some(to),
                };
                if holds(&stretch) {
                    return Some(stretch);
                }
            }
        }

        // Shorter stretches are easier, unless rounded directions fail at a single time.
        let is_enough = |time: f64, guess: Option<Point>| {
            guess.is_some_and(|g| {
                let from = direction::rounded(g, BITS[3]).map(Into::into);
                Stretch {
                    end: time,
                    from,
                    to: None,
                }
                .holds(self.motion, kind, pair, time)
            })
        };
        if is_enough(start, guesses[0]) && is_enough(end, guesses[1]) {
            return None;
        }
        let power = times
            .map(|time| Time::new(time).power)
            .into_iter()
            .max()
            .unwrap_or(0);
        let at = |time: f64| feature::directions(self.motion, pair, &Time::new(time).over(power));
        let [from, to] = times.map(at);
        let constant = to.iter().chain(&from).map(|g| (feature::reduced([g]), None));
        let turning = from.iter().zip(&to).map(|(from, to)| {
            let [from, to] = feature::reduced([from, to]);
            ([from], Some(to))
        });
        let mut exact = constant
            .chain(turning)
            .map(|([from], to)| Stretch { end, from, to });
        exact.find(holds)
    }

    /// The differences of the vertices of both primitives, rounded.
    fn corners(&self, pair: &Pair, time: f64) -> Vec<Point> {
        let at = |vertex: &u32| {
            let [a, b] = self.positions.map(|x| x[*vertex as usize]);
            [0, 1, 2].map(|axis: usize| a[axis] + time * (b[axis] - a[axis]))
        };
        let (first, second) = pair.vertices().split_at(pair.first());
        let second: Vec<Point> = second.iter().map(at).collect();
        let difference = |a: Point, b: Point| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        first
            .iter()
            .map(at)
            .flat_map(|a| second.iter().map(move |&b| difference(a, b)))
            .collect()
    }
}

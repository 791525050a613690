//! Changes that make a query degenerate: exactly on small integers, approximately where they round.

use crate::primitives::{Points, combine};

/// A relation imposed on the points.
#[derive(Clone, Copy, Debug)]
pub enum Change {
    /// The first of these points becomes xⱼ + a (xₖ − xⱼ) + b (xₗ − xⱼ) for the others, at the
    /// marked ends of the step. Then points coincide or are collinear or coplanar, and edges are
    /// parallel.
    Combine {
        /// i, j, k and l.
        points: [usize; 4],
        /// a and b.
        factors: [i8; 2],
        /// True for each end of the step that is marked.
        ends: [bool; 2],
    },
    /// A point does not move.
    Rest(usize),
    /// All points move as this one does.
    Drift(usize),
    /// All points stay in a plane across this axis.
    Flatten(usize),
}

impl Change {
    /// Changes the points.
    pub fn apply(self, points: &mut Points) {
        match self {
            Self::Combine {
                points: [i, j, k, l],
                factors,
                ends,
            } => {
                let [a, b] = factors.map(f64::from);
                for (now, _) in points.iter_mut().zip(ends).filter(|(_, marked)| *marked) {
                    now[i] = combine([1.0 - a - b, a, b], [now[j], now[k], now[l]]);
                }
            }
            Self::Rest(point) => points[1][point] = points[0][point],
            Self::Drift(like) => {
                let shift = combine([1.0, -1.0], [points[1][like], points[0][like]]);
                points[1] = points[0].map(|point| combine([1.0, 1.0], [point, shift]));
            }
            Self::Flatten(axis) => {
                for now in points {
                    let level = now[0][axis];
                    now.iter_mut().for_each(|point| point[axis] = level);
                }
            }
        }
    }
}

/// The f64 that is a few steps after x, or before it.
fn nudged(x: f64, steps: i8) -> f64 {
    let next = if steps < 0 { f64::next_down } else { f64::next_up };
    (0..steps.unsigned_abs()).fold(x, |x, _| next(x))
}

/// Single coordinates moved by a few steps.
pub fn nudge(mut points: Points, nudges: &[([usize; 3], i8)]) -> Points {
    for &([time, point, axis], steps) in nudges {
        let coordinate = &mut points[time][point][axis];
        *coordinate = nudged(*coordinate, steps);
    }
    points
}

/// x times a power of two, rounded if it is subnormal.
pub fn scaled(x: f64, exponent: i32) -> f64 {
    // In two factors, because 2⁻¹⁰⁷⁴ may be out of the range of `powi`.
    let half = exponent / 2;
    x * 2f64.powi(half) * 2f64.powi(exponent - half)
}

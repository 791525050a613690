//! The search for the root of a volume that has one between two times.

use super::corners::Curves;
use super::polynomial::MOST;
use crate::numbers::vector::{cross, dot};
use crate::tables::Point;

/// The most evaluations in f64.
const GUESSES: u32 = 24;

/// Two times with the root between them.
pub(super) struct Bracket {
    low: f64,
    high: f64,
    /// The values there; if an end stays, its value is halved.
    below: f64,
    above: f64,
    /// The end that moved last, if any.
    moved_low: Option<bool>,
}

impl Bracket {
    pub(super) fn new(curves: &Curves, [low, high]: [f64; 2]) -> Self {
        Self {
            low,
            high,
            below: volume(curves, low),
            above: volume(curves, high),
            moved_low: None,
        }
    }

    pub(super) fn contains(&self, time: f64) -> bool {
        self.low < time && time < self.high
    }

    /// The lower end, if the other one is the next f64.
    pub(super) fn settled(&self) -> Option<f64> {
        (self.low.next_up() >= self.high).then_some(self.low)
    }

    /// Takes a time and the value there as an end: as the lower one if the root is above.
    pub(super) fn add(&mut self, time: f64, value: f64, is_below: bool) {
        let is_same = self.moved_low == Some(is_below);
        if is_below {
            [self.low, self.below] = [time, value];
            self.above *= if is_same { 0.5 } else { 1.0 };
        } else {
            [self.high, self.above] = [time, value];
            self.below *= if is_same { 0.5 } else { 1.0 };
        }
        self.moved_low = Some(is_below);
    }

    /// The next time to try, between the ends, if there is an f64: by secants, with the value of an end that
    /// stays halved (Dowell and Jarratt 1971), and in turns the middle.
    pub(super) fn next(&self, step: u32) -> f64 {
        let width = self.high - self.low;
        let time = match step % 4 {
            3 => self.low + 0.5 * width,
            _ => self.low + width * (self.below / (self.below - self.above)),
        };
        time.max(self.low.next_up()).min(self.high.next_down())
    }

    /// A time near the root, by signs that are not certain.
    pub(super) fn guess(&self, curves: &Curves) -> f64 {
        let mut bracket = Self { ..*self };
        let mut time = bracket.next(0);
        for step in 0..GUESSES {
            let value = volume(curves, time);
            if value == 0.0 {
                break;
            }
            bracket.add(
                time,
                value,
                value.is_sign_positive() == self.below.is_sign_positive(),
            );
            if bracket.settled().is_some() {
                break;
            }
            let next = bracket.next(step + 1);
            // Within the noise, the signs are not right.
            if (next - time).abs() <= 4.0 * f64::EPSILON * time {
                return next;
            }
            time = next;
        }
        time
    }

    /// The largest f64 below the root, probably, by a step of Newton's method from a time with a value that
    /// is more precise than f64 is.
    pub(super) fn newton(&self, curves: &Curves, time: f64, value: f64) -> f64 {
        const SMALL: f64 = 1.0 / (1 << 20) as f64;
        let [before, after] = [time - SMALL, time + SMALL];
        let slope = (volume(curves, after) - volume(curves, before)) / (after - before);
        let step = value / slope;
        let next = time - step;
        // Rounded up or down, as the rest of the step says.
        if next - time > -step {
            next.next_down()
        } else {
            next
        }
    }
}

/// c₀ · (c₁ × c₂) of the first three corners at a time, times a positive factor, rounded.
fn volume(curves: &Curves, t: f64) -> f64 {
    let at_time = |corner: usize| -> Point {
        let mut row = curves.corners[corner];
        for count in (1..curves.points.min(MOST)).rev() {
            for k in 0..count {
                row[k] = [0, 1, 2].map(|axis: usize| (1.0 - t) * row[k][axis] + t * row[k + 1][axis]);
            }
        }
        row[0]
    };
    let [a, b, c] = [0, 1, 2].map(at_time);
    dot(a, cross(b, c))
}

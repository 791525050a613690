//! Bisection with the tightest boxes around F.

use std::mem;

use exact_ccd::{Decide, EdgeEdge, Point, Query, VertexFace};

use super::cell::Cell;
use super::gap::{Coordinates, Gap};

/// TI, Tight Inclusion: bisects (t, u, v) breadth-first, and keeps the boxes over which the
/// bounding box of F contains the origin. F is linear in each parameter, so that its values at the
/// corners of a box give the smallest bounds.
///
/// B. Wang, Z. Ferguson, T. Schneider, X. Jiang, M. Attene and D. Panozzo, *A Large-Scale Benchmark
/// and an Inclusion-Based Algorithm for Continuous Collision Detection*, ACM Transactions on
/// Graphics 40(5), 2021. The limit of the queue is taken from their public implementation.
///
/// # When it fails
/// It has no false negatives, and its time is never late. Primitives that come closer than about
/// the tolerance on every axis count as a contact. So do those that the iterations or the queue are
/// too few to exclude: parallel edges that slide along each other at a small distance d stay near
/// over a surface in (t, u, v), and take d⁻² boxes. The bound on rounding errors grows with the
/// cube of the coordinates. It is 7·10⁻⁶ for coordinates of 1,000, and with some of 10⁵ on every
/// axis, all that stays within six units of each other collides at t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TightInclusion {
    /// Boxes over which F varies by less than this on every axis are not divided: 10⁻⁶.
    pub tolerance: f64,
    /// The number of boxes that it tests before it reports contact: 10⁶.
    pub max_iterations: usize,
    /// The length of the queue at which it reports contact: none by default, 1,000 in the public
    /// implementation.
    pub max_queue: Option<usize>,
    /// Primitives that come as near as this on every axis count as a contact.
    pub minimum_separation: f64,
    /// The magnitude that bounds the rounding errors.
    pub magnitude: Magnitude,
}

/// The magnitude of the coordinates, which bounds the rounding errors of F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Magnitude {
    /// The magnitude of the query's coordinates.
    Query,
    /// At most this on each axis, in absolute value. A larger query has its own magnitude.
    Scene(Point),
}

impl Default for TightInclusion {
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            max_iterations: 1_000_000,
            max_queue: None,
            minimum_separation: 0.0,
            magnitude: Magnitude::Query,
        }
    }
}

/// The published bounds on the rounding errors of F for coordinates up to 1.
///
/// They are 60 and 56 times 2⁻⁵³ without a minimum separation. Adding up the error of each operation of
/// [`Coordinates::at`] and [`Gap::gap`] gives 49 and 42, in proportion to the coordinates.
struct Filter {
    touching: f64,
    separated: f64,
}

trait Filtered: Gap {
    const FILTER: Filter;
}

impl Filtered for VertexFace {
    const FILTER: Filter = Filter {
        touching: 6.661338147750939e-15,
        separated: 7.549516567451064e-15,
    };
}

impl Filtered for EdgeEdge {
    const FILTER: Filter = Filter {
        touching: 6.217248937900877e-15,
        separated: 7.105427357601002e-15,
    };
}

/// The number of corners of a box. Bit k of the index of a corner is its end of axis k.
const CORNERS: usize = 8;

/// F at the corners of a box, on one axis of space.
fn corners<K: Gap>(coordinates: &Coordinates<f64>, axis: usize, cell: &Cell<3>) -> [f64; CORNERS] {
    let ends = |axis: usize| [cell.lower[axis], cell.lower[axis] + cell.width[axis]];
    let [t, u, v] = [ends(0), ends(1), ends(2)];
    let points = [coordinates.at(axis, t[0]), coordinates.at(axis, t[1])];
    std::array::from_fn(|corner| K::gap(points[corner & 1], u[corner >> 1 & 1], v[corner >> 2]))
}

/// The least and the greatest of the values that are not NaN.
fn range(values: [f64; CORNERS]) -> [f64; 2] {
    let least = |a, b| if b < a { b } else { a };
    let greatest = |a, b| if b > a { b } else { a };
    [
        values.into_iter().fold(f64::INFINITY, least),
        values.into_iter().fold(f64::NEG_INFINITY, greatest),
    ]
}

/// F over a box.
enum Image {
    /// Never zero.
    Away,
    /// Perhaps zero somewhere: the box must be divided.
    Near,
    /// Zero up to the tolerance, or up to rounding and separation.
    Zero,
}

/// A search for the earliest contact of a query.
struct Search<'a> {
    method: &'a TightInclusion,
    coordinates: Coordinates<f64>,
    /// The largest |F| on each axis that counts as zero.
    zero: [f64; 3],
}

impl<'a> Search<'a> {
    fn new<K: Filtered>(method: &'a TightInclusion, query: &Query<K>) -> Self {
        let separation = method.minimum_separation.max(0.0);
        let filter = if separation > 0.0 {
            K::FILTER.separated
        } else {
            K::FILTER.touching
        };
        let scene = match method.magnitude {
            Magnitude::Query => [1.0; 3],
            Magnitude::Scene(scene) => scene,
        };
        let zero = [0, 1, 2].map(|axis| {
            let coordinates = query
                .points()
                .as_flattened()
                .iter()
                .map(|point| point[axis].abs());
            // At least 1, as in the paper; the public implementation takes at most 1, which is no
            // bound beyond.
            let magnitude = coordinates.fold(scene[axis].max(1.0), f64::max);
            filter * magnitude.powi(3) + separation
        });
        Self {
            method,
            coordinates: Coordinates::new(query.points()),
            zero,
        }
    }

    /// The widths of t, u and v along which F varies by at most a third of the tolerance.
    fn tolerances<K: Gap>(&self) -> [f64; 3] {
        let corners = [0, 1, 2].map(|axis| corners::<K>(&self.coordinates, axis, &Cell::WHOLE));
        [0, 1, 2].map(|axis| {
            let along = |corners: &[f64; CORNERS]| {
                (0..CORNERS)
                    .filter(|corner| corner & 1 << axis == 0)
                    .map(|corner| (corners[corner | 1 << axis] - corners[corner]).abs())
                    .fold(0.0, f64::max)
            };
            let greatest = corners.iter().map(along).fold(0.0, f64::max);
            self.method.tolerance / (3.0 * greatest)
        })
    }

    fn image<K: Gap>(&self, cell: &Cell<3>) -> Image {
        let (mut is_small, mut is_zero) = (true, true);
        for axis in 0..3 {
            let [lower, upper] = range(corners::<K>(&self.coordinates, axis, cell));
            let zero = self.zero[axis];
            if lower > zero || upper < -zero {
                return Image::Away;
            }
            is_small &= upper - lower <= self.method.tolerance;
            is_zero &= lower >= -zero && upper <= zero;
        }
        if is_small || is_zero {
            Image::Zero
        } else {
            Image::Near
        }
    }

    /// A time not after the earliest contact, if there may be one.
    ///
    /// The boxes of a level have the same size and come in the order of time. At a box over which F is zero,
    /// the search leaves the level and notes its time; in later levels, it looks only at boxes that begin
    /// before the noted time. At the limit of iterations, no contact is earlier than the first box of that
    /// level over which F may be zero.
    fn earliest<K: Gap>(&self) -> Option<f64> {
        let tolerances = self.tolerances::<K>();
        let mut iterations = 0;
        let mut found = None;
        let mut level = vec![Cell::WHOLE];
        let (mut next, mut upper_halves) = (Vec::new(), Vec::new());
        while let Some(&Cell { width, .. }) = level.first() {
            // The axis that is widest relative to its tolerance, among the axes that are wider than it.
            let widest = (0..3)
                .filter(|&axis| width[axis] > tolerances[axis].max(Cell::<3>::MIN_WIDTH))
                .max_by(|&a, &b| (width[a] / tolerances[a]).total_cmp(&(width[b] / tolerances[b])));
            let mut first = None;
            for (index, cell) in level.iter().enumerate() {
                if found.is_some_and(|found| cell.time() >= found) {
                    break;
                }
                iterations += 1;
                match self.image::<K>(cell) {
                    Image::Away => {}
                    Image::Near => {
                        let earliest = *first.get_or_insert(cell.time());
                        let queue = level.len() - index + next.len() + upper_halves.len();
                        let Some(axis) = widest.filter(|_| !self.gives_up(iterations, queue)) else {
                            return Some(earliest);
                        };
                        let [lower, upper] = cell.halves(axis);
                        if axis == 0 {
                            next.push(lower);
                            upper_halves.push(upper);
                        } else {
                            next.extend([lower, upper].into_iter().filter(K::meets_domain));
                        }
                    }
                    Image::Zero => {
                        found = Some(cell.time());
                        break;
                    }
                }
            }
            // Each of the two is in order: the sort merges them.
            next.append(&mut upper_halves);
            next.sort_by(|a: &Cell<3>, b| a.time().total_cmp(&b.time()));
            mem::swap(&mut level, &mut next);
            next.clear();
        }
        found
    }

    fn gives_up(&self, iterations: usize, queue: usize) -> bool {
        let TightInclusion {
            max_iterations,
            max_queue,
            ..
        } = *self.method;
        iterations > max_iterations || max_queue.is_some_and(|max_queue| queue > max_queue)
    }
}

impl<K: Filtered> Decide<K> for TightInclusion {
    fn collides(&self, query: &Query<K>) -> bool {
        self.time_of_impact(query).is_some()
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        Search::new(self, query).earliest::<K>()
    }
}

//! Time integration.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::state::State;

/// How accelerations become positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Of first order, and damps motion.
    #[default]
    ImplicitEuler,
    /// The backward differentiation formula of second order, which damps less. Its first step is one of implicit Euler.
    Bdf2,
}

/// One step: v = (x − origin) / duration, and without forces x = predicted.
///
/// Both integrators solve M (x − predicted) = duration² f(x): the minimum of an incremental potential.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The time that forces act, in s: the time step, times 2/3 for BDF2.
    pub(crate) duration: f64,
    /// Where things would be without velocity.
    pub(crate) origin: Vec<Point>,
    /// Where they would be without forces other than gravity.
    pub(crate) predicted: Vec<Point>,
}

impl Integrator {
    /// The next step from a state.
    pub(crate) fn scheme(self, state: &State, time_step: f64, gravity: Point) -> Scheme {
        let earlier = state.earlier.as_ref().filter(|_| self == Self::Bdf2);
        let (duration, origin, drift) = match earlier {
            None => (time_step, state.positions.clone(), state.velocities.clone()),
            Some(earlier) => (
                time_step * 2.0 / 3.0,
                extrapolated(&state.positions, &earlier.positions),
                extrapolated(&state.velocities, &earlier.velocities),
            ),
        };
        let ahead = |(x, v): (&Point, &Point)| {
            core::array::from_fn(|axis| x[axis] + duration * (v[axis] + duration * gravity[axis]))
        };
        let predicted = origin.iter().zip(&drift).map(ahead).collect();
        Scheme {
            duration,
            origin,
            predicted,
        }
    }
}

impl Scheme {
    /// The velocities with which the step ends at some positions.
    pub(crate) fn velocities(&self, positions: &[Point]) -> Vec<Point> {
        let velocity = |(x, origin): (&Point, &Point)| {
            core::array::from_fn(|axis| (x[axis] - origin[axis]) / self.duration)
        };
        positions.iter().zip(&self.origin).map(velocity).collect()
    }
}

/// (4 now − earlier) / 3.
fn extrapolated(now: &[Point], earlier: &[Point]) -> Vec<Point> {
    let pairs = now.iter().zip(earlier);
    pairs
        .map(|(now, earlier)| core::array::from_fn(|axis| now[axis] + (now[axis] - earlier[axis]) / 3.0))
        .collect()
}

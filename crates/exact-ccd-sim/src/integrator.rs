//! Time integration.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::state::State;

/// The time integration method.
///
/// Neither method conserves energy. In smooth motion both dissipate it numerically, the more so the larger
/// the time step. The order of BDF2 holds for smooth motion only: with contact, its energy jumps between
/// the bounces of a body. [`Energies::friction`](crate::Energies::friction) does not include numerical
/// dissipation; no other energy does either.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Implicit Euler: first order, with strong numerical damping. Falling bodies hardly bounce.
    #[default]
    ImplicitEuler,
    /// The backward differentiation formula of second order, with less numerical damping. The first step
    /// of a simulation is one of implicit Euler.
    Bdf2,
    /// Implicit Euler from rest: each time step drops all velocities. With time steps that are long against
    /// the periods of a body, each step ends near its equilibrium. The body must be held, by scripts or by
    /// contact: a free one falls by the time step squared.
    QuasiStatic,
}

/// The equations of one time step: v = (x − origin) / duration, and x = predicted in the absence of forces.
///
/// Both integrators solve M (x − predicted) = duration² f(x), which is stationarity of an incremental
/// potential.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The effective time step, in s: the time step for implicit Euler, two thirds of it for BDF2.
    pub(crate) duration: f64,
    /// The positions at zero velocity.
    pub(crate) origin: Vec<Point>,
    /// The positions x̂ under inertia and gravity alone.
    pub(crate) predicted: Vec<Point>,
}

/// The accelerations of a time step that do not depend on its end.
pub(crate) struct Acceleration<'a> {
    /// That of gravity, in m/s².
    pub(crate) gravity: Point,
    /// Those of the vertices by loads, in m/s².
    pub(crate) loads: Option<&'a [Vector3<f64>]>,
    /// The rate at which velocities decay, in 1/s.
    pub(crate) damping: f64,
}

impl Integrator {
    /// The equations of the next time step.
    pub(crate) fn scheme(
        self,
        state: &State,
        time_step: f64,
        Acceleration {
            gravity,
            loads,
            damping,
        }: &Acceleration<'_>,
    ) -> Scheme {
        let earlier = state.earlier.as_ref().filter(|_| self == Self::Bdf2);
        let (duration, origin, drift) = match earlier {
            None => (time_step, state.positions.clone(), state.velocities.clone()),
            Some(earlier) => (
                time_step * 2.0 / 3.0,
                extrapolated(&state.positions, &earlier.positions),
                extrapolated(&state.velocities, &earlier.velocities),
            ),
        };
        // The velocity that is left, with the damping at the end of the step.
        let left = match self {
            Self::ImplicitEuler | Self::Bdf2 => (1.0 + duration * damping).recip(),
            Self::QuasiStatic => 0.0,
        };
        let ahead = |(vertex, (x, v)): (usize, (&Point, &Point))| {
            let load = loads.map_or([0.0; 3], |loads| loads[vertex].into());
            core::array::from_fn(|axis| {
                x[axis] + duration * (left * v[axis] + duration * (gravity[axis] + load[axis]))
            })
        };
        let predicted = origin.iter().zip(&drift).enumerate().map(ahead).collect();
        Scheme {
            duration,
            origin,
            predicted,
        }
    }
}

impl Scheme {
    /// The velocities at the end of the step, if it ends at these positions.
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

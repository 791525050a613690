//! Time integration.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::energies::anchor::Anchor;
use crate::prescribed::Axes;
use crate::state::State;

/// The time integration method.
///
/// Neither method conserves energy. In smooth motion both dissipate it numerically, the more so the larger
/// the time step. The angular velocity ω of a free body decays under implicit Euler, by dω/dt ≈ −ω³ h for
/// the time step h. The order of BDF2 holds for smooth motion only: a time step in which bodies begin or
/// cease to touch, and the next one, are steps of implicit Euler.
/// [`Energies::friction`](crate::Energies::friction) does not include numerical dissipation; no other energy
/// does either.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Implicit Euler: first order, with strong numerical damping. Falling bodies hardly bounce.
    #[default]
    ImplicitEuler,
    /// The backward differentiation formula of second order, with less numerical damping. The first step
    /// of a simulation is one of implicit Euler.
    Bdf2,
    /// Equilibria: each time step ends where all forces balance, whatever its duration. A body that nothing
    /// holds falls until it rests on others; one that falls without end does not converge.
    QuasiStatic,
}

/// The duration in s of a step from rest that ends in equilibrium. Without any inertia, the system would be
/// singular for a body that nothing holds. The inertia of a step of this duration changes an equilibrium by
/// 1 / (ω · 100 s)² of its displacement, for the least angular frequency ω of the body.
const LONG: f64 = 100.0;

/// The equations of one time step: v = (x − origin) / duration, and the inertia of each vertex.
///
/// Both integrators solve M (v − v₀) / duration = f(x) − α M v, with the velocity v₀ after a step without
/// forces and the rate of damping α. With v = (x − origin) / duration, this is
/// (1 + α duration) M (x − predicted) = duration² f(x) with predicted = origin + duration v₀ / (1 + α
/// duration): stationarity of an incremental potential.
#[derive(Clone, Debug)]
pub(crate) struct Scheme {
    /// The effective time step, in s: the time step for implicit Euler, two thirds of it for BDF2.
    pub(crate) duration: f64,
    /// The positions at zero velocity.
    pub(crate) origin: Vec<Point>,
    /// The positions in the absence of forces.
    predicted: Vec<Point>,
    /// The factor of the masses: 1 + α duration, or (duration / [`LONG`])² for equilibria.
    pub(crate) inertia: f64,
}

impl Integrator {
    /// The equations of the next time step, with the rate `damping` at which velocities decay, in 1/s.
    pub(crate) fn scheme(self, state: &State, time_step: f64, damping: f64) -> Scheme {
        let earlier = state.earlier.as_ref().filter(|_| self == Self::Bdf2);
        let (duration, origin, drift) = match earlier {
            None => (time_step, state.positions.clone(), state.velocities.clone()),
            Some(earlier) => (
                time_step * 2.0 / 3.0,
                extrapolated(&state.positions, &earlier.positions),
                extrapolated(&state.velocities, &earlier.velocities),
            ),
        };
        let (inertia, left) = match self {
            Self::ImplicitEuler | Self::Bdf2 => {
                let inertia = 1.0 + duration * damping;
                (inertia, duration / inertia)
            }
            Self::QuasiStatic => ((duration / LONG).min(1.0).powi(2), 0.0),
        };
        let ahead = |(x, v): (&Point, &Point)| core::array::from_fn(|axis| x[axis] + left * v[axis]);
        let predicted = origin.iter().zip(&drift).map(ahead).collect();
        Scheme {
            duration,
            origin,
            predicted,
            inertia,
        }
    }
}

impl Scheme {
    /// The inertia of the vertices with a free coordinate, and the constant accelerations on them in m/s². It
    /// acts on the held coordinates of these vertices too, where it is a constant.
    pub(crate) fn inertia(
        &self,
        masses: &[f64],
        held: &[Axes],
        accelerations: impl Fn(usize) -> Vector3<f64>,
    ) -> Vec<Anchor> {
        let free = (0..masses.len()).filter(|&vertex| held[vertex] != [true; 3]);
        let anchor = |vertex: usize| Anchor {
            vertex: vertex as u32,
            target: self.predicted[vertex],
            stiffness: Vector3::repeat(self.inertia * masses[vertex]),
            force: accelerations(vertex) * (masses[vertex] * self.duration * self.duration),
        };
        free.map(anchor).collect()
    }

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

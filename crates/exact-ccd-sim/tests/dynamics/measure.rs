//! Sums over all vertices.

use exact_ccd_sim::Simulation;
use nalgebra::Vector3;

fn vertices(simulation: &Simulation) -> impl Iterator<Item = (f64, Vector3<f64>, Vector3<f64>)> + '_ {
    let (masses, state) = (simulation.system().masses(), simulation.state());
    let moving = state.positions.iter().zip(&state.velocities);
    masses
        .iter()
        .zip(moving)
        .map(|(&m, (x, v))| (m, Vector3::from(*x), Vector3::from(*v)))
}

/// Σ m v, in kg m/s.
pub(crate) fn momentum(simulation: &Simulation) -> Vector3<f64> {
    vertices(simulation).map(|(m, _, v)| v * m).sum()
}

/// Σ m x × v, in kg m²/s.
pub(crate) fn angular_momentum(simulation: &Simulation) -> Vector3<f64> {
    vertices(simulation).map(|(m, x, v)| x.cross(&v) * m).sum()
}

/// The center of mass Σ m x / Σ m, in m.
pub(crate) fn center(simulation: &Simulation) -> Vector3<f64> {
    let (mass, moment) = vertices(simulation).fold((0.0, Vector3::zeros()), |(mass, moment), (m, x, _)| {
        (mass + m, moment + x * m)
    });
    moment / mass
}

/// True if the straight motion from earlier positions to the current ones is free of contact.
pub(crate) fn is_free_since(simulation: &Simulation, before: &[exact_ccd_mesh::Point]) -> bool {
    let after = &simulation.state().positions;
    exact_ccd_mesh::step(simulation.system().surface(), before, after)
        .unwrap()
        .is_free()
}

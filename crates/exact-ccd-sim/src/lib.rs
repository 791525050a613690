//! Elastodynamics without intersections: incremental potential contact (IPC), with a line search
//! that is filtered by [`exact_ccd`].
//!
//! The method is due to M. Li, Z. Ferguson, T. Schneider, T. Langlois, D. Zorin, D. Panozzo, C. Jiang,
//! D. Kaufman, *Incremental Potential Contact: Intersection- and Inversion-free Large-Deformation
//! Dynamics*, ACM Transactions on Graphics 39(4), 2020. Each time step minimises the sum of an inertia
//! term, elasticity, a barrier over the distances of nearby primitives and lagged friction, by projected
//! Newton. A [`StepFilter`] bounds each Newton step: by the exact
//! method or, for comparison, by any other [`Ccd`](exact_ccd::Ccd).
//!
//! - A [`Body`] is a mesh with its material. Bodies and [`ScriptedVertices`] form a [`System`]. A system
//!   has the vertices of its bodies, one body after the other ([`System::ranges`]).
//! - A [`Simulation`] takes the time steps of a system. Each step returns [`Statistics`].
//! - A [`Checkpoint`] is saved and loaded to resume a simulation of the same system and settings.
//!
//! See [`Integrator`] for what the integrators conserve, and [`BodyKind`] for the limits of the elements.
//!
//! ```
//! use exact_ccd_sim::{Settings, Simulation, System, shapes};
//!
//! let cube = shapes::solid_box([2, 2, 2], [0.3; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.01, z + 0.3]);
//! let system = System::new(&[cube, shapes::floor([1, 1], [1.0, 1.0])], &[])?;
//! let mut simulation = Simulation::new(system, Settings::default())?;
//! for _ in 0..5 {
//!     let statistics = simulation.step()?;
//!     assert!(statistics.converged);
//! }
//! // The lowest corner of the cube has fallen, and is still above the floor.
//! let corner = simulation.state().positions[0];
//! assert!(0.0 < corner[1] && corner[1] < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lengths are in m, masses in kg, times in s. No result depends on the number of threads. Results may
//! differ between processors, because the sparse solver selects vector instructions at run time.

mod body;
mod carriers;
mod checkpoint;
mod digest;
mod energies;
mod error;
mod filter;
mod half_space;
mod integrator;
mod iteration;
mod moments;
mod prescribed;
mod range;
mod settings;
pub mod shapes;
mod simulation;
mod solver;
mod state;
mod statistics;
mod system;
#[cfg(test)]
mod tests;

pub use body::{
    AffineProperties, Body, BodyKind, ParticleProperties, Region, RodProperties, ShellProperties,
    SolidProperties,
};
pub use checkpoint::Checkpoint;
pub use energies::elasticity::SolidMaterial;
pub use energies::load::{Force, Load};
pub use energies::spring::{Spring, SpringEnd};
pub use error::SimulationError;
pub use filter::StepFilter;
pub use half_space::HalfSpace;
pub use integrator::Integrator;
pub use iteration::Iteration;
pub use prescribed::{KeyFrame, Script, ScriptedVertices};
pub use range::OutOfRange;
pub use settings::{Formulation, Friction, FrictionPair, Length, LineSearch, Settings};
pub use simulation::{Contact, Simulation, Warning};
pub use state::{Earlier, State};
pub use statistics::{Energies, Seconds, Statistics};
pub use system::{
    BodyError, BodyPrimitive, Designation, Fingerprint, Primitive, Selecting, SpringError, System,
    SystemError,
};

/// The example of the README, as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

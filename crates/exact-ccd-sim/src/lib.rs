//! Elastodynamics with contact that never passes through itself: incremental potential contact, with the line search filtered by
//! [`exact_ccd`].
//!
//! The method is that of M. Li, Z. Ferguson, T. Schneider, T. Langlois, D. Zorin, D. Panozzo, C. Jiang, D. Kaufman,
//! *Incremental Potential Contact: Intersection- and Inversion-free Large-Deformation Dynamics*, ACM Transactions on Graphics
//! 39(4), 2020. Each time step minimises a potential of inertia, [`elasticity`], a barrier between what is near
//! ([`contact`], [`distance`]) and lagged [`friction`], by projected Newton. How far each Newton step may go, a [`filter`]
//! says: the exact one, or any method of [`exact_ccd_methods`], to see what these let through.
//!
//! - [`Body`] is a mesh with its material; bodies and [`Script`]s make a [`System`], whose vertices are those of its bodies, one
//!   body after the other ([`System::ranges`]).
//! - [`Simulation`] takes the steps of a system, each with [`Statistics`].
//! - [`Checkpoint`] is what it needs, with the same system and settings, to go on after it has been written and read.
//! - [`scene`] reads all of this from a file.
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
//! // The corner at the lowest coordinates has come down, and is above the floor.
//! let corner = simulation.state().positions[0];
//! assert!(0.0 < corner[1] && corner[1] < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lengths are in m, masses in kg, times in s. No result depends on the number of threads. It
//! may depend on the processor: the sparse solver chooses vector instructions when it runs.

mod body;
mod checkpoint;
pub mod contact;
pub mod distance;
mod drive;
pub mod elasticity;
mod element;
pub mod filter;
pub mod friction;
mod gather;
mod hinges;
mod integrator;
pub mod psd;
pub mod scene;
mod script;
mod settings;
pub mod shapes;
mod simulation;
mod solver;
mod state;
mod statistics;
mod system;

pub use body::{Body, BodyKind, ShellProperties, SolidProperties};
pub use checkpoint::Checkpoint;
pub use element::{Element, Matrix12, Vector12};
pub use integrator::Integrator;
pub use script::{Script, ScriptError};
pub use settings::{Friction, Length, SettingError, Settings};
pub use simulation::{Primitive, Simulation, SimulationError};
pub use state::{Earlier, State};
pub use statistics::{Energies, Seconds, Statistics};
pub use system::{Fingerprint, System, SystemError};

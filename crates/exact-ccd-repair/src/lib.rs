//! Repair of a mesh that intersects itself: positions near the given ones in which it does not, decided
//! exactly.
//!
//! [`repair`] keeps vertices, edges and faces, and moves vertices in three phases (`docs/repair.md`):
//!
//! 1. *Loosen*: along the smoothed gradient of the length of the curves in which the mesh intersects itself
//!    (Volino and Magnenat-Thalmann 2006), until no edge passes through a face and no pair touches.
//! 2. *Separate*: apart, until no pair is within the minimum distance, if there is one.
//! 3. *Return*: towards the given positions and the given shape, as far as it goes. Each step is certified to
//!    be free of contact, so that nothing intersects any more.
//!
//! ```
//! use std::sync::Arc;
//!
//! use exact_ccd_mesh::TriangleMesh;
//! use exact_ccd_repair::{Outcome, RepairOptions, repair};
//!
//! // The tip of the second triangle passes through the first one.
//! let mesh = Arc::new(TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?);
//! let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
//! let x = [floor, [[2.0, 2.0, -0.5], [2.0, 1.0, 4.0], [1.0, 2.0, 4.0]]].concat();
//!
//! let options = RepairOptions::default().with_pinned(vec![0, 1, 2]);
//! let Outcome::Repaired(repaired) = repair(&mesh, &x, &options)? else {
//!     panic!("the triangle is free to move")
//! };
//! assert_eq!(repaired.crossings, 2);
//! assert_eq!(repaired.positions[..3], floor);
//! assert!(repaired.positions[3][2] > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The result is a function of the mesh, the positions and the options: it does not depend on the number of
//! threads. It is not promised to be the same on other machines, as the answers of collision detection are.

mod change;
mod closeness;
mod closest;
mod contour;
mod error;
mod faces;
mod linked;
mod loosen;
mod near;
mod offsets;
mod one_sided;
mod options;
mod outcome;
mod problem;
mod progress;
mod recording;
mod repair;
mod restore;
mod rods;
mod separate;
mod shape;
mod single;
mod size;
mod slide;
mod system;

pub use change::Change;
pub use error::RepairError;
pub use options::RepairOptions;
pub use outcome::{Outcome, Reason, Repaired, Unrepaired};
pub use progress::{Phase, Progress};
pub use recording::{Blocked, Recording, repair_recording};
pub use repair::repair;
pub use single::repair_in_f32;

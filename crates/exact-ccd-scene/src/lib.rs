//! Scene files in TOML, and imports of the scenes of other programs.
//!
//! [`Scene::read`] makes a [`System`](exact_ccd_sim::System) and its settings from a file. [`import`] makes such
//! a file from a scene of IPC or of PolyFEM.
//!
//! ```
//! use std::path::Path;
//! use exact_ccd_sim::StepFilter;
//! use exact_ccd_scene::Scene;
//!
//! let text = r#"
//!     duration = 0.5
//!
//!     [settings]
//!     time-step = 0.02
//!     contact-distance = { absolute = 1e-3 }
//!     ccd = "exact"
//!
//!     [[body]]
//!     shape = { box = { cells = [1, 1, 1], size = [0.5, 0.5, 0.5] } }
//!     solid = { density = 1000.0, young = 1e6, poisson = 0.4 }
//!     translate = [0.2, 0.1, 0.2]
//!
//!     [[body]] # A body without a material is an obstacle.
//!     shape = { grid = { cells = [1, 1], size = [1.0, 1.0] } }
//! "#;
//! let scene = Scene::parse(text, Path::new("fall.toml"), None, &|_, _| Ok(StepFilter::default()))?;
//! assert_eq!(scene.steps, 25);
//! let mut simulation = scene.simulation()?;
//! simulation.step()?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod body;
mod description;
mod document;
mod group;
mod half_spaces;
mod import;
mod load;
mod locate;
mod mesh;
mod parse;
mod placement;
mod rendering;
mod selection;

pub use document::SceneError;
pub use import::{ImportError, Imported, Note, Place, Problem, import};
pub use load::{FilterByName, Scene};
pub use rendering::{Rendering, Subject};

/// The example of the README, as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

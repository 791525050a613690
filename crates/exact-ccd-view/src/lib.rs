//! Moving triangle meshes and their contacts as one HTML file, which a browser opens from disk.
//!
//! A [`Page`] is a mesh, its frames, and the contacts in the steps between them. The file has all of
//! it, with the program that draws it (`viewer/` in the repository); it loads nothing else.
//!
//! ```
//! use exact_ccd::{Kind, CONTACT};
//! use exact_ccd_mesh::{Bvh, Candidates, Step, TriangleMesh};
//! use exact_ccd_view::Page;
//!
//! let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?; // vertex 3 is a point
//! let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
//! let x1 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, -1.0]];
//! let step = Step::new(&mesh, &x0, &x1)?;
//! let contacts = Candidates::new(step, &Bvh).collisions(step, CONTACT);
//!
//! let mut file = Vec::new();
//! Page::of_step("A point falls", step, &[], &contacts)?.write(&mut file)?;
//! assert!(file.starts_with(b"<!doctype html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Positions in the file are single-precision numbers, relative to the middle of the mesh: they are
//! for the eye. Times, points, normals and parameters of contacts, and the points of a query, are
//! the f64 of the answer.

mod block;
mod body;
mod contact;
mod document;
mod error;
mod half_space;
mod history;
mod page;
mod query;
mod units;

pub use body::Body;
pub use error::PageError;
pub use history::{Chart, Curve, History};
pub use page::{MOST_CONTACTS, Page};

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

//! Pictures of triangle meshes, without a window or a graphics card: a small rasteriser with a
//! depth buffer.
//!
//! ```no_run
//! use std::fs::File;
//!
//! use exact_ccd_files::read_frame;
//! use exact_ccd_render::{Marks, View, render, write_apng};
//!
//! let frames = [read_frame("0.ply")?, read_frame("1.ply")?];
//! let view = View::of(&frames[0].bounds(), [1.0, -2.0, 1.0], [640, 480]);
//! let pictures: Vec<_> = frames.iter().map(|frame| render(frame, &view, &Marks::default())).collect();
//! write_apng(File::create("motion.png")?, &pictures, 0.04)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same frame gives the same picture on every machine: the only operations are + − × ÷ and √.

mod animation;
mod canvas;
mod encoder;
mod gif;
mod marks;
mod picture;
mod scene;
mod text;
mod view;

pub use animation::{Animation, write_apng};
pub use gif::Gif;
pub use marks::Marks;
pub use picture::Picture;
pub use scene::{render, render_thick};
pub use view::{Camera, View};

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

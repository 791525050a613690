#![doc = include_str!("../README.md")]

mod body;
pub mod description;
mod document;
mod field_error;
mod load;
mod locate;
mod mesh;
mod parse;
mod rendering;
mod springs;

pub use document::SceneError;
pub use load::{FilterByName, Scene};
pub use mesh::Mesh;
pub use rendering::{Rendering, Subject};

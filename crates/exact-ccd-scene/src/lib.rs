#![doc = include_str!("../README.md")]

mod body;
mod description;
mod document;
mod field_error;
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
mod springs;

pub use document::SceneError;
pub use import::{ImportError, Imported, Note, Place, Problem, import};
pub use load::{FilterByName, Scene};
pub use rendering::{Rendering, Subject};

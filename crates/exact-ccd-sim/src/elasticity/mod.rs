//! Elastic energies: solids of tetrahedra, shells of triangles.

mod elastic;
mod hinge;
mod isotropic;
mod lame;
mod membrane;
mod neo_hookean;
mod stable_neo_hookean;
mod tetrahedron;

pub(crate) use elastic::Elastic;
pub use hinge::Hinge;
pub use isotropic::{Curvature, Isotropic, Principal};
pub use lame::{ElasticModuli, ModuliError};
pub use membrane::Membrane;
pub use neo_hookean::NeoHookean;
pub use stable_neo_hookean::StableNeoHookean;
pub use tetrahedron::{SolidMaterial, Tetrahedron};

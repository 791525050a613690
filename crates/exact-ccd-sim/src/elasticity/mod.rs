//! Elastic energies: solids of tetrahedra, shells of triangles, rods of edges.
//!
//! Solids use linear tetrahedra, which lock in bending: a beam that is one cell thick deflects by about a
//! quarter of the deflection of beam theory. Meshes with more cells across the thickness are less stiff.
//! Nearly incompressible materials (Poisson's ratio near ½) lock in volume as well.

mod bend;
mod elastic;
mod hinge;
mod isotropic;
mod lame;
mod membrane;
mod neo_hookean;
mod stable_neo_hookean;
mod stretch;
mod tetrahedron;
mod vertex_bend;

pub use bend::Bend;
pub(crate) use elastic::Elastic;
pub use hinge::Hinge;
pub use lame::ElasticModuli;
pub use membrane::Membrane;
pub use stretch::Stretch;
pub use tetrahedron::{SolidMaterial, Tetrahedron};
pub(crate) use vertex_bend::{VertexBend, bending};

//! Elastic energies: solids of tetrahedra, shells of triangles, rods of edges.

mod chain;
mod fixed_corotated;
mod hinge;
mod interior_edges;
mod isotropic;
mod lame;
mod membrane;
mod neo_hookean;
mod rod_bend;
mod rod_topology;
mod saint_venant_kirchhoff;
mod singular_values;
mod solid_material;
mod stable_neo_hookean;
mod star;
mod strain_limit;
mod stretch;
mod tetrahedron;
mod twist;
mod vertex_bend;

pub(crate) use chain::Chain;
#[cfg(test)]
pub(crate) use hinge::Hinge;
pub(crate) use lame::ElasticModuli;
pub(crate) use membrane::Membrane;
pub(crate) use rod_bend::RodBend;
pub(crate) use rod_topology::{bending_vertices, paths_between_ends};
pub(crate) use saint_venant_kirchhoff::SaintVenantKirchhoff;
pub use solid_material::SolidMaterial;
pub(crate) use star::{bending, incomplete_part};
pub(crate) use strain_limit::StrainLimit;
pub(crate) use stretch::Stretch;
pub(crate) use tetrahedron::Tetrahedron;
pub(crate) use twist::{Twist, angle_about, transported};

//! The list of the energies of solids.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::fixed_corotated::FixedCorotated;
use super::lame::ElasticModuli;
use super::neo_hookean::NeoHookean;
use super::saint_venant_kirchhoff::SaintVenantKirchhoff;
use super::stable_neo_hookean::StableNeoHookean;
use super::tetrahedron::Tetrahedron;
use crate::energies::term::Energy;

/// The hyperelastic energy of a solid. A new one is the last: fingerprints of checkpoints have the number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolidMaterial {
    /// Ψ = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln² J with J = det F (J. Bonet, R. D. Wood, *Nonlinear Continuum
    /// Mechanics for Finite Element Analysis*): infinite for inverted elements, so that no element inverts.
    #[default]
    NeoHookean,
    /// The stable neo-Hookean energy (B. Smith, F. de Goes, T. Kim, 2018): finite for every deformation.
    /// Elements can invert.
    StableNeoHookean,
    /// Ψ = μ tr E² + λ/2 tr² E with the strain E = (FᵀF − 1)/2. It is weak under compression: below a
    /// stretch of 1/√3, a bar yields. Elements can invert.
    SaintVenantKirchhoff,
    /// Ψ = μ |F − R|² + λ/2 (J − 1)² with the rotation R nearest to F (A. Stomakhin, R. Howes, C.
    /// Schroeder, J. Teran, 2012): linear in the stretches. Elements can invert.
    FixedCorotated,
}

impl SolidMaterial {
    /// All energies, for tests.
    #[cfg(test)]
    pub(crate) const ALL: [Self; 4] = [
        Self::NeoHookean,
        Self::StableNeoHookean,
        Self::SaintVenantKirchhoff,
        Self::FixedCorotated,
    ];

    /// The energy of a tetrahedron.
    pub(crate) fn energy(self, element: Tetrahedron<()>, moduli: ElasticModuli) -> Arc<dyn Energy> {
        match self {
            Self::NeoHookean => Arc::new(element.of(NeoHookean(moduli.lame()))),
            Self::StableNeoHookean => Arc::new(element.of(StableNeoHookean::new(moduli))),
            Self::SaintVenantKirchhoff => Arc::new(element.of(SaintVenantKirchhoff(moduli.lame()))),
            Self::FixedCorotated => Arc::new(element.of(FixedCorotated(moduli.lame()))),
        }
    }
}

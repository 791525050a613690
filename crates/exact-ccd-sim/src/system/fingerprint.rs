//! Fingerprints of systems.

use std::fmt::{self, Debug, Write};

use serde::{Deserialize, Serialize};

use super::System;

/// Hashes of the parts of a [`System`], of 64 bits: against accidental differences, not against forgery.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    /// The hash of the initial positions.
    positions: String,
    /// The hash of the initial velocities.
    velocities: String,
    /// The hash of the corners of faces, edges and tetrahedra.
    elements: String,
    /// The hash of masses, stiffnesses and offsets.
    materials: String,
    /// The hash of the scripts.
    scripts: String,
    /// The hash of the half spaces.
    half_spaces: String,
    /// The hash of the loads.
    loads: String,
}

impl Fingerprint {
    pub(super) fn of(system: &System) -> Self {
        let tetrahedra: Vec<[u32; 4]> = system.tetrahedra().collect();
        Self {
            positions: hash(&system.start),
            velocities: hash(&system.velocities),
            elements: hash(&(system.surface(), tetrahedra)),
            materials: hash(&(&system.masses, &system.elements, &system.bends, &system.offsets)),
            scripts: hash(&system.scripts),
            half_spaces: hash(&system.half_spaces),
            loads: hash(&system.loads),
        }
    }

    /// The first part in which two systems differ.
    pub(crate) fn difference(&self, other: &Self) -> Option<&'static str> {
        let parts = [
            ("positions", &self.positions, &other.positions),
            ("elements", &self.elements, &other.elements),
            ("velocities", &self.velocities, &other.velocities),
            ("materials", &self.materials, &other.materials),
            ("scripts", &self.scripts, &other.scripts),
            ("half spaces", &self.half_spaces, &other.half_spaces),
            ("loads", &self.loads, &other.loads),
        ];
        let different = parts.into_iter().find(|(_, a, b)| a != b);
        different.map(|(name, ..)| name)
    }
}

/// The hash of the `Debug` text of a value, in which numbers are exact. The text contains the names of types
/// and fields: a renamed field of an element or a script makes earlier checkpoints unusable.
fn hash(value: &impl Debug) -> String {
    let mut hash = Fnv1a(0xcbf2_9ce4_8422_2325);
    // `write_str` below does not fail.
    let _ = write!(hash, "{value:?}");
    format!("{:016x}", hash.0)
}

/// The hash function FNV-1a with 64 bits: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, T. Hansen, *The FNV
/// Non-Cryptographic Hash Algorithm*.
struct Fnv1a(u64);

impl Write for Fnv1a {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        Ok(())
    }
}

//! What a scene file says.

use std::path::PathBuf;

use exact_ccd_mesh::Point;
use serde::Deserialize;

use super::placement::{Rotation, Scale};
use crate::body::{ShellProperties, SolidProperties};
use crate::script::Script;
use crate::settings::Settings;

/// A scene.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct Description {
    /// How long to simulate, in s.
    pub(super) duration: f64,
    /// The numbers of the simulation.
    #[serde(default)]
    pub(super) settings: Settings,
    /// The bodies, `[[body]]`.
    #[serde(default)]
    pub(super) body: Vec<BodyDescription>,
}

/// A body. With neither `solid` nor `shell`, it is an obstacle.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct BodyDescription {
    /// A mesh file: of tetrahedra (.msh) for a solid, else any that [`exact_ccd_files::read_frame`] reads, or the surface of
    /// tetrahedra.
    pub(super) mesh: Option<PathBuf>,
    /// A shape instead of a file.
    pub(super) shape: Option<Shape>,
    /// The material of a solid.
    pub(super) solid: Option<SolidProperties>,
    /// The material of a shell.
    pub(super) shell: Option<ShellProperties>,
    /// How it is scaled first, about the origin.
    #[serde(default)]
    pub(super) scale: Scale,
    /// How it is rotated then, about the origin.
    pub(super) rotate: Option<Rotation>,
    /// How far it is translated then, in m.
    #[serde(default)]
    pub(super) translate: Point,
    /// The velocity at the start, in m/s.
    #[serde(default)]
    pub(super) velocity: Point,
    /// How vertices of it move, `[[body.script]]`; of several for one vertex, the last.
    #[serde(default)]
    pub(super) script: Vec<ScriptDescription>,
}

/// A generated mesh.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) enum Shape {
    /// [`shapes::solid_box`](crate::shapes::solid_box).
    Box {
        /// How many cubes there are along each axis.
        cells: [u8; 3],
        /// The lengths of the sides, in m.
        size: Point,
    },
    /// [`shapes::cloth`](crate::shapes::cloth).
    Grid {
        /// How many rectangles there are along x and z.
        cells: [u16; 2],
        /// The lengths of the sides, in m.
        size: [f64; 2],
    },
    /// [`shapes::sphere`](crate::shapes::sphere).
    Sphere {
        /// How often each triangle of an icosahedron is cut into four.
        subdivisions: u8,
        /// The radius, in m.
        radius: f64,
    },
}

/// Some vertices, and how they move.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct ScriptDescription {
    /// Which vertices of the body.
    #[serde(default)]
    pub(super) vertices: Selection,
    /// How they move.
    pub(super) motion: Script,
}

/// Some vertices of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) enum Selection {
    /// All.
    #[default]
    All,
    /// Those in a box, after the body has been placed.
    Box {
        /// The least coordinates, in m.
        lower: Point,
        /// The greatest coordinates, in m.
        upper: Point,
    },
}

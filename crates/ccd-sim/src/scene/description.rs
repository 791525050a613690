//! What a scene file says.

use std::path::PathBuf;

use ccd_mesh::Point;
use serde::Deserialize;

use super::placement::{Rotation, Scale};
use crate::body::{ShellProperties, SolidProperties};
use crate::script::Script;
use crate::settings::Settings;

/// A scene.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Description {
    /// How long to simulate, in s.
    pub duration: f64,
    /// The numbers of the simulation.
    #[serde(default)]
    pub settings: Settings,
    /// The bodies, `[[body]]`.
    #[serde(default)]
    pub body: Vec<BodyDescription>,
}

/// A body. With neither `solid` nor `shell`, it is an obstacle.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct BodyDescription {
    /// A mesh file: of tetrahedra (.msh) for a solid, else any that [`ccd_mesh::Frame::read`] reads, or the surface of
    /// tetrahedra.
    pub mesh: Option<PathBuf>,
    /// A shape instead of a file.
    pub shape: Option<Shape>,
    /// The material of a solid.
    pub solid: Option<SolidProperties>,
    /// The material of a shell.
    pub shell: Option<ShellProperties>,
    /// How it is scaled first, about the origin.
    #[serde(default)]
    pub scale: Scale,
    /// How it is rotated then, about the origin.
    pub rotate: Option<Rotation>,
    /// How far it is translated then, in m.
    #[serde(default)]
    pub translate: Point,
    /// The velocity at the start, in m/s.
    #[serde(default)]
    pub velocity: Point,
    /// How vertices of it move, `[[body.script]]`; of several for one vertex, the last.
    #[serde(default)]
    pub script: Vec<ScriptDescription>,
}

/// A generated mesh.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Shape {
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
pub struct ScriptDescription {
    /// Which vertices of the body.
    #[serde(default)]
    pub vertices: Selection,
    /// How they move.
    pub motion: Script,
}

/// Some vertices of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Selection {
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

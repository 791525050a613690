//! The contents of a scene file.

mod group;
mod half_spaces;
mod placement;
mod selection;

use std::path::PathBuf;

use exact_ccd_mesh::{HalfSpace, Point};
use serde::{Deserialize, Serialize};

use crate::rendering::Rendering;
use exact_ccd_sim::{
    AffineProperties, Force, ParticleProperties, RodProperties, Script, Settings, ShellProperties,
    SolidProperties,
};
pub use group::GroupKey;
pub use placement::{Placement, Rotation, Scale};

/// A scene.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Description {
    /// The simulated time, in s. Required: the check comes after parsing, so that its error is located at
    /// the file and not at whichever table comes first.
    pub duration: Option<f64>,
    /// The settings of the simulation.
    #[serde(default)]
    pub settings: Settings,
    /// The bodies, `[[body]]`.
    #[serde(default)]
    pub body: Vec<BodyDescription>,
    /// The half spaces, `[[half-space]]`.
    #[serde(default, with = "half_spaces", skip_serializing_if = "Vec::is_empty")]
    pub half_space: Vec<HalfSpace>,
    /// The springs, `[[spring]]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub spring: Vec<SpringDescription>,
    /// The settings of the pictures.
    #[serde(default, skip_serializing_if = "is_default")]
    pub render: Rendering,
}

/// A body. Without a material, it is an obstacle.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct BodyDescription {
    /// The name, which several bodies may share.
    #[serde(default, skip_serializing_if = "is_default")]
    pub name: String,
    /// A mesh file. Solids need tetrahedra (.msh). All other bodies accept any file that
    /// [`exact_ccd_files::read_frame`] accepts, and the surface of tetrahedra.
    pub mesh: Option<PathBuf>,
    /// A generated mesh in place of a file.
    pub shape: Option<Shape>,
    /// The material of a solid.
    pub solid: Option<SolidProperties>,
    /// The material of a shell.
    pub shell: Option<ShellProperties>,
    /// The material of a rod.
    pub rod: Option<RodProperties>,
    /// The material of particles.
    pub particles: Option<ParticleProperties>,
    /// The material of an affine body.
    pub affine: Option<AffineProperties>,
    /// The offset of the contact surface, in m.
    #[serde(default, skip_serializing_if = "is_default")]
    pub offset: f64,
    /// The scaling about the origin, applied first.
    #[serde(default, skip_serializing_if = "is_default")]
    pub scale: Scale,
    /// The rotation about the origin, applied second.
    pub rotate: Option<Rotation>,
    /// The translation in m, applied third.
    #[serde(default, skip_serializing_if = "is_default")]
    pub translate: Point,
    /// The initial velocity, in m/s.
    #[serde(default, skip_serializing_if = "is_default")]
    pub velocity: Point,
    /// The initial angular velocity about the center of mass, in rad/s.
    #[serde(default, skip_serializing_if = "is_default")]
    pub angular_velocity: Point,
    /// The materials of groups of a solid, `[[body.region]]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub region: Vec<RegionDescription>,
    /// The loads on its vertices, `[[body.load]]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub load: Vec<LoadDescription>,
    /// The scripts of its vertices, `[[body.script]]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub script: Vec<ScriptDescription>,
}

/// A physical group of a solid with a material of its own.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct RegionDescription {
    /// The group.
    pub group: GroupKey,
    /// Its material.
    pub solid: SolidProperties,
}

/// A generated mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Shape {
    /// [`shapes::solid_box`](exact_ccd_sim::shapes::solid_box).
    Box {
        /// The number of cells along each axis.
        cells: [u8; 3],
        /// The lengths of the sides, in m.
        size: Point,
    },
    /// [`shapes::cloth`](exact_ccd_sim::shapes::cloth).
    Grid {
        /// The numbers of cells along x and z.
        cells: [u16; 2],
        /// The lengths of the sides, in m.
        size: [f64; 2],
    },
    /// [`shapes::sphere`](exact_ccd_sim::shapes::sphere).
    Sphere {
        /// The number of subdivisions of an icosahedron.
        subdivisions: u8,
        /// The radius, in m.
        radius: f64,
    },
    /// [`shapes::torus`](exact_ccd_sim::shapes::torus).
    Torus {
        /// The numbers of segments around the axis and around the tube.
        segments: [u16; 2],
        /// The radius of the circle, in m.
        radius: f64,
        /// The radius of the tube, in m.
        tube: f64,
    },
    /// [`shapes::line`](exact_ccd_sim::shapes::line).
    Line {
        /// The number of edges.
        edges: u16,
        /// The length, in m.
        length: f64,
    },
    /// [`shapes::knot`](exact_ccd_sim::shapes::knot).
    Knot {
        /// The number of edges.
        edges: u16,
        /// The length, in m.
        length: f64,
    },
    /// [`shapes::particles`](exact_ccd_sim::shapes::particles).
    Points {
        /// The number of points along each axis.
        counts: [u8; 3],
        /// The lengths of the sides, in m.
        size: Point,
    },
}

impl BodyDescription {
    /// The materials that the body has, by their keys.
    pub(crate) fn materials(&self) -> Vec<&'static str> {
        let materials = [
            ("solid", self.solid.is_some()),
            ("shell", self.shell.is_some()),
            ("rod", self.rod.is_some()),
            ("particles", self.particles.is_some()),
            ("affine", self.affine.is_some()),
        ];
        let given = materials.into_iter().filter(|(_, is_given)| *is_given);
        given.map(|(key, _)| key).collect()
    }

    /// The placement of its mesh.
    pub fn placement(&self) -> Placement {
        Placement {
            scale: self.scale,
            rotate: self.rotate,
            translate: self.translate,
        }
    }

    /// The same body at another place.
    pub fn at(self, placement: Placement) -> Self {
        let Placement {
            scale,
            rotate,
            translate,
        } = placement;
        Self {
            scale,
            rotate,
            translate,
            ..self
        }
    }

    /// The key of the material, for messages.
    pub(crate) fn material(&self) -> &'static str {
        self.materials().first().copied().unwrap_or("solid")
    }
}

/// A selection of vertices and their motion.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ScriptDescription {
    /// The selected vertices.
    #[serde(default, skip_serializing_if = "is_default")]
    pub vertices: Selection,
    /// Their motion.
    pub motion: Script,
    /// The axes along which they are scripted.
    #[serde(default = "all_axes", skip_serializing_if = "are_all")]
    pub axes: Vec<Axis>,
    /// The time at which the motion begins, in s.
    #[serde(default, skip_serializing_if = "is_default")]
    pub from: f64,
    /// The time from which they are free, in s.
    pub release: Option<f64>,
}

/// An axis of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

fn all_axes() -> Vec<Axis> {
    vec![Axis::X, Axis::Y, Axis::Z]
}

fn are_all(axes: &[Axis]) -> bool {
    axes == all_axes()
}

impl ScriptDescription {
    /// A script along all axes, at all times.
    pub fn new(vertices: Selection, motion: Script) -> Self {
        Self {
            vertices,
            motion,
            axes: all_axes(),
            from: 0.0,
            release: None,
        }
    }
}

/// A selection of vertices and a force on them.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct LoadDescription {
    /// The selected vertices.
    #[serde(default, skip_serializing_if = "is_default")]
    pub vertices: Selection,
    /// The force.
    pub force: Force,
    /// The time at which it begins, in s.
    #[serde(default, skip_serializing_if = "is_default")]
    pub from: f64,
    /// The time at which it ends, in s.
    pub until: Option<f64>,
}

/// A selection of vertices of a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Selection {
    /// All vertices.
    #[default]
    All,
    /// The vertices in a box, after the placement of the body.
    Box {
        /// The least coordinates, in m.
        lower: Point,
        /// The greatest coordinates, in m.
        upper: Point,
    },
    /// The vertices with these numbers in the mesh, from 0.
    Vertices(Vec<u32>),
    /// The vertices of a group of the mesh file.
    Group(GroupKey),
}

/// A spring between two bodies, or a body and a place.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct SpringDescription {
    /// The names of two bodies, or of one, which a place that never moves holds.
    pub between: Vec<String>,
    /// The positions of both ends at the start, or one for both.
    pub at: Vec<Point>,
    /// The stiffness, in N/m.
    pub stiffness: f64,
    /// The length without forces, in m. If not given, it is that at the start.
    pub length: Option<f64>,
}

/// True for a value that is the same as if it were not given.
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

//! The JSON of a file: the properties that place meshes in the scene. All others are skipped.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::super::budget::Budget;
use super::extensions;
use crate::error::{Fault, ParseError, Place, quoted};

/// The memory of the shortest objects, such as a node `{},`, for each byte of the text.
const BYTES_A_BYTE: usize = 24;

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Document {
    asset: Asset,
    #[serde(default)]
    extensions_required: Vec<String>,
    #[serde(default)]
    pub(super) extensions_used: Vec<String>,
    #[serde(default)]
    pub(super) animations: Vec<Animation>,
    scene: Option<u32>,
    #[serde(default)]
    pub(super) scenes: Vec<Scene>,
    #[serde(default)]
    pub(super) nodes: Vec<Node>,
    #[serde(default)]
    pub(super) meshes: Vec<Mesh>,
    #[serde(default)]
    pub(super) accessors: Vec<Accessor>,
    #[serde(default)]
    pub(super) buffer_views: Vec<BufferView>,
    #[serde(default)]
    pub(super) buffers: Vec<Buffer>,
}

#[derive(Debug, Deserialize)]
struct Asset {
    version: String,
}

#[derive(Debug, Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<u32>,
}

/// A node. Its transform is that of `matrix`, or else of the three others.
#[derive(Debug, Deserialize)]
pub(super) struct Node {
    #[serde(default)]
    pub(super) children: Box<[u32]>,
    pub(super) mesh: Option<u32>,
    pub(super) skin: Option<IgnoredAny>,
    pub(super) matrix: Option<Box<[f64; 16]>>,
    pub(super) translation: Option<Box<[f64; 3]>>,
    pub(super) rotation: Option<Box<[f64; 4]>>,
    pub(super) scale: Option<Box<[f64; 3]>>,
    pub(super) extensions: Option<Box<NodeExtensions>>,
}

#[derive(Debug, Deserialize)]
pub(super) struct NodeExtensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub(super) instancing: Option<Instancing>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Instancing {
    pub(super) attributes: InstanceAttributes,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub(super) struct InstanceAttributes {
    pub(super) translation: Option<u32>,
    pub(super) rotation: Option<u32>,
    pub(super) scale: Option<u32>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Animation {
    pub(super) channels: Vec<Channel>,
    pub(super) samplers: Vec<Sampler>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Channel {
    pub(super) sampler: u32,
    pub(super) target: Target,
}

#[derive(Debug, Deserialize)]
pub(super) struct Target {
    pub(super) node: Option<u32>,
    pub(super) path: String,
}

/// Keys: the accessors of their times and of their values.
#[derive(Debug, Deserialize)]
pub(super) struct Sampler {
    pub(super) input: u32,
    pub(super) output: u32,
    #[serde(default)]
    pub(super) interpolation: Interpolation,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "UPPERCASE")]
pub(super) enum Interpolation {
    #[default]
    Linear,
    Step,
    CubicSpline,
}

#[derive(Debug, Deserialize)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<u32>,
    #[serde(default)]
    pub(super) mode: Mode,
    #[serde(default)]
    pub(super) targets: Vec<IgnoredAny>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<u32>,
}

/// The elements of a primitive.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(try_from = "u32")]
pub(super) enum Mode {
    Points,
    Lines,
    LineLoop,
    LineStrip,
    #[default]
    Triangles,
    TriangleStrip,
    TriangleFan,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<u32>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) shape: String,
    /// Integers stand for the numbers from 0 or −1 to 1.
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) sparse: Option<IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: u32,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) byte_length: u64,
    pub(super) uri: Option<String>,
}

impl TryFrom<u32> for Mode {
    type Error = String;

    fn try_from(number: u32) -> Result<Self, String> {
        const MODES: [Mode; 7] = [
            Mode::Points,
            Mode::Lines,
            Mode::LineLoop,
            Mode::LineStrip,
            Mode::Triangles,
            Mode::TriangleStrip,
            Mode::TriangleFan,
        ];
        let mode = usize::try_from(number).ok().and_then(|number| MODES.get(number));
        mode.copied()
            .ok_or_else(|| format!("mode {number}, expected 0 to 6"))
    }
}

impl Document {
    pub(super) fn read(json: &[u8], budget: &Budget) -> Result<Self, ParseError> {
        budget.step(json.len() as u64);
        budget.hold::<[u8; BYTES_A_BYTE]>(json.len());
        let document: Self = serde_json::from_slice(json).map_err(|error| {
            let text = error.to_string();
            let fault = text.split(" at line ").next().unwrap_or_default();
            let found = format!("{} at column {}", quoted(fault.as_bytes()), error.column());
            Fault::expected("glTF 2.0", found).at(Place::Line(error.line()))
        })?;
        let version = &document.asset.version;
        if !version.starts_with("2.") {
            return Err(Fault::expected("glTF of version 2", quoted(version.as_bytes())).at(Place::File));
        }
        extensions::check_required(&document.extensions_required).map_err(|fault| fault.at(Place::File))?;
        Ok(document)
    }

    /// Returns true if a file has animations.
    pub(super) fn has_animations(json: &[u8], budget: &Budget) -> bool {
        #[derive(Deserialize)]
        struct Animations {
            #[serde(default)]
            animations: Vec<IgnoredAny>,
        }
        budget.step(json.len() as u64);
        let document = serde_json::from_slice::<Animations>(json);
        document.is_ok_and(|document| !document.animations.is_empty())
    }

    /// The default scene, or else the first one; no nodes in a file without scenes.
    pub(super) fn scene(&self) -> Result<&[u32], Fault> {
        match (self.scene, self.scenes.first()) {
            (Some(scene), _) => Ok(&at(&self.scenes, scene, "scene")?.nodes),
            (None, Some(first)) => Ok(&first.nodes),
            (None, None) => Ok(&[]),
        }
    }
}

/// The object with an index.
pub(super) fn at<'o, T>(objects: &'o [T], index: u32, name: &str) -> Result<&'o T, Fault> {
    let object = usize::try_from(index).ok().and_then(|index| objects.get(index));
    object.ok_or_else(|| {
        let expected = format!("one of {} objects `{name}`", objects.len());
        Fault::expected(expected, format!("number {index}"))
    })
}

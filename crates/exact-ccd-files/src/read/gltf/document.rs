//! The JSON of a file: the properties that place meshes in the scene. All others are skipped.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::super::budget::Budget;
use crate::error::{Fault, ParseError, Place, quoted};

/// The memory of the shortest objects, such as a node `{},`, for each byte of the text.
const BYTES_A_BYTE: usize = 24;

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Document {
    asset: Asset,
    #[serde(default)]
    extensions_required: Vec<String>,
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

#[derive(Deserialize)]
struct Asset {
    version: String,
}

#[derive(Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<u32>,
}

/// A node. Its transform is that of `matrix`, or else of the three others.
#[derive(Deserialize)]
pub(super) struct Node {
    #[serde(default)]
    pub(super) children: Vec<u32>,
    pub(super) mesh: Option<u32>,
    pub(super) skin: Option<IgnoredAny>,
    pub(super) matrix: Option<Box<[f64; 16]>>,
    pub(super) translation: Option<Box<[f64; 3]>>,
    pub(super) rotation: Option<Box<[f64; 4]>>,
    pub(super) scale: Option<Box<[f64; 3]>>,
}

#[derive(Deserialize)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<u32>,
    #[serde(default)]
    pub(super) mode: Mode,
    #[serde(default)]
    pub(super) targets: Vec<IgnoredAny>,
}

#[derive(Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<u32>,
}

/// The elements of a primitive.
#[derive(Clone, Copy, Default, Deserialize, PartialEq, Eq)]
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

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<u32>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) shape: String,
    pub(super) sparse: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: u32,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

#[derive(Deserialize)]
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
        let fault = |expected: &str, found: &str| {
            Err(Fault::expected(expected, quoted(found.as_bytes())).at(Place::File))
        };
        if !document.asset.version.starts_with("2.") {
            return fault("glTF of version 2", &document.asset.version);
        }
        match document.extensions_required.first() {
            Some(extension) => fault(
                "a glTF file without required extensions (export it without compression of meshes)",
                extension,
            ),
            None => Ok(document),
        }
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

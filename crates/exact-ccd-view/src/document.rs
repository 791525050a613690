//! The HTML file.

use std::borrow::Cow;
use std::io::{self, Write};

use exact_ccd_mesh::{Point, TriangleMesh};
use serde::Serialize;

use crate::block;
use crate::body::Body;
use crate::contact::ShownContact;
use crate::half_space::ShownHalfSpace;
use crate::history::History;
use crate::query::ShownQuery;

/// The program that draws the page, built from `viewer/`.
const VIEWER: &str = include_str!("../assets/viewer.html");

/// The place of the data in it.
const PLACE: &str = "<!-- data -->";

/// The format of the data, which the program checks.
pub(crate) const FORMAT: u32 = 2;

/// The data of a page, in the shape of the JSON object.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Document<'a> {
    pub(crate) format: u32,
    pub(crate) title: &'a str,
    /// The line of the answer, which is the headline. Empty for the first line of the summary.
    pub(crate) verdict: &'a str,
    pub(crate) summary: &'a [String],
    pub(crate) up: Point,
    pub(crate) vertices: usize,
    pub(crate) faces: usize,
    pub(crate) edges: usize,
    pub(crate) center: Point,
    pub(crate) scale: f64,
    pub(crate) bodies: &'a [Body],
    pub(crate) half_spaces: &'a [ShownHalfSpace],
    pub(crate) history: Option<&'a History>,
    /// The radii of rods and loose vertices at each vertex, in units of the page; written as a block.
    #[serde(skip)]
    pub(crate) radii: &'a [f32],
    pub(crate) frames: &'a [ShownFrame],
    pub(crate) contacts: &'a [ShownContact],
    pub(crate) contact_count: usize,
    pub(crate) query: Option<&'a ShownQuery>,
}

/// A frame, whose positions are written as a block of their own.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ShownFrame {
    pub(crate) number: usize,
    label: String,
    #[serde(skip)]
    block: String,
}

impl ShownFrame {
    pub(crate) fn new(number: usize, label: String, block: String) -> Self {
        Self { number, label, block }
    }

    /// The size of the block in bytes.
    pub(crate) fn size(&self) -> usize {
        self.block.len()
    }
}

/// A text of the page, and the id of the element that contains it.
pub(crate) type Block<'a> = (Cow<'a, str>, Cow<'a, str>);

/// The id of the JSON object.
const JSON: &str = "page";

impl Document<'_> {
    /// The JSON object, and the arrays of the mesh and of its frames.
    pub(crate) fn blocks(&self, mesh: &TriangleMesh) -> impl Iterator<Item = Block<'_>> {
        // Cannot panic: the keys are strings. Text of the user cannot end the element.
        let json = serde_json::to_string(self).expect("the object has a text");
        let json = json.replace('<', "\\u003c");
        let faces = block::encode_elements(mesh.faces());
        let edges = block::encode_elements(mesh.loose_edges());
        let radii = block::encode_floats(self.radii.iter().copied());
        let mesh = [(JSON, json), ("faces", faces), ("edges", edges), ("radii", radii)];
        let mesh = mesh.map(|(id, text)| (id.into(), text.into()));
        let frames = self.frames.iter().enumerate();
        let frames = frames.map(|(index, frame)| (format!("frame-{index}").into(), (&*frame.block).into()));
        mesh.into_iter().chain(frames)
    }

    pub(crate) fn write(&self, mesh: &TriangleMesh, writer: &mut impl Write) -> io::Result<()> {
        let (before, after) = VIEWER.split_once(PLACE).unwrap_or((VIEWER, ""));
        writer.write_all(before.as_bytes())?;
        for (id, text) in self.blocks(mesh) {
            let format = if id == JSON { "json" } else { "octet-stream" };
            writeln!(
                writer,
                "<script type=\"application/{format}\" id=\"{id}\">{text}</script>"
            )?;
        }
        writer.write_all(after.as_bytes())
    }
}

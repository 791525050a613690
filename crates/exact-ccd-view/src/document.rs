//! The HTML file.

use std::io::{self, Write};

use exact_ccd_mesh::{Point, TriangleMesh};
use serde::Serialize;

use crate::block;
use crate::contact::ShownContact;
use crate::query::ShownQuery;

/// The program that draws the page, built from `viewer/`.
const VIEWER: &str = include_str!("../assets/viewer.html");

/// The place of the data in it.
const PLACE: &str = "<!-- data -->";

/// The format of the data, which the program checks.
pub(crate) const FORMAT: u32 = 1;

/// The data of a page, in the shape of the JSON object.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Document<'a> {
    pub(crate) format: u32,
    pub(crate) title: &'a str,
    pub(crate) summary: &'a [String],
    pub(crate) up: Point,
    pub(crate) vertices: usize,
    pub(crate) faces: usize,
    pub(crate) edges: usize,
    pub(crate) centre: Point,
    pub(crate) scale: f64,
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

impl Document<'_> {
    pub(crate) fn write(&self, mesh: &TriangleMesh, writer: &mut impl Write) -> io::Result<()> {
        let (before, after) = VIEWER.split_once(PLACE).unwrap_or((VIEWER, ""));
        writer.write_all(before.as_bytes())?;
        // Text of the user cannot end the element.
        let json = serde_json::to_string(self)?.replace('<', "\\u003c");
        writeln!(
            writer,
            "<script type=\"application/json\" id=\"page\">{json}</script>"
        )?;
        let mut block = |id: &str, text: &str| {
            writeln!(
                writer,
                "<script type=\"application/octet-stream\" id=\"{id}\">{text}</script>"
            )
        };
        block("faces", &block::encode_elements(mesh.faces()))?;
        block("edges", &block::encode_elements(mesh.loose_edges()))?;
        for (index, frame) in self.frames.iter().enumerate() {
            block(&format!("frame-{index}"), &frame.block)?;
        }
        writer.write_all(after.as_bytes())
    }
}

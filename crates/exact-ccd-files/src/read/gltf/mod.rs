//! glTF 2.0, as JSON and binary: the meshes of the scene at rest.
//!
//! Khronos Group, *glTF 2.0 Specification*.

mod accessor;
mod buffers;
mod container;
mod document;
mod transform;

use std::collections::HashMap;
use std::path::Path;

use super::budget::Budget;
use super::cells::Cells;
use super::polygons::strip;
use crate::error::{Fault, ParseError, Place};
use accessor::Accessors;
use buffers::Buffers;
use document::{Document, Mode, Primitive, at};
use transform::Transform;

/// The work for a primitive besides its vertices, in steps. Many nodes may have the same mesh.
const PRIMITIVE: u64 = 64;

/// Reads the default scene, or else the first one. Its other files are in `folder`.
pub(super) fn read(bytes: &[u8], folder: Option<&Path>, budget: &Budget) -> Result<Cells, ParseError> {
    let (json, blob) = container::split(bytes, budget)?;
    let document = Document::read(json, budget)?;
    let cells = Buffers::read(&document, blob, folder, budget).and_then(|buffers| {
        let mut reader = Reader {
            accessors: Accessors {
                document: &document,
                buffers,
                budget,
            },
            visited: vec![false; document.nodes.len()],
            cells: Cells::default(),
        };
        reader.read_nodes()?;
        Ok(reader.cells)
    });
    cells.map_err(|fault| fault.at(Place::File))
}

struct Reader<'a> {
    accessors: Accessors<'a>,
    visited: Vec<bool>,
    cells: Cells,
}

/// A primitive and its place in its mesh.
struct Part<'a> {
    number: usize,
    primitive: &'a Primitive,
}

impl Reader<'_> {
    /// Reads the nodes of the scene, each before its children.
    fn read_nodes(&mut self) -> Result<(), Fault> {
        let document = self.accessors.document;
        let roots = document.scene()?.iter().rev();
        let mut open: Vec<(u32, Transform)> = roots.map(|&node| (node, Transform::default())).collect();
        while let Some((index, parent)) = open.pop() {
            let node = at(&document.nodes, index, "node")?;
            if std::mem::replace(&mut self.visited[index as usize], true) {
                return Err(Fault::expected(
                    "a node with one parent",
                    format!("node {index} again"),
                ));
            }
            let transform = parent.then(&Transform::of(node, index)?);
            if let Some(mesh) = node.mesh {
                if node.skin.is_some() {
                    return Err(unsupported(mesh, "a skin"));
                }
                self.read_mesh(mesh, &transform)?;
            }
            open.extend(node.children.iter().rev().map(|&child| (child, transform)));
        }
        Ok(())
    }

    /// Appends a mesh. Its primitives often share one list of positions.
    fn read_mesh(&mut self, mesh: u32, transform: &Transform) -> Result<(), Fault> {
        let mut first_vertices = HashMap::new();
        let document = self.accessors.document;
        let primitives = &at(&document.meshes, mesh, "mesh")?.primitives;
        for (number, primitive) in primitives.iter().enumerate() {
            self.accessors.budget.work(PRIMITIVE)?;
            if !primitive.targets.is_empty() {
                return Err(unsupported(mesh, "morph targets (shape keys)"));
            }
            // A primitive without positions has no geometry of its own.
            let Some(positions) = primitive.attributes.position else {
                continue;
            };
            let first = match first_vertices.get(&positions) {
                Some(&first) => first,
                None => {
                    let first = self.cells.positions.len();
                    let points = self.accessors.positions(positions)?.into_iter();
                    self.cells
                        .positions
                        .extend(points.map(|point| transform.apply(point)));
                    first_vertices.insert(positions, first);
                    first
                }
            };
            let part = Part { number, primitive };
            let vertices = self.vertices(&part, first, self.accessors.count(positions)?)?;
            check_count(&part, vertices.len())?;
            self.add(primitive.mode, &vertices);
        }
        Ok(())
    }

    /// The vertices of a primitive, in the order in which they form its elements, of `count` positions.
    fn vertices(&self, part: &Part, first: usize, count: u64) -> Result<Vec<u32>, Fault> {
        let indices = match part.primitive.indices {
            None => {
                self.accessors.budget.take(count.saturating_mul(4))?;
                (0..count).collect()
            }
            Some(accessor) => self.accessors.indices(accessor)?,
        };
        let vertex = |index: u64| {
            let vertex = (index < count).then_some(index + first as u64);
            vertex
                .and_then(|vertex| u32::try_from(vertex).ok())
                .ok_or_else(|| {
                    let expected = format!("an index below {count} in primitive {}", part.number);
                    Fault::expected(expected, index.to_string())
                })
        };
        indices.into_iter().map(vertex).collect()
    }

    /// Adds the elements of a list of vertices.
    fn add(&mut self, mode: Mode, vertices: &[u32]) {
        let cells = &mut self.cells;
        let triangles = &mut cells.faces.triangles;
        match mode {
            Mode::Points => cells.points.extend(vertices),
            Mode::Lines => cells.lines.extend(vertices.as_chunks::<2>().0),
            Mode::LineStrip => cells.add_polyline(vertices),
            Mode::LineLoop => {
                cells.add_polyline(vertices);
                if let [first, .., last] = vertices {
                    cells.lines.push([*last, *first]);
                }
            }
            Mode::Triangles => triangles.extend(vertices.as_chunks::<3>().0),
            Mode::TriangleStrip => triangles.extend(strip(vertices)),
            Mode::TriangleFan => {
                if let Some((&center, around)) = vertices.split_first() {
                    triangles.extend(around.windows(2).map(|pair| [center, pair[0], pair[1]]));
                }
            }
        }
        cells.faces.count = cells.faces.triangles.len();
    }
}

/// Refuses a number of vertices with which the last element of a primitive is not whole.
fn check_count(part: &Part, count: usize) -> Result<(), Fault> {
    let (is_whole, expected) = match part.primitive.mode {
        Mode::Points => (true, ""),
        Mode::Lines => (count.is_multiple_of(2), "two vertices for each line"),
        Mode::Triangles => (count.is_multiple_of(3), "three vertices for each triangle"),
        Mode::LineStrip | Mode::LineLoop => (count != 1, "two or more vertices of a strip of lines"),
        Mode::TriangleStrip | Mode::TriangleFan => {
            let is_whole = !matches!(count, 1 | 2);
            (is_whole, "three or more vertices of a strip or fan of triangles")
        }
    };
    if is_whole {
        return Ok(());
    }
    let place = match part.primitive.indices {
        Some(accessor) => format!("accessor {accessor}"),
        None => format!("primitive {} without indices", part.number),
    };
    Err(Fault::expected(
        format!("{expected} in {place}"),
        count.to_string(),
    ))
}

fn unsupported(mesh: u32, with: &str) -> Fault {
    let expected = format!("mesh {mesh} without {with} (apply it before export)");
    Fault::expected(expected, with)
}

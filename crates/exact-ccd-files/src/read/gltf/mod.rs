//! glTF 2.0, as JSON and binary: the meshes of the scene at rest.
//!
//! Khronos Group, *glTF 2.0 Specification*. The crate `gltf` reads and checks the JSON; positions
//! and indices are read here, with errors that name the accessor.

mod accessor;
mod buffers;
mod container;
mod transform;

use std::collections::HashMap;
use std::path::Path;

use gltf::mesh::Mode;
use gltf::{Document, Gltf, Mesh, Node, Primitive, Scene, Semantic};

use super::cells::Cells;
use super::compressed::Budget;
use super::polygons::strip;
use crate::error::{Fault, ParseError, Place, quoted};
use buffers::Buffers;
use transform::Transform;

/// Reads the default scene, or else the first one. Its other files are in `folder`.
pub(super) fn read(bytes: &[u8], folder: Option<&Path>) -> Result<Cells, ParseError> {
    let (json, blob) = container::split(bytes)?;
    read_scene(json, blob, folder).map_err(|fault| fault.at(Place::File))
}

fn read_scene(json: &[u8], blob: Option<Vec<u8>>, folder: Option<&Path>) -> Result<Cells, Fault> {
    let Gltf { document, .. } = Gltf::from_slice_without_validation(json).map_err(invalid)?;
    let root = document.into_json();
    // The validation of the crate panics for such an index.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let accessors = primitives.flat_map(|primitive| primitive.attributes.values());
    let mut indices = accessors.map(gltf::json::Index::value);
    if let Some(index) = indices.find(|&index| index >= root.accessors.len()) {
        let expected = format!("one of {} accessors", root.accessors.len());
        return Err(Fault::expected(expected, format!("accessor {index}")));
    }
    let document = Document::from_json(root).map_err(invalid)?;
    let mut reader = Reader {
        data: Buffers::read(&document, blob, folder)?,
        budget: Budget::of(json.len()),
        visited: vec![false; document.nodes().len()],
        cells: Cells::default(),
    };
    reader.budget = Budget::of(json.len().saturating_add(reader.data.size()));
    reader.read_nodes(&document)?;
    Ok(reader.cells)
}

/// The error of a file that is not valid. The text of the crate has several lines.
fn invalid(error: gltf::Error) -> Fault {
    let text = error.to_string();
    if text.contains("extensionsRequired") {
        let expected = "a glTF file without required extensions (export it without compression of meshes)";
        return Fault::expected(expected, "some");
    }
    Fault::expected("glTF 2.0", quoted(text.as_bytes()))
}

struct Reader {
    data: Buffers,
    /// The number of bytes that positions and indices may take: many nodes may have the same mesh.
    budget: Budget,
    visited: Vec<bool>,
    cells: Cells,
}

impl Reader {
    /// Reads the nodes of the scene, each before its children.
    fn read_nodes(&mut self, document: &Document) -> Result<(), Fault> {
        let scene = document.default_scene().or_else(|| document.scenes().next());
        let mut roots: Vec<Node> = scene.iter().flat_map(Scene::nodes).collect();
        roots.reverse();
        let mut open: Vec<(Node, Transform)> = roots
            .into_iter()
            .map(|node| (node, Transform::default()))
            .collect();
        while let Some((node, parent)) = open.pop() {
            let index = node.index();
            if std::mem::replace(&mut self.visited[index], true) {
                return Err(Fault::expected(
                    "a node with one parent",
                    format!("node {index} again"),
                ));
            }
            let transform = parent.then(&Transform::of(&node)?);
            if let Some(mesh) = node.mesh() {
                if node.skin().is_some() {
                    return Err(unsupported(&mesh, "a skin"));
                }
                self.read_mesh(&mesh, &transform)?;
            }
            let mut children: Vec<Node> = node.children().collect();
            children.reverse();
            open.extend(children.into_iter().map(|child| (child, transform)));
        }
        Ok(())
    }

    /// Appends a mesh. Its primitives often share one list of positions.
    fn read_mesh(&mut self, mesh: &Mesh, transform: &Transform) -> Result<(), Fault> {
        let mut first_vertices = HashMap::new();
        for primitive in mesh.primitives() {
            if primitive.morph_targets().len() > 0 {
                return Err(unsupported(mesh, "morph targets (shape keys)"));
            }
            // A primitive without positions has no geometry of its own.
            let Some(positions) = primitive.get(&Semantic::Positions) else {
                continue;
            };
            let first = match first_vertices.get(&positions.index()) {
                Some(&first) => first,
                None => {
                    let first = self.cells.positions.len();
                    let points = self.data.positions(&positions, &mut self.budget)?;
                    let points = points.into_iter().map(|point| transform.apply(point));
                    self.cells.positions.extend(points);
                    first_vertices.insert(positions.index(), first);
                    first
                }
            };
            let vertices = self.vertices(&primitive, first, positions.count())?;
            check_count(&primitive, vertices.len())?;
            self.add(primitive.mode(), &vertices)?;
        }
        Ok(())
    }

    /// The vertices of a primitive, in the order in which they form its elements.
    fn vertices(&mut self, primitive: &Primitive, first: usize, count: usize) -> Result<Vec<u32>, Fault> {
        let indices = match primitive.indices() {
            None => {
                self.budget.take((count as u64).saturating_mul(4))?;
                (0..count as u64).collect()
            }
            Some(accessor) => self.data.indices(&accessor, &mut self.budget)?,
        };
        let vertex = |index: u64| {
            let vertex = (index < count as u64).then_some(index + first as u64);
            vertex
                .and_then(|vertex| u32::try_from(vertex).ok())
                .ok_or_else(|| {
                    let primitive = primitive.index();
                    let expected = format!("an index below {count} in primitive {primitive}");
                    Fault::expected(expected, index.to_string())
                })
        };
        indices.into_iter().map(vertex).collect()
    }

    /// Adds the elements of a list of vertices.
    fn add(&mut self, mode: Mode, vertices: &[u32]) -> Result<(), Fault> {
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
        Ok(())
    }
}

/// Refuses a number of vertices with which the last element of a primitive is not whole.
fn check_count(primitive: &Primitive, count: usize) -> Result<(), Fault> {
    let (is_whole, expected) = match primitive.mode() {
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
    let place = match primitive.indices() {
        Some(accessor) => format!("accessor {}", accessor.index()),
        None => format!("primitive {} without indices", primitive.index()),
    };
    Err(Fault::expected(
        format!("{expected} in {place}"),
        count.to_string(),
    ))
}

fn unsupported(mesh: &Mesh, with: &str) -> Fault {
    let expected = format!("mesh {} without {with} (apply it before export)", mesh.index());
    Fault::expected(expected, with)
}

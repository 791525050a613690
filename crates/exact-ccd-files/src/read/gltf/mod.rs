//! glTF 2.0, as JSON and binary: the meshes of the scene, at rest or moved by an animation of translations.
//!
//! Khronos Group, *glTF 2.0 Specification*.

mod accessor;
mod buffers;
mod container;
mod document;
mod extensions;
mod instances;
mod motion;
mod placed_meshes;
mod primitive;
mod transform;

use std::collections::HashMap;
use std::path::Path;

use super::budget::Budget;
use super::cells::Cells;
use crate::error::{Fault, ParseError, Place};
use crate::note::Fact;
use accessor::Accessors;
use buffers::Buffers;
use document::{Document, Node, at};
use motion::Motion;
pub(super) use placed_meshes::PlacedMeshes;
use placed_meshes::{Placed, Run};
use primitive::{Part, check_count};
use transform::Transform;

/// The work for a primitive besides its vertices, in steps. Many nodes may have the same mesh.
const PRIMITIVE: u64 = 64;

/// Reads the default scene, or else the first one, at rest. Its other files are in `folder`.
pub(super) fn read(bytes: &[u8], folder: Option<&Path>, budget: &Budget) -> Result<Cells, ParseError> {
    let (scene, mut cells) = read_scene(bytes, folder, budget, false)?;
    if scene.frame_count() > 1 {
        let remedy = "the meshes are at rest; read the file as a sequence of frames";
        cells.note(Fact::not_read("the animation", remedy).at(Place::File));
    }
    Ok(cells)
}

/// Reads the scene with its motion. The cells have the positions of the first frame.
pub(super) fn read_moving(
    bytes: &[u8],
    folder: Option<&Path>,
    budget: &Budget,
) -> Result<(PlacedMeshes, Cells), ParseError> {
    read_scene(bytes, folder, budget, true)
}

/// Returns true if a file has animations.
pub(super) fn has_animations(bytes: &[u8], budget: &Budget) -> Result<bool, ParseError> {
    let (json, _) = container::split(bytes, budget)?;
    Ok(Document::has_animations(json, budget))
}

fn read_scene(
    bytes: &[u8],
    folder: Option<&Path>,
    budget: &Budget,
    moves: bool,
) -> Result<(PlacedMeshes, Cells), ParseError> {
    let (json, blob) = container::split(bytes, budget)?;
    let document = Document::read(json, budget)?;
    let read = || {
        let mut reader = Reader {
            accessors: Accessors {
                document: &document,
                buffers: Buffers::read(&document, blob, folder, budget)?,
                budget,
            },
            visited: vec![false; document.nodes.len()],
            nodes: Vec::new(),
            runs: Vec::new(),
            cells: Cells::default(),
        };
        reader.read_nodes()?;
        reader.note_unread();
        let motion = reader.read_motion()?;
        Ok((reader.nodes, reader.runs, reader.cells, motion))
    };
    let at_file = |fault: Fault| fault.at(Place::File);
    let (nodes, runs, mut cells, motion) = read().map_err(at_file)?;
    let mut scene = PlacedMeshes {
        document,
        nodes,
        runs,
        points: std::mem::take(&mut cells.positions),
        motion,
    };
    budget.hold::<Placed>(scene.nodes.len());
    budget.hold::<Run>(scene.runs.len());
    cells.positions = if moves {
        motion::pose(&mut scene.document, &scene.motion);
        scene.positions(0)
    } else {
        scene.rest()
    }
    .map_err(at_file)?;
    Ok((scene, cells))
}

struct Reader<'a> {
    accessors: Accessors<'a>,
    visited: Vec<bool>,
    /// The nodes of the scene, each after its parent.
    nodes: Vec<Placed>,
    runs: Vec<Run>,
    cells: Cells,
}

impl Reader<'_> {
    /// Reads the nodes of the scene, each before its children.
    fn read_nodes(&mut self) -> Result<(), Fault> {
        let document = self.accessors.document;
        let roots = document.scene()?.iter().rev();
        let mut open: Vec<(u32, Option<u32>)> = roots.map(|&node| (node, None)).collect();
        while let Some((index, parent)) = open.pop() {
            let node = at(&document.nodes, index, "node")?;
            if std::mem::replace(&mut self.visited[index as usize], true) {
                return Err(Fault::expected(
                    "a node with one parent",
                    format!("node {index} again"),
                ));
            }
            // No more than the nodes, which 32 bits number.
            let place = self.nodes.len() as u32;
            self.nodes.push(Placed { node: index, parent });
            Transform::of(node, index, None)?;
            if let Some(mesh) = node.mesh {
                if node.skin.is_some() {
                    return Err(unsupported(mesh, "a skin"));
                }
                self.read_instances(node, mesh, place)?;
            }
            open.extend(node.children.iter().rev().map(|&child| (child, Some(place))));
        }
        Ok(())
    }

    /// Appends the mesh of a node, once or for each of its instances.
    fn read_instances(&mut self, node: &Node, mesh: u32, placed: u32) -> Result<(), Fault> {
        let extensions = node.extensions.as_deref();
        let instances = match extensions.and_then(|extensions| extensions.instancing.as_ref()) {
            None => vec![None],
            Some(instancing) => {
                let instances = instances::read(&instancing.attributes, &self.accessors)?;
                instances
                    .into_iter()
                    .map(|instance| Some(Box::new(instance)))
                    .collect()
            }
        };
        for instance in instances {
            self.read_mesh(mesh)?;
            let end = self.cells.positions.len();
            self.runs.push(Run {
                end,
                placed,
                instance,
            });
        }
        Ok(())
    }

    /// Adds notes about meshes and extensions that are not read.
    fn note_unread(&mut self) {
        let document = self.accessors.document;
        let nodes = document.nodes.iter().zip(&self.visited);
        let left_out = nodes
            .filter(|(node, visited)| node.mesh.is_some() && !**visited)
            .count();
        if left_out > 0 {
            let part = format!("meshes of nodes that are not in the default scene: {left_out}");
            let remedy = "export them in one scene, or remove them";
            self.cells.note(Fact::not_read(part, remedy).at(Place::File));
        }
        extensions::notes(&document.extensions_used).for_each(|note| self.cells.note(note));
    }

    /// The motion of the nodes, and notes about it.
    fn read_motion(&mut self) -> Result<Motion, Fault> {
        let mut moves = vec![false; self.visited.len()];
        for run in &self.runs {
            let mut above = Some(run.placed);
            while let Some(placed) = above {
                let Placed { node, parent } = self.nodes[placed as usize];
                // The nodes above it are known to move.
                let is_known = std::mem::replace(&mut moves[node as usize], true);
                above = parent.filter(|_| !is_known);
            }
        }
        let (motion, note) = Motion::read(&self.accessors, &moves)?;
        self.cells.notes.extend(note);
        Ok(motion)
    }

    /// Appends a mesh, in its own coordinates. Its primitives often share one list of positions.
    fn read_mesh(&mut self, mesh: u32) -> Result<(), Fault> {
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
                    const POSITION: &str = "three numbers for each position";
                    let points = self.accessors.vectors(positions, "VEC3", POSITION)?;
                    self.cells.positions.extend(points);
                    first_vertices.insert(positions, first);
                    first
                }
            };
            let part = Part { number, primitive };
            let vertices = self.vertices(&part, first, self.accessors.count(positions)?)?;
            check_count(&part, vertices.len())?;
            primitive::add(&mut self.cells, primitive.mode, &vertices);
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
}

fn unsupported(mesh: u32, with: &str) -> Fault {
    let expected = format!("mesh {mesh} without {with} (apply it before export)");
    Fault::expected(expected, with)
}

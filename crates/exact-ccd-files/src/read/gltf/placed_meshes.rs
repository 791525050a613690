//! The meshes of a scene, placed by its nodes at each time.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;

use super::document::Document;
use super::motion::Motion;
use super::transform::Transform;
use crate::error::Fault;

/// The points of all meshes, and the nodes that place them.
#[derive(Debug)]
pub(in super::super) struct PlacedMeshes {
    pub(super) document: Document,
    pub(super) nodes: Vec<Placed>,
    pub(super) runs: Vec<Run>,
    /// The positions of vertices as the meshes have them.
    pub(super) points: Vec<Point>,
    pub(super) motion: Motion,
}

/// A node of the scene, and the place of its parent, which is before it.
#[derive(Debug)]
pub(super) struct Placed {
    pub(super) node: u32,
    pub(super) parent: Option<u32>,
}

/// The points of one mesh of a node, up to an end.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) end: usize,
    /// The index of the node among the nodes of the scene.
    pub(super) placed: u32,
    /// The transform of an instance within the node.
    pub(super) instance: Option<Box<Transform>>,
}

impl PlacedMeshes {
    pub(in super::super) fn frame_count(&self) -> usize {
        self.motion.frame_count()
    }

    pub(in super::super) fn time(&self, frame: usize) -> Option<f64> {
        self.motion.time(frame)
    }

    /// The positions of all vertices in a frame.
    pub(in super::super) fn positions(&self, frame: usize) -> Result<Vec<Point>, Fault> {
        self.placed(&self.motion.translations(frame))
    }

    /// The positions of all vertices without any motion.
    pub(super) fn rest(&self) -> Result<Vec<Point>, Fault> {
        self.placed(&BTreeMap::new())
    }

    /// The positions of all vertices, where some nodes have other translations.
    fn placed(&self, translations: &BTreeMap<u32, Point>) -> Result<Vec<Point>, Fault> {
        let mut transforms: Vec<Transform> = Vec::new();
        for &Placed { node, parent } in &self.nodes {
            let moved = translations.get(&node);
            let own = Transform::of(&self.document.nodes[node as usize], node, moved)?;
            let parent = parent.map(|parent| transforms[parent as usize]);
            transforms.push(parent.unwrap_or_default().then(&own));
        }
        let mut positions = Vec::new();
        for run in &self.runs {
            let node = &transforms[run.placed as usize];
            let transform = run
                .instance
                .as_deref()
                .map_or(*node, |instance| node.then(instance));
            let points = &self.points[positions.len()..run.end];
            positions.extend(points.iter().map(|&point| transform.apply(point)));
        }
        Ok(positions)
    }
}

//! Renders a frame: flat shading, the edges of the mesh, rods, points and marks.

use std::collections::HashMap;

use exact_ccd_mesh::vector::{cross, dot, minus, unit};
use exact_ccd_mesh::{Frame, Point, TriangleMesh};

use crate::canvas::{Canvas, Colour};
use crate::marks::Marks;
use crate::picture::{Picture, SAMPLES};
use crate::view::View;

const BACKGROUND: Colour = [255, 255, 255];
/// The colours of the connected parts of a mesh, in turn.
const SURFACES: [Colour; 5] = [
    [166, 189, 219],
    [253, 205, 160],
    [171, 217, 180],
    [203, 190, 226],
    [248, 226, 140],
];
const EDGE: Colour = [70, 80, 100];
const MARK: Colour = [215, 48, 39];

/// The displacement of lines towards the viewer, relative to the faces that they bound, in pixels.
const LIFT: f64 = 0.5;

/// Edges of faces are not drawn if their mean length in pixels is below this: they would hide the faces.
const SHORTEST: f64 = 5.0;

/// The picture of a frame.
///
/// Connected parts have distinct colours. Light comes from above the viewer's right shoulder and
/// illuminates both sides of faces. Loose edges are lines and loose vertices are dots. Marks are
/// red and cover everything at the same depth; marked edges and vertices are wider. A vertex
/// without a position, or whose projection is out of the range of `f64`, is left out with all its
/// faces and edges.
#[must_use]
pub fn render(frame: &Frame, view: &View, marks: &Marks) -> Picture {
    render_thick(frame, view, marks, &[])
}

/// As [`render`], with rods as tubes and points as balls.
///
/// `radii` has a radius for each vertex, in the unit of the positions; vertices without one have radius 0,
/// and are lines and dots. Tubes and balls have the colour of their part. All points are one part.
#[must_use]
pub fn render_thick(frame: &Frame, view: &View, marks: &Marks, radii: &[f64]) -> Picture {
    let samples = SAMPLES as f64;
    let size = view.size.map(|pixels| usize::from(pixels) * SAMPLES);
    let mut canvas = Canvas::new(size, BACKGROUND);
    let seen: Vec<Point> = frame
        .positions
        .iter()
        .map(|&position| view.project(position).map(|x| x * samples))
        .collect();
    let at = |vertex: u32| seen.get(vertex as usize).copied().unwrap_or([f64::NAN; 3]);

    let light = light(view);
    let lamp = view.axes.map(|axis| dot(axis, light));
    let radius = |vertex: u32| {
        let radius = radii.get(vertex as usize).copied().unwrap_or(0.0);
        radius * view.scale * samples
    };
    let mut is_marked = vec![false; frame.mesh.faces().len()];
    for &face in &marks.faces {
        if let Some(marked) = is_marked.get_mut(face as usize) {
            *marked = true;
        }
    }
    let parts = Parts::new(&frame.mesh);
    for (face, is_marked) in frame.mesh.faces().iter().zip(is_marked) {
        let colour = if is_marked { MARK } else { parts.colour(face[0]) };
        let [a, b, c] = face.map(|vertex| position(frame, vertex));
        let normal = unit(cross(minus(b, a), minus(c, a)));
        let brightness = 0.35 + 0.65 * normal.map_or(0.0, |normal| dot(normal, light).abs());
        canvas.triangle(face.map(at), dimmed(colour, brightness));
    }
    let lifted = |vertex: u32, times: f64| {
        let [x, y, near] = at(vertex);
        [x, y, near + times * LIFT * samples]
    };
    let rods = frame.mesh.loose_edges();
    let all = frame.mesh.edges();
    let edges = &all[..all.len() - rods.len()];
    let lengths = edges
        .iter()
        .map(|edge| edge.map(at))
        .map(|[a, b]| [a[0] - b[0], a[1] - b[1]])
        .map(|[x, y]| (x * x + y * y).sqrt());
    if lengths.filter(|length| length.is_finite()).sum::<f64>() >= SHORTEST * samples * edges.len() as f64 {
        for &[a, b] in edges {
            canvas.line(lifted(a, 1.0), lifted(b, 1.0), 1.0, EDGE);
        }
    }
    let ball = |colour: Colour| move |normal: Point| dimmed(colour, 0.35 + 0.65 * dot(normal, lamp).max(0.0));
    for &[a, b] in rods {
        let radii = [a, b].map(radius);
        if radii.into_iter().any(|radius| radius > 0.0) {
            canvas.tube([at(a), at(b)], radii, ball(parts.colour(a)));
        } else {
            canvas.line(lifted(a, 1.0), lifted(b, 1.0), samples, EDGE);
        }
    }
    for vertex in frame.mesh.loose_vertices().take(frame.positions.len()) {
        if radius(vertex) > 0.0 {
            canvas.ball(at(vertex), radius(vertex), &ball(parts.colour(vertex)));
        } else {
            canvas.dot(lifted(vertex, 1.0), 3.0 * samples, EDGE);
        }
    }
    for &[a, b] in &marks.edges {
        canvas.line(lifted(a, 2.0), lifted(b, 2.0), 2.0 * samples, MARK);
    }
    for &vertex in &marks.vertices {
        canvas.dot(lifted(vertex, 2.0), 5.0 * samples, MARK);
    }
    Picture::downsampled(view.size, &canvas)
}

/// The position of a vertex, NaN if there is none.
fn position(frame: &Frame, vertex: u32) -> Point {
    let position = frame.positions.get(vertex as usize).copied();
    position.unwrap_or([f64::NAN; 3])
}

/// A colour with a brightness between 0 and 1.
fn dimmed(colour: Colour, brightness: f64) -> Colour {
    colour.map(|x| (f64::from(x) * brightness) as u8)
}

/// The connected parts of a mesh, numbered in the order of their first faces, then of their first rods. All
/// points are the last part.
struct Parts {
    /// The vertices of faces and edges, increasing.
    vertices: Vec<u32>,
    /// The part of each of them.
    parts: Vec<usize>,
    count: usize,
}

impl Parts {
    fn new(mesh: &TriangleMesh) -> Self {
        // Memory is proportional to the faces and edges, and all indices are below the count.
        let (mesh, vertices) = mesh.without_unused_vertices();
        let components = mesh.components();
        let mut numbers = HashMap::new();
        let first_corners = mesh.faces().iter().map(|face| face[0]);
        for vertex in first_corners.chain(mesh.loose_edges().iter().map(|edge| edge[0])) {
            let next = numbers.len();
            numbers.entry(components[vertex as usize]).or_insert(next);
        }
        let part = |component| numbers.get(component).copied().unwrap_or(0);
        let parts = components.iter().map(part).collect();
        let count = numbers.len();
        Self {
            vertices,
            parts,
            count,
        }
    }

    /// The colour of the part of a vertex.
    fn colour(&self, vertex: u32) -> Colour {
        let place = self.vertices.binary_search(&vertex);
        let part = place.map_or(self.count, |place| self.parts[place]);
        SURFACES[part % SURFACES.len()]
    }
}

/// A direction from above the viewer's right shoulder.
fn light(view: &View) -> Point {
    let [right, up, towards] = view.axes;
    let sum = [0, 1, 2].map(|axis: usize| 0.3 * right[axis] + 0.5 * up[axis] + towards[axis]);
    unit(sum).unwrap_or(towards)
}

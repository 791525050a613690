//! A frame as a picture: flat shading, the edges of the mesh, and what is marked.

use std::collections::HashMap;

use exact_ccd_mesh::{Frame, Point, TriangleMesh};

use crate::canvas::{Canvas, Colour};
use crate::marks::Marks;
use crate::picture::Picture;
use crate::view::{View, cross, dot, minus, unit};

const BACKGROUND: Colour = [255, 255, 255];
/// Those of the connected parts of a mesh, in turn.
const SURFACES: [Colour; 5] = [
    [166, 189, 219],
    [253, 205, 160],
    [171, 217, 180],
    [203, 190, 226],
    [248, 226, 140],
];
const EDGE: Colour = [70, 80, 100];
const MARK: Colour = [215, 48, 39];

/// How many samples a pixel has along each axis.
pub(crate) const SAMPLES: usize = 2;

/// How much nearer to the viewer lines are taken to be than the faces that they bound, in pixels.
const LIFT: f64 = 0.5;

/// Edges that are shorter than this in the mean, in pixels, are not drawn: they would hide the faces.
const SHORTEST: f64 = 5.0;

/// The picture of a frame.
///
/// Connected parts have colours of their own. Faces are lit from behind the viewer's shoulder, from either side. What is marked is red, and lies on top of what is as
/// near; marked edges and vertices are wider. A vertex that is out of the range of `f64` once it is projected is left out,
/// with all that has it.
#[must_use]
pub fn render(frame: &Frame, view: &View, marks: &Marks) -> Picture {
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
    let mut is_marked = vec![false; frame.mesh.faces().len()];
    for &face in &marks.faces {
        if let Some(marked) = is_marked.get_mut(face as usize) {
            *marked = true;
        }
    }
    let parts = parts(&frame.mesh);
    for ((face, is_marked), part) in frame.mesh.faces().iter().zip(is_marked).zip(parts) {
        let colour = if is_marked {
            MARK
        } else {
            SURFACES[part % SURFACES.len()]
        };
        let [a, b, c] = face.map(|vertex| frame.positions[vertex as usize]);
        let normal = unit(cross(minus(b, a), minus(c, a)));
        let brightness = 0.35 + 0.65 * normal.map_or(0.0, |normal| dot(normal, light).abs());
        canvas.triangle(face.map(at), colour.map(|x| (f64::from(x) * brightness) as u8));
    }
    let lifted = |vertex: u32, times: f64| {
        let [x, y, near] = at(vertex);
        [x, y, near + times * LIFT * samples]
    };
    let edges = frame.mesh.edges();
    let lengths = edges
        .iter()
        .map(|edge| edge.map(at))
        .map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1]));
    if lengths.filter(|length| length.is_finite()).sum::<f64>() >= SHORTEST * samples * edges.len() as f64 {
        for &[a, b] in edges {
            canvas.line(lifted(a, 1.0), lifted(b, 1.0), 1.0, EDGE);
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

/// The number of the connected part that each face belongs to, in the order of their first faces.
fn parts(mesh: &TriangleMesh) -> Vec<usize> {
    let mut parent: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
    let root = |parent: &mut [u32], mut vertex: u32| {
        while parent[vertex as usize] != vertex {
            parent[vertex as usize] = parent[parent[vertex as usize] as usize];
            vertex = parent[vertex as usize];
        }
        vertex
    };
    for &[a, b] in mesh.edges() {
        let [a, b] = [a, b].map(|vertex| root(&mut parent, vertex));
        parent[a as usize] = b;
    }
    let mut numbers = HashMap::new();
    let number = |[vertex, ..]: &[u32; 3]| {
        let next = numbers.len();
        *numbers.entry(root(&mut parent, *vertex)).or_insert(next)
    };
    mesh.faces().iter().map(number).collect()
}

/// A direction from above the viewer's right shoulder.
fn light(view: &View) -> Point {
    let [right, up, towards] = view.axes;
    let sum = [0, 1, 2].map(|axis: usize| 0.3 * right[axis] + 0.5 * up[axis] + towards[axis]);
    unit(sum).unwrap_or(towards)
}

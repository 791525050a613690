//! The closest features of a vertex and a face, and of two edges, by the position of the first
//! primitive.

use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexFace};

use crate::drawing::{Drawing, Pixel};

type Place = [f64; 2];

/// The height of the first primitive over the second.
const HEIGHT: f64 = 0.5;
/// Half of the width of a panel, in units and in cells.
const HALF: f64 = 3.0;
const CELLS: i32 = 60;
/// Pixels per unit.
const SCALE: f64 = 60.0;

const FACE: [Place; 3] = [[-1.4, -1.0], [1.5, -0.7], [0.0, 1.5]];
/// The edges a, around its middle, and b.
const EDGES: [[Place; 2]; 2] = [[[-1.1, -0.5], [1.1, 0.5]], [[-0.5, 1.0], [0.5, -1.0]]];

pub(crate) fn figure() -> Result<String, exact_ccd::NonFinite> {
    let mut drawing = Drawing::new("The closest features of two primitives", [800, 470]);
    let lift = |[x, y]: Place| [x, y, 0.0];
    let vertex = |[x, y]: Place| {
        let [v1, v2, v3] = FACE.map(lift);
        closest::<VertexFace>([[x, y, HEIGHT], v1, v2, v3])
    };
    let edge = |[x, y]: Place| {
        let ([a0, a1], [b0, b1]) = (
            EDGES[0].map(|[right, up]| [x + right, y + up, HEIGHT]),
            EDGES[1].map(lift),
        );
        closest::<EdgeEdge>([a0, a1, b0, b1])
    };
    let [left, right] = [[200.0, 240.0], [600.0, 240.0]];
    draw_cells(&mut drawing, left, |place| Ok(of_face(vertex(place)?)))?;
    draw_cells(&mut drawing, right, |place| Ok(of_edges(edge(place)?)))?;
    let [v1, v2, v3] = FACE.map(|place| see(left, place));
    drawing.line("black", &[v1, v2, v3, v1]);
    for (corner, name, below) in [(v1, "v₁", 18.0), (v2, "v₂", 18.0), (v3, "v₃", -10.0)] {
        drawing.dot("dot", corner);
        drawing.text("small middle", [corner[0], corner[1] + below], name);
    }
    drawing.line("black wide", &EDGES[1].map(|place| see(right, place)));
    // The positions of a at which one of its ends is over one of b.
    let corners = [[0, 0], [0, 1], [1, 1], [1, 0], [0, 0]].map(|[i, j]: [usize; 2]| {
        let (a, b) = (EDGES[0][i], EDGES[1][j]);
        see(right, [b[0] - a[0], b[1] - a[1]])
    });
    drawing.line("black", &corners);
    drawing.line(
        "orange wide",
        &EDGES[0].map(|place| see(right, [place[0] + 1.7, place[1] + 2.1])),
    );
    drawing.text("small", see(right, [1.95, 1.8]), "edge a");
    drawing.text("small", see(right, [0.2, -0.1]), "edge b");
    for (center, title) in [
        (left, "Vertex p over a face"),
        (right, "Middle of edge a over edge b"),
    ] {
        drawing.text("bold middle", [center[0], 40.0], title);
    }
    let legend = [
        ("pair", "two vertices"),
        ("side", "vertex and edge"),
        ("cell-end", "inner points"),
    ];
    for (place, (class, name)) in [150.0, 330.0, 530.0].into_iter().zip(legend) {
        draw_cell(&mut drawing, class, [place, 443.0], [12.0; 2]);
        drawing.text("small", [place + 20.0, 454.0], name);
    }
    Ok(drawing.finish())
}

/// The parameters (u, v) of the closest points of primitives at rest.
fn closest<K: Kind<Points = [Point; 4]>>(points: [Point; 4]) -> Result<[f64; 2], exact_ccd::NonFinite> {
    let far = Separation::new(100.0).expect("100 is finite");
    let impact = Query::<K>::new(points, points)?.impact(far);
    Ok(impact.expect("the primitives are less than 100 apart").parameters)
}

/// The class of a pair of features.
fn of_face([u, v]: [f64; 2]) -> &'static str {
    class([u == 0.0, v == 0.0, u + v >= 1.0])
}

fn of_edges([u, v]: [f64; 2]) -> &'static str {
    class([u == 0.0 || u == 1.0, v == 0.0 || v == 1.0, false])
}

/// The class of a point of the domain on some of its sides.
fn class(on: [bool; 3]) -> &'static str {
    ["cell-end", "side", "pair"][on.into_iter().filter(|on| *on).count().min(2)]
}

fn see(center: Pixel, [x, y]: Place) -> Pixel {
    [center[0] + SCALE * x, center[1] - SCALE * y]
}

fn draw_cells(
    drawing: &mut Drawing,
    center: Pixel,
    class: impl Fn(Place) -> Result<&'static str, exact_ccd::NonFinite>,
) -> Result<(), exact_ccd::NonFinite> {
    let width = 2.0 * HALF / f64::from(CELLS);
    let at = |index: i32| width * f64::from(index) - HALF;
    for row in 0..CELLS {
        let of_cell = |column: i32| class([at(column) + 0.5 * width, at(row) + 0.5 * width]);
        let mut first = 0;
        for next in 1..=CELLS {
            let class = of_cell(first)?;
            if next == CELLS || of_cell(next)? != class {
                let size = [SCALE * width * f64::from(next - first), SCALE * width];
                draw_cell(drawing, class, see(center, [at(first), at(row + 1)]), size);
                first = next;
            }
        }
    }
    Ok(())
}

/// A rectangle, given by its upper left corner and its size.
fn draw_cell(drawing: &mut Drawing, class: &str, [x, y]: Pixel, [width, height]: Pixel) {
    let corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
    drawing.shaded(class, 0.5, &corners);
}

//! Flat patches of all shapes. Both pairs of triangles cover each region equally often modulo 2.

use crate::drawing::{Drawing, Pixel};
use crate::patch::Patch;
use crate::tetrahedron::{AROUND_02, AROUND_13, Pair};

type Place = [f64; 2];

/// A shape of the closed polygon through the corners.
struct Shape {
    name: &'static str,
    corners: [Place; 4],
    /// One point in each region that the edges of the triangles bound.
    places: &'static [Place],
}

const SHAPES: [Shape; 8] = [
    Shape {
        name: "convex",
        corners: [[-2.0, -1.5], [1.5, -2.0], [2.0, 1.0], [-1.0, 2.0]],
        places: &[[1.0, -0.25], [-1.0, 0.0]],
    },
    Shape {
        name: "reflex",
        corners: [[0.0, -0.5], [-2.0, -2.0], [0.0, 2.0], [2.0, -2.0]],
        places: &[[-0.75, -0.5], [0.75, -0.5], [0.0, -1.375]],
    },
    Shape {
        name: "crossing",
        corners: [[-2.0, -1.5], [2.0, 1.5], [1.5, -2.0], [-1.5, 2.0]],
        places: &[[-1.25, 0.25], [1.25, -0.25], [-0.125, -1.0], [0.125, 1.0]],
    },
    Shape {
        name: "straight corner",
        corners: [[-2.0, -1.5], [0.5, -1.5], [2.0, -1.5], [-0.5, 2.0]],
        places: &[[-0.75, -0.5], [0.625, -0.5]],
    },
    Shape {
        name: "spike",
        corners: [[0.5, -1.5], [2.0, -1.5], [-2.0, -1.5], [-0.5, 2.0]],
        places: &[[-0.75, -0.5], [0.875, -0.75]],
    },
    Shape {
        name: "neighbours coincide",
        corners: [[-1.5, -1.5], [-1.5, -1.5], [2.0, -1.0], [-0.5, 2.0]],
        places: &[[0.0, -0.25]],
    },
    Shape {
        name: "opposites coincide",
        corners: [[-1.5, -1.5], [2.0, -1.0], [-1.5, -1.5], [-0.5, 2.0]],
        places: &[[0.0, -0.25]],
    },
    Shape {
        name: "on a line",
        corners: [[-2.0, -1.5], [1.0, 0.75], [-1.0, -0.75], [2.0, 1.5]],
        places: &[],
    },
];

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "Flat patches and the pairs of triangles that stand for them",
        [960, 410],
    );
    for (index, shape) in (0u8..).zip(&SHAPES) {
        let [column, row] = [index % 4, index / 4].map(f64::from);
        draw_shape(&mut drawing, [240.0 * column, 205.0 * row], shape);
    }
    drawing.finish()
}

fn draw_shape(drawing: &mut Drawing, [left, top]: Pixel, shape: &Shape) {
    // In the plane z = 1, seen from the origin.
    let signs = Patch(shape.corners.map(|[x, y]| [x, y, 1.0])).signs();
    drawing.text("bold", [left + 12.0, top + 24.0], shape.name);
    drawing.text("small", [left + 12.0, top + 42.0], &signs);
    for (offset, pair, name) in [
        (60.0, AROUND_02, "faces around q₀q₂"),
        (180.0, AROUND_13, "around q₁q₃"),
    ] {
        draw_pair(drawing, [left + offset, top + 112.0], shape, pair);
        drawing.text("small middle", [left + offset, top + 186.0], name);
    }
}

/// Draws the outline of the patch, the region that an odd number of triangles cover, and, in each
/// region, the number of triangles that cover it.
fn draw_pair(drawing: &mut Drawing, center: Pixel, shape: &Shape, pair: Pair) {
    let see = |[x, y]: Place| [center[0] + 18.0 * x, center[1] - 18.0 * y];
    let triangles = pair.map(|triangle| triangle.map(|corner| shape.corners[corner]));
    drawing.areas("odd", &triangles.map(|triangle| triangle.map(see)));
    for [a, b, c] in triangles {
        drawing.line("orange", &[a, b, c, a].map(see));
    }
    let [q0, q1, q2, q3] = shape.corners.map(see);
    drawing.line("black", &[q0, q1, q2, q3, q0]);
    for place in shape.places {
        let covering = covering(&triangles, *place);
        let [x, y] = see(*place);
        drawing.text("bold middle", [x, y + 4.0], &covering.to_string());
    }
    draw_names(drawing, shape, see);
}

/// Draws the names of the corners, away from the mean of the corners, or above the line if there is
/// no region.
fn draw_names(drawing: &mut Drawing, shape: &Shape, see: impl Fn(Place) -> Pixel) {
    let corners = shape.corners;
    let middle = [0, 1].map(|axis: usize| corners.iter().map(|corner| corner[axis]).sum::<f64>() / 4.0);
    for (index, corner) in corners.into_iter().enumerate() {
        let here: Vec<_> = (0..4).filter(|other| corners[*other] == corner).collect();
        if here[0] != index {
            continue;
        }
        let [x, y] = if shape.places.is_empty() {
            [-1.0, 1.0]
        } else {
            [corner[0] - middle[0], corner[1] - middle[1]]
        };
        let length = (x * x + y * y).sqrt();
        let [left, top] = see(corner);
        let place = [left + 12.0 * x / length, top - 11.0 * y / length + 4.0];
        let name: String = here
            .into_iter()
            .map(|other| ["q₀", "q₁", "q₂", "q₃"][other])
            .collect();
        drawing.text("small middle", place, &name);
    }
}

/// The number of triangles that cover a place.
fn covering(triangles: &[[Place; 3]; 2], place: Place) -> usize {
    let turn =
        |a: Place, b: Place| (a[0] - place[0]) * (b[1] - place[1]) - (a[1] - place[1]) * (b[0] - place[0]);
    let covers = |&&[a, b, c]: &&[Place; 3]| {
        let turns = [turn(a, b), turn(b, c), turn(c, a)];
        turns.iter().all(|turn| *turn > 0.0) || turns.iter().all(|turn| *turn < 0.0)
    };
    triangles.iter().filter(covers).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_pairs_cover_a_place_equally_often_modulo_2() {
        for shape in &SHAPES {
            let corners = |triangle: [usize; 3]| triangle.map(|corner| shape.corners[corner]);
            for &place in shape.places {
                let [a, b] = [AROUND_02, AROUND_13].map(|pair| covering(&pair.map(corners), place));
                assert_eq!(a % 2, b % 2, "{}, {place:?}", shape.name);
            }
        }
    }
}

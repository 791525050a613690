//! The directions (1, k, k²), and the planes that reject them, as seen in the plane x = 1.

use exact_ccd::Point;

use crate::drawing::{Drawing, Pixel};
use crate::vectors::cross;

/// The visible part of the plane x = 1: the ranges of y and of z.
const FRAME: [[f64; 2]; 2] = [[-1.8, 3.0], [-1.5, 4.6]];

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new("Directions of rays, and planes that reject them", [640, 400]);
    let see = |[y, z]: [f64; 2]| [130.0 + 60.0 * y, 295.0 - 60.0 * z];
    let planes = planes();
    for plane in &planes {
        drawing.line("thin", &cut(plane).map(see));
    }
    let [down, up] = [-10, 17];
    let parabola: Vec<Pixel> = (down..=up)
        .map(|i| f64::from(i) / 8.0)
        .map(|k| see([k, k * k]))
        .collect();
    drawing.line("green", &parabola);
    for k in [0.0, 1.0, 2.0] {
        let is_rejected = planes.iter().any(|[a, b, c]| a + b * k + c * k * k == 0.0);
        let [x, y] = see([k, k * k]);
        drawing.dot(if is_rejected { "covered" } else { "crossing" }, [x, y]);
        drawing.text("small", [x + 22.0, y + 16.0], &format!("k = {k}"));
    }
    draw_key(&mut drawing);
    drawing.finish()
}

fn draw_key(drawing: &mut Drawing) {
    let rows = [
        ("green", "the directions (1, k, k²)"),
        ("thin", "planes through the origin and two corners"),
    ];
    for (top, (class, text)) in [40.0, 65.0].into_iter().zip(rows) {
        drawing.line(class, &[[362.0, top - 4.0], [378.0, top - 4.0]]);
        drawing.text("small", [388.0, top], text);
    }
    let dots = [("covered", "rejected: in such a plane"), ("crossing", "valid")];
    for (top, (class, text)) in [90.0, 115.0].into_iter().zip(dots) {
        drawing.dot(class, [370.0, top - 4.0]);
        drawing.text("small", [388.0, top], text);
    }
}

/// The planes through the origin and two corners of one face of the cube [−1, 1]³, by their
/// normals, each plane once.
fn planes() -> Vec<Point> {
    let corners: Vec<Point> = (0..8)
        .map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 }))
        .collect();
    let mut planes: Vec<Point> = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        for b in &corners[..i] {
            let plane = cross(*a, *b);
            let is_new = planes.iter().all(|other| cross(plane, *other) != [0.0; 3]);
            if plane != [0.0; 3] && is_new {
                planes.push(plane);
            }
        }
    }
    planes
}

/// The intersection of a plane through the origin with the frame in the plane x = 1.
fn cut([a, b, c]: &Point) -> [[f64; 2]; 2] {
    let [[left, right], [bottom, top]] = FRAME;
    let at_y = |y: f64| [y, -(a + b * y) / c];
    let at_z = |z: f64| [-(a + c * z) / b, z];
    let clip = |y: f64| {
        let [y, z] = at_y(y);
        if z < bottom {
            at_z(bottom)
        } else if z > top {
            at_z(top)
        } else {
            [y, z]
        }
    };
    if *c == 0.0 {
        [at_z(bottom), at_z(top)]
    } else {
        [clip(left), clip(right)]
    }
}

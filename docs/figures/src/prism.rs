//! A vertex that meets a face, one that passes beside it, and the images of both prisms under F.

use std::error::Error;

use exact_ccd::{CONTACT, Point, Query, VertexFace};
use exact_ccd_methods::parity::Rounded;

use crate::drawing::Drawing;
use crate::patch::Patch;
use crate::space::View;
use crate::vectors::{between, minus};

/// The face at t = 0 and at t = 1. It turns as it rises.
const FACE: [[Point; 3]; 2] = [
    [[-3.0, -2.0, -1.0], [3.0, -2.0, -2.0], [0.0, 4.0, -1.0]],
    [[1.0, -4.0, 2.0], [3.0, 3.0, 1.0], [-4.0, 1.0, 1.0]],
];
/// The vertices, likewise.
const MEETS: [Point; 2] = [[0.0, 0.0, 2.0], [-1.0, 0.5, -2.0]];
const PASSES: [Point; 2] = [[5.0, 0.0, 2.0], [4.0, 0.5, -2.0]];

const AWAY: [f64; 2] = [0.4, 0.3];

pub(crate) fn figure() -> Result<String, Box<dyn Error>> {
    let mut drawing = Drawing::new("A vertex and a face, and the image of their prism", [960, 320]);
    draw_motion(&mut drawing)?;
    draw_image(&mut drawing, "p", MEETS, [450.0, 5.5])?;
    draw_image(&mut drawing, "p′", PASSES, [690.0, 9.5])?;
    Ok(drawing.finish())
}

fn query([start, end]: [Point; 2]) -> Result<Query<VertexFace>, Box<dyn Error>> {
    let [[a, b, c], [d, e, f]] = FACE;
    Ok(Query::<VertexFace>::new([start, a, b, c], [end, d, e, f])?)
}

/// Draws the face at both ends of the step and when p meets it, and the paths of both vertices.
fn draw_motion(drawing: &mut Drawing) -> Result<(), Box<dyn Error>> {
    let view = View {
        center: [125.0, 165.0],
        scale: 28.0,
        away: AWAY,
    };
    let impact = query(MEETS)?
        .time_of_impact(CONTACT)
        .ok_or("the vertex meets the face")?;
    let [start, end] = FACE;
    let now = [0, 1, 2].map(|corner: usize| between(start[corner], end[corner], impact));
    for (class, face) in [("start", start), ("now", now), ("end", end)] {
        drawing.area(class, &view.see_all(face));
    }
    for corner in 0..3 {
        drawing.line("thin dashed", &view.see_all([start[corner], end[corner]]));
    }
    for ([from, to], name) in [(MEETS, "p"), (PASSES, "p′")] {
        let [from, to] = view.see_all([from, to]);
        drawing.arrow("black", from, to);
        drawing.text("middle", [from[0], from[1] - 7.0], name);
    }
    drawing.dot("contact", view.see(between(MEETS[0], MEETS[1], impact)));
    let [low, high] = [start[1], end[2]].map(|corner| view.see(corner));
    drawing.text("small", [low[0] - 20.0, low[1] + 16.0], "face, t = 0");
    drawing.text("small", [high[0] - 10.0, high[1] - 8.0], "t = 1");
    drawing.text(
        "middle",
        [140.0, 300.0],
        &format!("p meets the face at t = {impact:.3}"),
    );
    Ok(())
}

/// F at the corners of the prism for a vertex, at t = 0 and at t = 1.
fn corners(vertex: [Point; 2]) -> [[Point; 3]; 2] {
    [0, 1].map(|time: usize| FACE[time].map(|corner| minus(vertex[time], corner)))
}

/// The image of the prism: its faces as patches, with their classes.
fn patches(vertex: [Point; 2]) -> [(&'static str, Patch); 5] {
    let [[a, b, c], [d, e, f]] = corners(vertex);
    [
        ("cell-start", Patch([a, b, c, c])),
        ("cell-end", Patch([d, e, f, f])),
        ("side", Patch([a, b, e, d])),
        ("side", Patch([b, c, f, e])),
        ("side", Patch([c, a, d, f])),
    ]
}

fn crossings(vertex: [Point; 2]) -> Vec<f64> {
    patches(vertex)
        .iter()
        .flat_map(|(_, patch)| patch.crossings())
        .collect()
}

/// Draws the image of the prism for a vertex, with the place of the origin and the length of its ray.
fn draw_image(
    drawing: &mut Drawing,
    name: &str,
    vertex: [Point; 2],
    [left, length]: [f64; 2],
) -> Result<(), Box<dyn Error>> {
    let view = View {
        center: [left, 150.0],
        scale: 27.0,
        away: AWAY,
    };
    view.draw_patches(drawing, 6, &patches(vertex));
    view.draw_ray(drawing, "green dashed", length, crossings(vertex));
    let [[a, b, c], [d, e, f]] = corners(vertex);
    let [high, low] = [a, e].map(|corner| view.see(corner));
    drawing.text("small", [high[0] - 40.0, high[1] - 8.0], "t = 0");
    drawing.text("small", [low[0] - 20.0, low[1] + 16.0], "t = 1");
    let parity = Rounded::check(query(vertex)?)?.parity();
    let middle = [a, b, c, d, e, f]
        .iter()
        .map(|corner| view.see(*corner)[0])
        .sum::<f64>()
        / 6.0;
    let text = format!("{name}: crossings {}, parity {parity:?}", crossings(vertex).len());
    drawing.text("middle", [middle, 300.0], &text);
    Ok(())
}

#[cfg(test)]
mod tests {
    use exact_ccd_methods::parity::Parity;

    use super::*;

    #[test]
    fn the_parity_is_that_of_the_drawn_crossings() {
        for (vertex, parity) in [(MEETS, Parity::Odd), (PASSES, Parity::Even)] {
            assert_eq!(Rounded::check(query(vertex).unwrap()).unwrap().parity(), parity);
            assert_eq!(crossings(vertex).len() % 2 == 1, parity == Parity::Odd);
        }
    }
}

//! The logo: a face at both ends of a step and when a vertex meets it, with the path of the vertex.

use std::error::Error;

use exact_ccd::{CONTACT, Point, Query, VertexFace};

use crate::drawing::Drawing;
use crate::space::View;
use crate::vectors::between;

const FACE: [[Point; 3]; 2] = [
    [[-3.2, -2.0, -2.6], [2.6, -2.0, -2.8], [0.6, 3.0, -0.6]],
    [[-2.8, -2.0, 1.8], [3.0, -2.0, 1.2], [-0.6, 3.0, 2.4]],
];
const VERTEX: [Point; 2] = [[0.4, -0.4, 3.2], [-0.3, -0.4, -3.0]];

pub(crate) fn figure() -> Result<String, Box<dyn Error>> {
    let [[a, b, c], [d, e, f]] = FACE;
    let query = Query::<VertexFace>::new([VERTEX[0], a, b, c], [VERTEX[1], d, e, f])?;
    let impact = query.time_of_impact(CONTACT).ok_or("the vertex meets the face")?;
    let mut drawing = Drawing::new("exact-ccd", [96, 96]);
    let view = View {
        center: [46.0, 48.0],
        scale: 12.0,
        away: [0.3, 0.2],
    };
    let now = [0, 1, 2].map(|corner: usize| between(FACE[0][corner], FACE[1][corner], impact));
    for (class, face) in [("start", FACE[0]), ("now", now), ("end", FACE[1])] {
        drawing.area(class, &view.see_all(face));
    }
    let [from, to] = view.see_all(VERTEX);
    drawing.arrow("black wide", from, to);
    drawing.dot("contact", view.see(between(VERTEX[0], VERTEX[1], impact)));
    Ok(drawing.finish())
}

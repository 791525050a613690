//! Flat patches, swept by an edge in its plane, that cover points around which their outline does not
//! wind.

use std::error::Error;

use exact_ccd::{EdgeEdge, Point, Query};
use exact_ccd_methods::parity::{Parity, Rounded};

use crate::drawing::{Drawing, Pixel};
use crate::patch::Patch;
use crate::vectors::{between, minus};

/// The corners of a patch, and test points.
type Panel = (&'static str, [Point; 4], &'static [Point]);

const PANELS: [Panel; 2] = [
    (
        "crossing",
        [
            [-3.0, 2.5, 0.0],
            [1.5, -2.5, 0.0],
            [3.0, 2.0, 0.0],
            [-0.5, -2.0, 0.0],
        ],
        &[
            [-0.75, -0.5, 0.0],
            [1.75, 0.0, 0.0],
            [0.25, -0.5, 0.0],
            [0.25, 1.5, 0.0],
        ],
    ),
    (
        "reflex",
        [
            [0.0, -0.5, 0.0],
            [-3.0, -2.5, 0.0],
            [0.0, 2.5, 0.0],
            [3.0, -2.5, 0.0],
        ],
        &[[0.0, 1.0, 0.0], [0.0, -0.75, 0.0], [0.0, -1.75, 0.0]],
    ),
];

pub(crate) fn figure() -> Result<String, Box<dyn Error>> {
    let mut drawing = Drawing::new("Flat patches that fold over", [960, 330]);
    for (left, panel) in [(0.0, PANELS[0]), (390.0, PANELS[1])] {
        draw_panel(&mut drawing, left, panel)?;
    }
    let key = [("covered", "Boundary: on the patch"), ("ring", "Even: not on it")];
    for (top, (class, text)) in [250.0, 275.0].into_iter().zip(key) {
        drawing.dot(class, [800.0, top - 4.0]);
        drawing.text("small", [816.0, top], text);
    }
    drawing.line("orange wide", &[[792.0, 296.0], [808.0, 296.0]]);
    drawing.text("small", [816.0, 300.0], "the fold");
    Ok(drawing.finish())
}

fn draw_panel(
    drawing: &mut Drawing,
    left: f64,
    (name, corners, places): Panel,
) -> Result<(), Box<dyn Error>> {
    let see = |[x, y, _]: Point| [left + 200.0 + 52.0 * x, 175.0 - 52.0 * y];
    drawing.text("bold", [left + 12.0, 24.0], name);
    let patch = Patch(corners);
    for cell in patch.cells(12) {
        drawing.area("swept", &cell.map(see));
    }
    let [q0, q1, q2, q3] = corners.map(see);
    drawing.line("black", &[q0, q1, q2, q3, q0]);
    let fold: Vec<Pixel> = fold(&patch).into_iter().map(see).collect();
    drawing.line("orange wide", &fold);
    for &place in places {
        let class = if parity(place, corners)? == Parity::Boundary {
            "covered"
        } else {
            "ring"
        };
        drawing.dot(class, see(place));
    }
    Ok(())
}

/// The parity of a query in which one edge ends at a point of the plane, and the other sweeps the patch.
fn parity(place: Point, [q0, q1, q2, q3]: [Point; 4]) -> Result<Parity, Box<dyn Error>> {
    let above = [place[0], place[1], 1.0];
    let query = Query::<EdgeEdge>::new([place, above, q0, q1], [place, above, q3, q2])?;
    Ok(Rounded::check(query)?.parity())
}

/// The image of the line in (s, r) on which the patch folds: there its derivatives are parallel.
fn fold(patch: &Patch) -> Vec<Point> {
    let [q0, q1, q2, q3] = patch.0;
    // Linear in s and r: the terms with s r cancel.
    let turn = |s: f64, r: f64| {
        let [a, b] = [
            between(minus(q1, q0), minus(q2, q3), r),
            between(minus(q3, q0), minus(q2, q1), s),
        ];
        a[0] * b[1] - a[1] * b[0]
    };
    let [j, along_s, along_r] = [
        turn(0.0, 0.0),
        turn(1.0, 0.0) - turn(0.0, 0.0),
        turn(0.0, 1.0) - turn(0.0, 0.0),
    ];
    let s_at = |r: f64| (-(j + along_r * r) / along_s).clamp(0.0, 1.0);
    (0..=24)
        .map(|i| s_at(0.0) + (s_at(1.0) - s_at(0.0)) * f64::from(i) / 24.0)
        .map(|s| patch.at(s, -(j + along_s * s) / along_r))
        .collect()
}

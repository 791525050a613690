//! Two edges that pass through each other and back, graze, or do not touch. The parity is even in all
//! cases.

use std::error::Error;

use exact_ccd::{CONTACT, EdgeEdge, Point, Query};
use exact_ccd_methods::parity::Rounded;

use crate::drawing::Drawing;
use crate::space::View;
use crate::vectors::{between, cross, dot, minus};

/// An edge a that rotates about its midpoint, which is at a fixed height, and an edge b that slides along
/// below it.
fn query(height: f64) -> Result<Query<EdgeEdge>, Box<dyn Error>> {
    let [high, low] = [height + 1.0, height - 1.0];
    Ok(Query::<EdgeEdge>::new(
        [
            [-2.0, 0.0, high],
            [2.0, 0.0, low],
            [-1.0, -2.5, 0.0],
            [-1.0, 2.5, 0.0],
        ],
        [
            [-2.0, 0.0, low],
            [2.0, 0.0, high],
            [1.0, -2.5, 0.0],
            [1.0, 2.5, 0.0],
        ],
    )?)
}

/// The heights for which graphs are drawn, and in which class.
const GRAPHS: [(f64, &str); 3] = [(0.125, "thin"), (0.0, "thin"), (-0.125, "black")];

pub(crate) fn figure() -> Result<String, Box<dyn Error>> {
    let mut drawing = Drawing::new("Two edges that pass through each other and back", [960, 350]);
    let passes = query(-0.125)?;
    for (column, t) in (0u8..).zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
        draw_edges(&mut drawing, &passes, t, 96.0 + 192.0 * f64::from(column));
    }
    draw_graphs(&mut drawing)?;
    Ok(drawing.finish())
}

/// The four points at a time.
fn at(query: &Query<EdgeEdge>, t: f64) -> [Point; 4] {
    let [start, end] = query.points();
    [0, 1, 2, 3].map(|i: usize| between(start[i], end[i], t))
}

/// c(t) = (a₀ − b₀) · ((a₁ − a₀) × (b₁ − b₀)), positive here where a is above b.
fn coplanarity(query: &Query<EdgeEdge>, t: f64) -> f64 {
    let [a0, a1, b0, b1] = at(query, t);
    dot(minus(a0, b0), cross(minus(a1, a0), minus(b1, b0)))
}

fn times(query: &Query<EdgeEdge>) -> Vec<f64> {
    let intervals = query.intervals(CONTACT);
    intervals.iter().map(|interval| interval.start.lower()).collect()
}

/// The edges at a time, the upper one in front.
fn draw_edges(drawing: &mut Drawing, query: &Query<EdgeEdge>, t: f64, left: f64) {
    let view = View {
        center: [left, 95.0],
        scale: 34.0,
        away: [0.3, 0.45],
    };
    let [a0, a1, b0, b1] = at(query, t);
    let [a, b] = [("blue wide", [a0, a1]), ("orange wide", [b0, b1])];
    let c = coplanarity(query, t);
    for (class, edge) in if c > 0.0 { [b, a] } else { [a, b] } {
        if c != 0.0 {
            drawing.line("halo", &view.see_all(edge));
        }
        drawing.line(class, &view.see_all(edge));
    }
    if times(query).contains(&t) {
        // b crosses the line of a at y = 0.
        drawing.dot("contact", view.see(between(b0, b1, 0.5)));
    }
    drawing.text("middle bold", [left, 24.0], &format!("t = {t}"));
    for (name, end) in [("a₀", a0), ("b₀", b0)] {
        let [x, y] = view.see(end);
        drawing.text("small middle", [x - 6.0, y + 16.0], name);
    }
}

/// c over t for each height, with the contacts, their number and the parity.
fn draw_graphs(drawing: &mut Drawing) -> Result<(), Box<dyn Error>> {
    let see = |t: f64, c: f64| [120.0 + 480.0 * t, 300.0 - 6.4 * c];
    drawing.arrow("thin", see(-0.02, 0.0), see(1.08, 0.0));
    drawing.text("small", see(1.09, -0.4), "t");
    drawing.text("small", [80.0, 225.0], "c(t)");
    for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let [x, y] = see(t, 0.0);
        drawing.line("thin", &[[x, y], [x, y + 5.0]]);
        drawing.text("small middle", [x, y + 34.0], &t.to_string());
    }
    for (height, class) in GRAPHS {
        let query = query(height)?;
        let c = |t: f64| coplanarity(&query, t);
        let graph: Vec<_> = (0..=40)
            .map(|i| f64::from(i) / 40.0)
            .map(|t| see(t, c(t)))
            .collect();
        drawing.line(class, &graph);
        let times = times(&query);
        for &t in &times {
            drawing.dot("contact", see(t, c(t)));
        }
        let parity = Rounded::check(query)?.parity();
        let [x, y] = see(1.0, c(1.0));
        let text = format!("contacts {}, parity {parity:?}", times.len());
        drawing.text("small", [x + 14.0, y + 4.0], &text);
    }
    Ok(())
}

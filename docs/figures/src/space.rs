//! The projection of points and patches in space.

use exact_ccd::Point;

use crate::drawing::{Drawing, Pixel};
use crate::patch::Patch;
use crate::vectors::{cross, dot, minus};

/// An oblique projection: x to the right, z up, y away.
#[derive(Clone, Copy)]
pub(crate) struct View {
    /// The pixel of the point 0.
    pub(crate) center: Pixel,
    /// Pixels per unit.
    pub(crate) scale: f64,
    /// The displacement of a unit of y, in units to the right and up.
    pub(crate) away: [f64; 2],
}

impl View {
    pub(crate) fn see(&self, [x, y, z]: Point) -> Pixel {
        let [right, up] = [x + self.away[0] * y, z + self.away[1] * y];
        [
            self.center[0] + self.scale * right,
            self.center[1] - self.scale * up,
        ]
    }

    pub(crate) fn see_all<const N: usize>(&self, points: [Point; N]) -> [Pixel; N] {
        points.map(|point| self.see(point))
    }

    /// Draws patches of the stated classes, cut into n × n cells, from back to front. A cell is
    /// fainter the more it is turned away from the light.
    pub(crate) fn draw_patches(&self, drawing: &mut Drawing, n: u32, patches: &[(&str, Patch)]) {
        let mut cells: Vec<_> = patches
            .iter()
            .flat_map(|(class, patch)| patch.cells(n).into_iter().map(move |cell| (*class, cell)))
            .collect();
        let depth = |cell: &[Point; 4]| cell.iter().map(|corner| corner[1]).sum::<f64>();
        cells.sort_by(|(_, a), (_, b)| depth(b).total_cmp(&depth(a)));
        for (class, cell) in cells {
            drawing.shaded(class, 0.3 + 0.55 * brightness(cell), &self.see_all(cell));
        }
    }

    /// Draws the origin and the ray from it along x, to a length, with its crossings; in the class
    /// `odd` where an odd number of crossings follows.
    pub(crate) fn draw_ray(&self, drawing: &mut Drawing, odd: &str, length: f64, mut crossings: Vec<f64>) {
        crossings.sort_by(f64::total_cmp);
        let at = |x: f64| self.see([x, 0.0, 0.0]);
        let mut from = 0.0;
        for (index, &x) in crossings.iter().enumerate() {
            let is_odd = (crossings.len() - index) % 2 == 1;
            drawing.line(if is_odd { odd } else { "green" }, &[at(from), at(x)]);
            from = x;
        }
        drawing.arrow("green", at(from), at(length));
        drawing.dot("dot", at(0.0));
        for x in crossings {
            drawing.dot("crossing", at(x));
        }
    }
}

/// The brightness of a cell, from 0 to 1.
fn brightness([a, b, c, d]: [Point; 4]) -> f64 {
    const LIGHT: Point = [-0.6, -0.48, 0.64];
    let normal = cross(minus(c, a), minus(d, b));
    dot(LIGHT, normal).abs() / dot(normal, normal).sqrt()
}

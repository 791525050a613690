//! A raster of pixels with a depth buffer: triangles, lines and dots.

use std::ops::Range;

use exact_ccd_mesh::Point;

pub(crate) type Colour = [u8; 3];

/// Pixels, row by row from the top.
///
/// A point of the picture is x and y, in pixels from the top left corner, and its nearness to the
/// viewer.
pub(crate) struct Canvas {
    size: [usize; 2],
    pub(crate) colours: Vec<Colour>,
    nearness: Vec<f64>,
}

impl Canvas {
    pub(crate) fn new(size: [usize; 2], background: Colour) -> Self {
        let count = size[0] * size[1];
        Self {
            size,
            colours: vec![background; count],
            nearness: vec![f64::NEG_INFINITY; count],
        }
    }

    fn set(&mut self, x: usize, y: usize, near: f64, colour: Colour) {
        let index = y * self.size[0] + x;
        if x < self.size[0] && y < self.size[1] && near > self.nearness[index] {
            self.nearness[index] = near;
            self.colours[index] = colour;
        }
    }

    /// The pixels along an axis whose centers are between two coordinates.
    fn pixels(&self, axis: usize, low: f64, high: f64) -> Range<usize> {
        // The conversion rounds down and saturates.
        let first = (low + 0.5).max(0.0) as usize;
        first..((high + 0.5).max(0.0) as usize).min(self.size[axis])
    }

    /// Fills the pixels whose centers are in a triangle.
    pub(crate) fn triangle(&mut self, corners: [Point; 3], colour: Colour) {
        let [a, b, c] = corners;
        let turn =
            |p: Point, q: Point, x: f64, y: f64| (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
        let area = turn(a, b, c[0], c[1]);
        if !(area.is_finite() && area != 0.0) {
            return;
        }
        let extent = |axis: usize| {
            let coordinates = corners.map(|p| p[axis]);
            let low = coordinates.into_iter().fold(f64::INFINITY, f64::min);
            let high = coordinates.into_iter().fold(f64::NEG_INFINITY, f64::max);
            self.pixels(axis, low, high)
        };
        let (columns, rows) = (extent(0), extent(1));
        for row in rows {
            for column in columns.clone() {
                let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
                let weights = [turn(b, c, x, y), turn(c, a, x, y), turn(a, b, x, y)].map(|turn| turn / area);
                if weights.iter().all(|&weight| weight >= 0.0) {
                    let near = weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2];
                    self.set(column, row, near, colour);
                }
            }
        }
    }

    /// Draws a line with a width in pixels.
    pub(crate) fn line(&mut self, a: Point, b: Point, width: f64, colour: Colour) {
        let Some([from, to]) = self.clip(a, b, width) else {
            return;
        };
        let at = |s: f64| [0, 1, 2].map(|axis: usize| (1.0 - s) * a[axis] + s * b[axis]);
        let [start, end] = [at(from), at(to)];
        // The number of steps is bounded by the size of the picture, because the line is clipped.
        let steps = (end[0] - start[0]).abs().max((end[1] - start[1]).abs()).ceil();
        for step in 0..=steps as usize {
            let s = from + (to - from) * step as f64 / steps.max(1.0);
            self.dot(at(s), width, colour);
        }
    }

    /// Draws a square with a width in pixels.
    pub(crate) fn dot(&mut self, [x, y, near]: Point, width: f64, colour: Colour) {
        for row in self.pixels(1, y - 0.5 * width, y + 0.5 * width) {
            for column in self.pixels(0, x - 0.5 * width, x + 0.5 * width) {
                self.set(column, row, near, colour);
            }
        }
    }

    /// Draws a ball with a radius in pixels. `colour` is the colour of a point of its surface, given the
    /// components of the normal to the right, upwards and towards the viewer.
    pub(crate) fn ball(&mut self, [x, y, near]: Point, radius: f64, colour: &impl Fn(Point) -> Colour) {
        for row in self.pixels(1, y - radius, y + radius) {
            for column in self.pixels(0, x - radius, x + radius) {
                let right = (column as f64 + 0.5 - x) / radius;
                let up = (y - row as f64 - 0.5) / radius;
                let squared = 1.0 - right * right - up * up;
                if squared >= 0.0 {
                    let towards = squared.sqrt();
                    self.set(column, row, near + radius * towards, colour([right, up, towards]));
                }
            }
        }
    }

    /// Draws a tube between two points as a row of balls, with a radius in pixels at each point.
    pub(crate) fn tube(&mut self, [a, b]: [Point; 2], radii: [f64; 2], colour: impl Fn(Point) -> Colour) {
        let Some([from, to]) = self.clip(a, b, radii[0].max(radii[1])) else {
            return;
        };
        let mix = |a: f64, b: f64, s: f64| a + (b - a) * s;
        let length = (to - from) * (b[0] - a[0]).abs().max((b[1] - a[1]).abs());
        // The part in and near the picture is short, unless the balls are larger than the picture.
        let most = 4.0 * (self.size[0] + self.size[1]) as f64;
        let steps = length.ceil().clamp(1.0, most.max(1.0));
        for step in 0..=steps as usize {
            let s = mix(from, to, step as f64 / steps);
            let center = [0, 1, 2].map(|axis: usize| mix(a[axis], b[axis], s));
            self.ball(center, mix(radii[0], radii[1], s), &colour);
        }
    }

    /// The part of a line in the picture extended by `margin` on each side, with 0 at `a` and 1 at `b`.
    fn clip(&self, a: Point, b: Point, margin: f64) -> Option<[f64; 2]> {
        let mut part = [0.0, 1.0];
        for axis in 0..2 {
            let (low, high) = (-margin, self.size[axis] as f64 + margin);
            let length = b[axis] - a[axis];
            if !length.is_finite() {
                return None;
            }
            if length == 0.0 {
                if !(low..=high).contains(&a[axis]) {
                    return None;
                }
                continue;
            }
            let (s, t) = ((low - a[axis]) / length, (high - a[axis]) / length);
            part = [f64::max(part[0], s.min(t)), f64::min(part[1], s.max(t))];
        }
        (part[0] <= part[1]).then_some(part)
    }
}

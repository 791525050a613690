//! Boxes around the paths of points.

use super::corners::{Corners, Curves};
use super::relative::Relative;
use crate::environment;
use crate::tables::{Point, VertexVertex};

impl Relative {
    /// The least and the greatest coordinates of a box that contains the path of a point of the first body,
    /// in the coordinates of the second one; `None` if the filters have no bound.
    ///
    /// The path is a rational Bézier curve. In a part of the step in which the control points of w are
    /// positive, it lies in the hull of the quotients of both. There are four parts.
    pub(crate) fn bounds(&self, point: Point) -> Option<[Point; 2]> {
        if !environment::is_default() {
            return None;
        }
        let origin = [0.0; 3];
        let corners = Corners::of_bodies::<VertexVertex>(&[point, point, origin, origin], self)?;
        let [first, second] = corners.curves.halves();
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for part in [first.halves(), second.halves()].as_flattened() {
            corners.add_quotients(part, &mut bounds)?;
        }
        Some(bounds)
    }
}

impl Corners {
    /// Adds the quotients X / w of the control points of the first corner in a quarter of the step, with all
    /// errors, if w is positive.
    fn add_quotients(&self, part: &Curves, [lower, upper]: &mut [Point; 2]) -> Option<()> {
        let error = self.error(2 * (part.points as u32 - 1));
        for (point, &weight) in part.corner(0).iter().zip(&part.weight) {
            let slack = self.weight_magnitude * error;
            let weights = [(weight - slack).next_down(), (weight + slack).next_up()];
            // Also if it is not a number.
            if weights[0].is_nan() || weights[0] <= 0.0 {
                return None;
            }
            for axis in 0..3 {
                let slack = self.magnitude[axis] * error;
                let least = (point[axis] - slack).next_down();
                let greatest = (point[axis] + slack).next_up();
                for weight in weights {
                    lower[axis] = lower[axis].min((least / weight).next_down());
                    upper[axis] = upper[axis].max((greatest / weight).next_up());
                }
            }
        }
        Some(())
    }
}

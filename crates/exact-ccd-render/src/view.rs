//! The projection from space to the picture.

use exact_ccd_mesh::vector::{cross, dot, unit};
use exact_ccd_mesh::{Aabb, Point};

/// A parallel projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Unit vectors to the right, upwards and towards the viewer.
    pub(crate) axes: [Point; 3],
    /// The coordinates of the center of the picture along the axes.
    middle: Point,
    /// Pixels per unit of length.
    pub(crate) scale: f64,
    /// Width and height in pixels.
    pub(crate) size: [u16; 2],
}

impl View {
    /// The fraction of the picture that the box fills, along the axis on which it fills more.
    const FILL: f64 = 0.9;

    /// A view in which a box fills a picture with this width and height in pixels, and the z axis
    /// points upwards.
    ///
    /// `towards` is the direction from the box to the viewer. If it is zero or not finite, the view
    /// is from above.
    #[must_use]
    pub fn of(bounds: &Aabb, towards: Point, size: [u16; 2]) -> Self {
        Self::upright(bounds, [0.0, 0.0, 1.0], towards, size)
    }

    /// As [`of`](Self::of), with another direction upwards.
    ///
    /// If `up` is zero, not finite or parallel to `towards`, the y axis points upwards, or else the
    /// z axis.
    #[must_use]
    pub fn upright(bounds: &Aabb, up: Point, towards: Point, size: [u16; 2]) -> Self {
        let ends = [bounds.lower, bounds.upper];
        let corner = |corner: usize| [0, 1, 2].map(|axis: usize| ends[corner >> axis & 1][axis]);
        let camera = Camera::new(up, towards);
        camera.view(&camera.extent((0..8).map(|index| (corner(index), 0.0))), size)
    }

    /// The projection of a point: pixels from the left, pixels from the top, and nearness to the
    /// viewer, in pixels.
    pub(crate) fn project(&self, point: Point) -> Point {
        let coordinates = along(&self.axes, point);
        let [x, y, z] = [0, 1, 2].map(|axis: usize| self.scale * (coordinates[axis] - self.middle[axis]));
        let [width, height] = self.size.map(f64::from);
        [0.5 * width + x, 0.5 * height - y, z]
    }
}

/// The directions of a parallel projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Unit vectors to the right, upwards and towards the viewer.
    axes: [Point; 3],
}

impl Camera {
    /// The camera whose pictures have a direction upwards, with the direction towards the viewer. Zero,
    /// infinite and parallel vectors are replaced as in [`View::upright`].
    #[must_use]
    pub fn new(up: Point, towards: Point) -> Self {
        let [y, z] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let towards = unit(towards).or_else(|| unit(up)).unwrap_or(z);
        let right = [unit(up).unwrap_or(y), y, z].map(|up| cross(up, towards));
        let right = right.into_iter().find_map(unit).unwrap_or([1.0, 0.0, 0.0]);
        Self {
            axes: [right, cross(towards, right), towards],
        }
    }

    /// The smallest box around balls, given by their centers and radii, with sides along the directions of
    /// the camera: its axes point to the right, upwards and towards the viewer.
    pub fn extent(&self, balls: impl IntoIterator<Item = (Point, f64)>) -> Aabb {
        let ball = |(center, radius)| Aabb::of(along(&self.axes, center)).inflated(radius);
        balls.into_iter().map(ball).fold(Aabb::EMPTY, |a, b| a.union(&b))
    }

    /// The view in which an [extent](Self::extent) fills a picture with this width and height in pixels.
    #[must_use]
    pub fn view(&self, extent: &Aabb, size: [u16; 2]) -> View {
        let fits =
            |axis: usize| View::FILL * f64::from(size[axis]) / (extent.upper[axis] - extent.lower[axis]);
        let scale = f64::min(fits(0), fits(1));
        View {
            axes: self.axes,
            middle: [0, 1, 2].map(|axis| 0.5 * extent.lower[axis] + 0.5 * extent.upper[axis]),
            scale: if scale.is_finite() { scale } else { 1.0 },
            size,
        }
    }
}

fn along(axes: &[Point; 3], point: Point) -> Point {
    axes.map(|axis| dot(axis, point))
}

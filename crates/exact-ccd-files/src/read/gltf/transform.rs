//! The transforms of nodes, in `f64`.

use exact_ccd_mesh::Point;

use super::document::Node;
use crate::error::Fault;

/// An affine map in the rows of a 3×4 matrix.
///
/// The numbers of the file are the nearest `f64`; each product and each sum of the maps and of their
/// application is rounded to the nearest `f64`, from left to right. The identity changes no bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform([[f64; 4]; 3]);

impl Default for Transform {
    fn default() -> Self {
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]])
    }
}

impl Transform {
    /// The map from the coordinates of a node, of this index, to those of its parent. A translation of a
    /// motion is in the place of its own.
    pub(super) fn of(node: &Node, index: u32, moved: Option<&Point>) -> Result<Self, Fault> {
        if let Some(matrix) = &node.matrix {
            // By columns.
            let (columns, _) = matrix.as_chunks::<4>();
            if columns.iter().map(|column| column[3]).ne([0.0, 0.0, 0.0, 1.0]) {
                let expected = format!("0 0 0 1 as the last row of the matrix of node {index}");
                return Err(Fault::expected(expected, "other numbers"));
            }
            let row = |axis: usize| std::array::from_fn(|k| columns[k][axis]);
            return Ok(Self([row(0), row(1), row(2)]));
        }
        let translation = moved.or(node.translation.as_deref());
        let rotation = node.rotation.as_deref().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let scale = node.scale.as_deref().copied().unwrap_or([1.0; 3]);
        Ok(Self::of_parts(
            translation.copied().unwrap_or_default(),
            rotation,
            scale,
        ))
    }

    /// The map T R S: first the scale, then the rotation, then the translation.
    pub(super) fn of_parts(translation: Point, rotation: [f64; 4], [sx, sy, sz]: [f64; 3]) -> Self {
        let axes = rotation_of(rotation);
        let row = |k: usize| {
            let [x, y, z] = axes[k];
            [x * sx, y * sy, z * sz, translation[k]]
        };
        Self([row(0), row(1), row(2)])
    }

    /// The map of a node within a node with this map.
    pub(super) fn then(&self, inner: &Self) -> Self {
        if *self == Self::default() {
            return *inner;
        }
        if *inner == Self::default() {
            return *self;
        }
        let rows = self.0.map(|[a, b, c, d]| {
            let mut row: [f64; 4] =
                std::array::from_fn(|k| a * inner.0[0][k] + b * inner.0[1][k] + c * inner.0[2][k]);
            row[3] += d;
            row
        });
        Self(rows)
    }

    pub(super) fn apply(&self, point: Point) -> Point {
        if *self == Self::default() {
            return point;
        }
        let [x, y, z] = point;
        self.0.map(|[a, b, c, d]| a * x + b * y + c * z + d)
    }
}

/// The rotation of a quaternion x, y, z, w of length 1, by rows.
fn rotation_of([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

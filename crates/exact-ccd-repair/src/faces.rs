//! The shapes of faces, in numbers.

use exact_ccd_mesh::vector::{cross, dot, minus};
use exact_ccd_mesh::{Point, TriangleMesh};

/// Two faces with a common side that only they have.
pub(crate) struct Neighbours {
    faces: [u32; 2],
    /// True if they run through the side in opposite directions: their normals are on the same side of the
    /// surface.
    is_oriented: bool,
}

/// All pairs of faces with a common side that only they have.
pub(crate) fn neighbours(mesh: &TriangleMesh) -> Vec<Neighbours> {
    let mut sides = Vec::with_capacity(3 * mesh.faces().len());
    for (face, &[a, b, c]) in (0..).zip(mesh.faces()) {
        let of_face = [[a, b], [b, c], [c, a]];
        sides.extend(of_face.map(|[a, b]| ([a.min(b), a.max(b)], face, a < b)));
    }
    sides.sort_unstable();
    let of_side = sides.chunk_by(|(side, ..), (other, ..)| side == other);
    let pair = |sides: &[([u32; 2], u32, bool)]| match *sides {
        [(_, first, along), (_, second, other)] => Some(Neighbours {
            faces: [first, second],
            is_oriented: along != other,
        }),
        _ => None,
    };
    of_side.filter_map(pair).collect()
}

impl Neighbours {
    /// Returns true if the normals are at an angle above 90° in positions `after`, and were not in positions
    /// `before`, in which the angle was less by more than about a degree. So faces at a right angle may be
    /// moved.
    pub(crate) fn is_new_fold(&self, mesh: &TriangleMesh, [before, after]: [&[Point]; 2]) -> bool {
        let [before, after] = [before, after].map(|x| self.cosine(mesh, x));
        after < 0.0 && before >= 0.0 && before - after > RIGHT
    }

    /// The cosine of the angle between the normals; 0 without a normal.
    fn cosine(&self, mesh: &TriangleMesh, x: &[Point]) -> f64 {
        let [first, second] = self.faces.map(|face| normal(mesh.faces()[face as usize], x));
        let lengths = (dot(first, first) * dot(second, second)).sqrt();
        let product = if lengths > 0.0 {
            dot(first, second) / lengths
        } else {
            0.0
        };
        if self.is_oriented { product } else { -product }
    }
}

/// The sine of one degree.
const RIGHT: f64 = 0.017;

/// The normal of a face, of twice its area as length.
fn normal(corners: [u32; 3], x: &[Point]) -> Point {
    let [a, b, c] = corners.map(|vertex| x[vertex as usize]);
    cross(minus(b, a), minus(c, a))
}

/// Twice the area of a face.
pub(crate) fn double_area(corners: [u32; 3], x: &[Point]) -> f64 {
    let normal = normal(corners, x);
    dot(normal, normal).sqrt()
}

/// The longest side of a face divided by the height on it: 1.15 for equal sides, infinite without an area.
pub(crate) fn aspect(corners: [u32; 3], x: &[Point]) -> f64 {
    let [a, b, c] = corners.map(|vertex| x[vertex as usize]);
    let sides = [minus(a, b), minus(b, c), minus(c, a)];
    let longest = sides.iter().map(|&side| dot(side, side)).fold(0.0, f64::max);
    let aspect = longest / double_area(corners, x);
    if aspect.is_nan() { f64::INFINITY } else { aspect }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fold_is_an_angle_above_90_degrees_whatever_the_orientations() {
        let tip = |angle: f64| [-angle.cos(), 0.0, angle.sin()];
        for (faces, is_oriented) in [([[0, 1, 2], [1, 0, 3]], true), ([[0, 1, 2], [0, 1, 3]], false)] {
            let mesh = TriangleMesh::new(4, faces.to_vec()).expect("the indices are in range");
            let pairs = neighbours(&mesh);
            assert_eq!((pairs.len(), pairs[0].is_oriented), (1, is_oriented));
            let at = |angle: f64| [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], tip(angle)];
            let is_new_fold =
                |before: f64, after: f64| pairs[0].is_new_fold(&mesh, [&at(before), &at(after)]);
            assert_eq!(
                [0.0, 1.5, 1.7, 3.0].map(|after| is_new_fold(0.0, after)),
                [false, false, true, true]
            );
            let right = std::f64::consts::FRAC_PI_2;
            assert!(
                !is_new_fold(right - 0.001, right + 0.001),
                "a right angle that was moved"
            );
            assert!(!is_new_fold(1.7, 3.0), "a fold before");
        }
    }

    #[test]
    fn aspects_of_triangles() {
        let x = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [4.0, 0.0, 0.0]];
        assert!((aspect([0, 1, 2], &x) - 2.5).abs() < 1e-15);
        assert_eq!(aspect([0, 1, 3], &x), f64::INFINITY);
        assert_eq!(aspect([0, 0, 0], &x), f64::INFINITY);
    }
}

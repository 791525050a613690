//! Meshes of rectangular strips.

use exact_ccd_mesh::Point;
use fastrand::Rng;
use nalgebra::Vector3;

/// A strip in the plane y = 0 from the origin along x, with cells along x and z.
#[derive(Clone, Copy)]
pub(super) struct Strip {
    pub(super) cells: [u32; 2],
    pub(super) size: [f64; 2],
}

/// The vertices and the faces of a strip.
pub(super) struct Mesh {
    pub(super) points: Vec<Point>,
    pub(super) faces: Vec<[u32; 3]>,
}

impl Strip {
    /// The length of a cell along x.
    pub(super) fn cell(&self) -> f64 {
        self.size[0] / f64::from(self.cells[0])
    }

    /// The mesh with this name in the table of `docs/simulation/validation.md`.
    pub(super) fn mesh(&self, name: &str) -> Mesh {
        let random = &mut Rng::with_seed(4);
        let [nx, _] = self.cells;
        let is_even = |vertex: u32| (vertex % (nx + 1) + vertex / (nx + 1)).is_multiple_of(2);
        let points = if name.starts_with("shifted points") {
            self.shifted(random)
        } else {
            self.points()
        };
        let length = |a: u32, b: u32| {
            let [a, b] = [a, b].map(|vertex| Vector3::from(points[vertex as usize]));
            (b - a).norm()
        };
        let faces = match name {
            "grid, alternating diagonals" => self.faces(|[a, ..]| is_even(a)),
            "grid, parallel diagonals" => self.faces(|_| true),
            "shifted points, shorter diagonals" => self.faces(|[a, b, c, d]| length(a, c) < length(b, d)),
            "grid, random diagonals" | "shifted points, random diagonals" => self.faces(|_| random.bool()),
            _ => panic!("there is no mesh {name}"),
        };
        Mesh { points, faces }
    }

    /// The points of a grid.
    fn points(&self) -> Vec<Point> {
        let ([nx, nz], size) = (self.cells, self.size);
        let at = |i: u32, n: u32, size: f64| size * f64::from(i) / f64::from(n);
        let row = |k: u32| (0..=nx).map(move |i| [at(i, nx, size[0]), 0.0, at(k, nz, size[1])]);
        (0..=nz).flat_map(row).collect()
    }

    /// The points of a grid. Inner points are shifted at random, by less than a third of a cell along each
    /// axis.
    fn shifted(&self, random: &mut Rng) -> Vec<Point> {
        let cell = [0, 1].map(|axis: usize| self.size[axis] / f64::from(self.cells[axis]));
        let mut points = self.points();
        for point in &mut points {
            let is_inside = |x: f64, lower: f64, axis: usize| {
                lower * cell[axis] < x && x < self.size[axis] - 0.1 * cell[axis]
            };
            if is_inside(point[0], 1.5, 0) && is_inside(point[2], 0.1, 1) {
                point[0] += 0.6 * (random.f64() - 0.5) * cell[0];
                point[2] += 0.6 * (random.f64() - 0.5) * cell[1];
            }
        }
        points
    }

    /// The faces of a grid. The diagonal of a cell joins its first and its third corner if `is_first` is true
    /// for the corners.
    fn faces(&self, mut is_first: impl FnMut([u32; 4]) -> bool) -> Vec<[u32; 3]> {
        let [nx, nz] = self.cells;
        let index = |i: u32, k: u32| i + (nx + 1) * k;
        let cells = (0..nz).flat_map(|k| (0..nx).map(move |i| (i, k)));
        let corners =
            cells.map(|(i, k)| [index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1)]);
        let cut = |[a, b, c, d]: [u32; 4]| {
            if is_first([a, b, c, d]) {
                [[a, c, b], [a, d, c]]
            } else {
                [[a, d, b], [b, d, c]]
            }
        };
        corners.flat_map(cut).collect()
    }
}

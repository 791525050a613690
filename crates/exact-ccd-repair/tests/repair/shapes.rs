//! Generated meshes.

use std::f64::consts::TAU;
use std::sync::Arc;

use exact_ccd_mesh::vector::{cross, minus, unit};
use exact_ccd_mesh::{Point, TriangleMesh};

/// A mesh and its positions.
#[derive(Clone)]
pub(crate) struct Body {
    pub(crate) mesh: Arc<TriangleMesh>,
    pub(crate) positions: Vec<Point>,
}

impl Body {
    fn new(positions: Vec<Point>, faces: Vec<[u32; 3]>) -> Self {
        let mesh = TriangleMesh::new(positions.len(), faces).expect("the indices are in range");
        Self {
            mesh: Arc::new(mesh),
            positions,
        }
    }

    pub(crate) fn moved(self, by: Point) -> Self {
        self.mapped(|x| [0, 1, 2].map(|axis: usize| x[axis] + by[axis]))
    }

    /// A rod through these points, in one mesh with this body.
    pub(crate) fn with_rod(self, points: &[Point]) -> Self {
        let first = self.positions.len() as u32;
        let rod = (first + 1..first + points.len() as u32).map(|vertex| [vertex - 1, vertex]);
        let edges: Vec<[u32; 2]> = self.mesh.loose_edges().iter().copied().chain(rod).collect();
        let positions = [&self.positions, points].concat();
        let mesh = TriangleMesh::with_edges(positions.len(), self.mesh.faces().to_vec(), &edges);
        Self {
            mesh: Arc::new(mesh.expect("the indices are in range")),
            positions,
        }
    }

    /// Without its first face.
    pub(crate) fn with_hole(self) -> Self {
        let faces = self.mesh.faces()[1..].to_vec();
        Self::new(self.positions, faces)
    }

    /// Turned about the first axis.
    pub(crate) fn tilted(self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        self.mapped(|[x, y, z]| [x, cosine * y - sine * z, sine * y + cosine * z])
    }

    /// The faces turned over.
    pub(crate) fn reversed(self) -> Self {
        let faces = self.mesh.faces().iter().map(|&[a, b, c]| [a, c, b]);
        Self::new(self.positions, faces.collect())
    }

    fn mapped(self, map: impl Fn(Point) -> Point) -> Self {
        Self {
            positions: self.positions.into_iter().map(map).collect(),
            ..self
        }
    }
}

/// Bodies in one mesh.
pub(crate) fn joined<const N: usize>(bodies: [Body; N]) -> Body {
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for body in bodies {
        let first = positions.len() as u32;
        faces.extend(
            body.mesh
                .faces()
                .iter()
                .map(|face| face.map(|vertex| first + vertex)),
        );
        positions.extend(body.positions);
    }
    Body::new(positions, faces)
}

/// A surface over a grid of `[m, n]` cells, closed in the directions that wrap; a direction may be reversed
/// at the seam of the other one.
fn surface(
    [m, n]: [usize; 2],
    wraps: [bool; 2],
    is_twisted: bool,
    place: impl Fn(f64, f64) -> Point,
) -> Body {
    let rows = if wraps[0] { m } else { m + 1 };
    let columns = if wraps[1] { n } else { n + 1 };
    let points = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let positions = points
        .map(|(i, j)| place(i as f64 / m as f64, j as f64 / n as f64))
        .collect();
    let index = |i: usize, j: usize| {
        let j = if i == rows && is_twisted {
            (2 * n - j) % n
        } else {
            j
        };
        (i % rows * columns + j % columns) as u32
    };
    let cells = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    let faces = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Body::new(positions, faces.collect())
}

/// A square sheet in the plane z = 0.
pub(crate) fn grid(n: usize, size: f64) -> Body {
    surface([n, n], [false, false], false, |u, v| [size * u, size * v, 0.0])
}

pub(crate) fn torus(m: usize, n: usize, major: f64, minor: f64) -> Body {
    surface([m, n], [true, true], false, |u, v| {
        let ((sine, cosine), (up, out)) = ((TAU * u).sin_cos(), (TAU * v).sin_cos());
        let radius = major + minor * out;
        [radius * cosine, radius * sine, minor * up]
    })
}

/// The immersion of a Klein bottle as a figure eight that turns by half a turn.
pub(crate) fn klein_bottle(m: usize, n: usize) -> Body {
    surface([m, n], [true, true], true, |u, v| {
        let ((turn_sine, turn_cosine), angle) = ((0.5 * TAU * u).sin_cos(), TAU * v);
        let (x, y) = (angle.sin(), (2.0 * angle).sin());
        let radius = 2.0 + turn_cosine * x - turn_sine * y;
        let (sine, cosine) = (TAU * u).sin_cos();
        [radius * cosine, radius * sine, turn_sine * x + turn_cosine * y]
    })
}

/// A strip along a curve that meets itself.
pub(crate) fn twisted_strip(m: usize, n: usize, twist: f64, width: f64) -> Body {
    surface([m, n], [false, false], false, |u, v| {
        let (sine, cosine) = (0.9 * TAU * u).sin_cos();
        let (up, out) = (0.5 * TAU * twist * u).sin_cos();
        let across = width * (v - 0.5);
        let radius = 1.0 + across * out;
        [
            radius * cosine,
            radius * (2.0 * 0.9 * TAU * u).sin() * 0.6 + 0.01 * sine,
            across * up + 0.02 * u,
        ]
    })
}

/// A tube along a bent line, without ends.
pub(crate) fn limb(m: usize, n: usize) -> Body {
    surface([m, n], [false, true], false, |u, v| {
        let (sine, cosine) = (TAU * v).sin_cos();
        [0.3 * cosine + 0.4 * (2.0 * u - 1.0).powi(2), 0.3 * sine, 2.0 * u]
    })
}

/// The sphere as a cube of `n` cells along each edge, projected.
pub(crate) fn sphere(n: usize, radius: f64) -> Body {
    boxed(n, 2.0).moved([-1.0; 3]).mapped(|x| {
        let length = x.iter().map(|part| part * part).sum::<f64>().sqrt();
        x.map(|part| radius * part / length)
    })
}

/// A body with its lowest vertices moved to one height.
pub(crate) fn flattened(body: Body) -> Body {
    let lowest = body.positions.iter().map(|x| x[2]).fold(f64::INFINITY, f64::min);
    body.mapped(|[x, y, z]| [x, y, if z < 0.75 * lowest { lowest } else { z }])
        .moved([0.0, 0.0, -0.2 - lowest])
}

/// The surface of a cube of `n` cells along each edge.
pub(crate) fn boxed(n: usize, size: f64) -> Body {
    let count = n + 1;
    let is_outer = |index: [usize; 3]| index.iter().any(|&i| i == 0 || i == n);
    let number = |[i, j, k]: [usize; 3]| (i * count + j) * count + k;
    let mut of_place = vec![0; count.pow(3)];
    let mut positions = Vec::new();
    for (place, vertex) in of_place.iter_mut().enumerate() {
        let index = [place / count / count, place / count % count, place % count];
        if is_outer(index) {
            *vertex = positions.len() as u32;
            positions.push(index.map(|i| size * i as f64 / n as f64));
        }
    }
    let mut faces = Vec::new();
    for axis in 0..3 {
        for (side, i, j) in [0, n]
            .into_iter()
            .flat_map(|side| (0..n * n).map(move |cell| (side, cell / n, cell % n)))
        {
            let corner = |di: usize, dj: usize| {
                let mut index = [0; 3];
                index[axis] = side;
                index[(axis + 1) % 3] = i + di;
                index[(axis + 2) % 3] = j + dj;
                of_place[number(index)]
            };
            let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            faces.extend(if side == 0 {
                [[a, c, b], [a, d, c]]
            } else {
                [[a, b, c], [a, c, d]]
            });
        }
    }
    Body::new(positions, faces)
}

/// A closed tube around a closed curve, with a turn of its cross-section that ends where it began.
fn tube([m, n]: [usize; 2], radius: f64, curve: impl Fn(f64) -> Point) -> Body {
    let along = |u: f64| {
        let (before, after) = (curve(u - 1e-4), curve(u + 1e-4));
        unit(minus(after, before)).expect("the curve moves on")
    };
    surface([m, n], [true, true], false, |u, v| {
        let (place, along) = (curve(u), along(u));
        // Away from the axis of z, which no curve here follows.
        let across = unit(cross(along, [0.0, 0.0, 1.0])).expect("the curve is not vertical");
        let up = cross(across, along);
        let (sine, cosine) = (TAU * v).sin_cos();
        [0, 1, 2].map(|axis: usize| place[axis] + radius * (cosine * across[axis] + sine * up[axis]))
    })
}

/// A tube around a torus knot, which winds p times around the axis and q times around the ring.
pub(crate) fn knot([p, q]: [f64; 2], m: usize, radius: f64) -> Body {
    tube([m, 8], radius, |u| {
        let ((sine, cosine), (up, out)) = ((p * TAU * u).sin_cos(), (q * TAU * u).sin_cos());
        let distance = 1.0 + 0.4 * out;
        [distance * cosine, distance * sine, 0.4 * up]
    })
}

/// A box with the least corner at the origin, of `n` cells along each edge.
pub(crate) fn bar(n: usize, size: Point) -> Body {
    boxed(n, 1.0).mapped(|x| [0, 1, 2].map(|axis: usize| size[axis] * x[axis]))
}

/// An open tube along the axis of z.
pub(crate) fn sleeve(m: usize, n: usize, radius: f64, height: f64) -> Body {
    surface([m, n], [false, true], false, |u, v| {
        let (sine, cosine) = (TAU * v).sin_cos();
        [radius * cosine, radius * sine, height * u]
    })
}

//! Generated bodies: boxes, cloths, floors, spheres, tori, rods and particles.

mod rods;

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::body::{Body, BodyKind, ShellProperties, SolidProperties};
use crate::energies::elasticity::SolidMaterial;

pub use rods::{BEAD, ROPE, knot, line, particles};

/// Rubber-like: 1000 kg/m³, E = 1 MPa, ν = 0.4, neo-Hookean.
pub const RUBBER: SolidProperties = SolidProperties {
    density: 1000.0,
    young: 1e6,
    poisson: 0.4,
    energy: SolidMaterial::NeoHookean,
};

/// Cloth-like: 300 kg/m³, E = 100 kPa, ν = 0.3, 1 mm thick.
pub const CLOTH: ShellProperties = ShellProperties {
    density: 300.0,
    young: 1e5,
    poisson: 0.3,
    thickness: 1e-3,
    strain_limit: None,
};

/// A box of [`RUBBER`] with a corner at the origin. It has `cells` cells along the axes, at least one each.
/// Each cell is cut into six tetrahedra.
///
/// Boxes that are one cell thick are much too stiff in bending: see [`BodyKind::Solid`].
#[must_use]
pub fn solid_box(cells: [u8; 3], size: Point) -> Body {
    let [nx, ny, nz] = cells.map(|n| u32::from(n.max(1)));
    let index = |[i, j, k]: [u32; 3]| i + (nx + 1) * (j + (ny + 1) * k);
    let mut points = Vec::new();
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let share = |n: u32, of: u32| f64::from(n) / f64::from(of);
                points.push([
                    size[0] * share(i, nx),
                    size[1] * share(j, ny),
                    size[2] * share(k, nz),
                ]);
            }
        }
    }
    // Each tetrahedron follows one of the six edge paths from a corner of the cell to the opposite corner.
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let mut tetrahedra = Vec::new();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                for order in ORDERS {
                    let mut corner = [i, j, k];
                    let mut tetrahedron = [index(corner); 4];
                    for (place, axis) in order.into_iter().enumerate() {
                        corner[axis] += 1;
                        tetrahedron[place + 1] = index(corner);
                    }
                    tetrahedra.push(tetrahedron);
                }
            }
        }
    }
    let material = RUBBER;
    let regions = Vec::new();
    Body::new(
        points,
        BodyKind::Solid {
            tetrahedra,
            material,
            regions,
        },
    )
}

/// A rectangle of [`CLOTH`] in the plane y = 0 with a corner at the origin. It has `cells` cells along x
/// and z, at least one each. Each cell is cut into two triangles, along parallel diagonals: with alternating
/// ones, every second inner vertex has four edges, which do not show twist.
#[must_use]
pub fn cloth(cells: [u16; 2], size: [f64; 2]) -> Body {
    let (points, faces) = grid(cells, size);
    let material = CLOTH;
    Body::new(points, BodyKind::Shell { faces, material })
}

/// An obstacle with the mesh of [`cloth`].
#[must_use]
pub fn floor(cells: [u16; 2], size: [f64; 2]) -> Body {
    let (points, faces) = grid(cells, size);
    Body::new(points, BodyKind::Obstacle { faces })
}

/// The maximal number of cells of a box or a grid, of segments of a torus, and of edges or particles, in a
/// scene file.
pub const MAX_CELLS: u64 = 1 << 20;

/// The maximal number of subdivisions of a [`sphere`], which then has 20 · 4⁶ triangles.
pub const MAX_SUBDIVISIONS: u8 = 6;

/// A spherical obstacle about the origin: an icosahedron, subdivided at most [`MAX_SUBDIVISIONS`] times.
/// Each subdivision cuts every triangle into four and moves the new vertices onto the sphere. The normals
/// point outward.
#[must_use]
pub fn sphere(subdivisions: u8, radius: f64) -> Body {
    // The vertices of an icosahedron are the corners of three golden rectangles, each orthogonal to an axis.
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points = Vec::new();
    for axis in 0..3 {
        for (long, short) in [(golden, 1.0), (golden, -1.0), (-golden, 1.0), (-golden, -1.0)] {
            let mut point = Vector3::zeros();
            (point[axis], point[(axis + 1) % 3]) = (short, long);
            points.push(point.normalize());
        }
    }
    // Three mutual neighbours form a triangle. Neighbours are at distance 2 before normalisation.
    let near = 2.1 / (1.0 + golden * golden).sqrt();
    let are_near = |a: usize, b: usize| (points[a] - points[b]).norm() < near;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if are_near(a, b) && are_near(b, c) && are_near(c, a) {
                    let outward = (points[b] - points[a])
                        .cross(&(points[c] - points[a]))
                        .dot(&points[a]);
                    let face = [a, b, c].map(|vertex| vertex as u32);
                    faces.push(if outward > 0.0 {
                        face
                    } else {
                        [face[0], face[2], face[1]]
                    });
                }
            }
        }
    }
    for _ in 0..subdivisions.min(MAX_SUBDIVISIONS) {
        let mut middles = BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                points.push((points[a as usize] + points[b as usize]).normalize());
                points.len() as u32 - 1
            })
        };
        faces = faces
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
    }
    let points = points.into_iter().map(|point| (point * radius).into()).collect();
    Body::new(points, BodyKind::Obstacle { faces })
}

/// A torus about the y axis as an obstacle: a circle of `radius` with a tube of the radius `tube`, of
/// `segments` around the axis and around the tube, at least three each. The normals point outward.
#[must_use]
pub fn torus(segments: [u16; 2], radius: f64, tube: f64) -> Body {
    let [around, across] = segments.map(|count| u32::from(count.max(3)));
    let turn = |place: u32, of: u32| (core::f64::consts::TAU * f64::from(place) / f64::from(of)).sin_cos();
    let index = |i: u32, k: u32| (i % around) * across + k % across;
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for i in 0..around {
        let (sin, cos) = turn(i, around);
        for k in 0..across {
            let (height, outward) = turn(k, across);
            let distance = radius + tube * outward;
            points.push([distance * cos, tube * height, distance * sin]);
            let [a, b, c, d] = [index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1)];
            faces.extend([[a, c, b], [a, d, c]]);
        }
    }
    Body::new(points, BodyKind::Obstacle { faces })
}

fn grid(cells: [u16; 2], size: [f64; 2]) -> (Vec<Point>, Vec<[u32; 3]>) {
    let [nx, nz] = cells.map(|n| u32::from(n.max(1)));
    let index = |i: u32, k: u32| i + (nx + 1) * k;
    let mut points = Vec::new();
    for k in 0..=nz {
        for i in 0..=nx {
            points.push([
                size[0] * f64::from(i) / f64::from(nx),
                0.0,
                size[1] * f64::from(k) / f64::from(nz),
            ]);
        }
    }
    let mut faces = Vec::new();
    for k in 0..nz {
        for i in 0..nx {
            let (a, b, c, d) = (index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1));
            // Counterclockwise for a viewer above, so that normals point along +y.
            faces.extend([[a, c, b], [a, d, c]]);
        }
    }
    (points, faces)
}

impl Body {
    /// The body with all points mapped by a function.
    #[must_use]
    pub fn placed(mut self, map: impl FnMut(Point) -> Point) -> Self {
        self.points = self.points.into_iter().map(map).collect();
        self
    }
}

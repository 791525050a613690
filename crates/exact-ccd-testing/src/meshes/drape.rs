//! Example meshes: a sheet that drapes over a sphere in one time step.

use std::collections::HashMap;

use exact_ccd::Point;

/// The positions of the vertices of the sheet and the sphere, and the faces.
pub type Sheet = (Vec<Point>, Vec<[u32; 3]>);

/// The names and contents of the three files.
///
/// Computed with + − × ÷ and √ only, whose results are the same on every machine.
#[must_use]
pub fn frames() -> [(&'static str, Sheet); 3] {
    let (sphere, sphere_faces) = sphere(4);
    let frame = |place: &dyn Fn(f64, f64) -> Point| {
        let mut positions = sheet(place);
        let sheet_size = positions.len() as u32;
        positions.extend(&sphere);
        let mut faces = sheet_faces();
        faces.extend(
            sphere_faces
                .iter()
                .map(|face| face.map(|corner| corner + sheet_size)),
        );
        (positions, faces)
    };
    [
        ("drape_start.ply", frame(&|x, y| [x, y, 1.5])),
        ("drape_free.ply", frame(&|x, y| draped(x, y, 0.05))),
        ("drape_contact.ply", frame(&|x, y| draped(x, y, -0.1))),
    ]
}

/// The number of squares along each side of the sheet.
const SQUARES: u32 = 32;
const SIDE: f64 = 3.0;
/// The point of the sheet above the center of the sphere. It is off the middle, so that one corner
/// hangs lowest.
const CENTER: [f64; 2] = [1.4, 1.3];

/// The vertices of the sheet, row by row.
fn sheet(place: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    let along = |i| SIDE * f64::from(i) / f64::from(SQUARES);
    (0..=SQUARES)
        .flat_map(|i| (0..=SQUARES).map(move |j| [along(i), along(j)]))
        .map(|[x, y]| place(x - CENTER[0], y - CENTER[1]))
        .collect()
}

/// The faces of the sheet: two triangles for each square.
fn sheet_faces() -> Vec<[u32; 3]> {
    let row = SQUARES + 1;
    (0..SQUARES)
        .flat_map(|i| (0..SQUARES).map(move |j| i * row + j))
        .flat_map(|v| [[v, v + row, v + row + 1], [v, v + row + 1, v + 1]])
        .collect()
}

/// The position of a point of the sheet after it has draped over the unit sphere, moved up by `lift`.
///
/// A stereographic projection, which preserves angles, up to the circle where the slope of the
/// sphere is 4 : 3, and straight lines beyond.
fn draped(x: f64, y: f64, lift: f64) -> Point {
    let distance = (x * x + y * y).sqrt();
    let on_sphere = distance.min(1.0);
    let straight = distance - on_sphere;
    let square = on_sphere * on_sphere / 4.0;
    let radius = on_sphere / (1.0 + square) + 0.6 * straight;
    let height = (1.0 - square) / (1.0 + square) - 0.8 * straight;
    let shrink = if distance == 0.0 { 1.0 } else { radius / distance };
    [shrink * x, shrink * y, height + lift]
}

/// The unit sphere: an octahedron with each face split into four, `levels` times.
fn sphere(levels: u32) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut points = vec![
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let upper = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let lower = upper.map(|[a, b, _]| [b, a, 5]);
    let mut faces = [upper, lower].concat();
    for _ in 0..levels {
        let mut midpoints = HashMap::new();
        let mut midpoint = |a: u32, b: u32| {
            *midpoints.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [p, q] = [a, b].map(|vertex| points[vertex as usize]);
                points.push(unit(std::array::from_fn(|axis| p[axis] + q[axis])));
                points.len() as u32 - 1
            })
        };
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let [d, e, f] = [midpoint(a, b), midpoint(b, c), midpoint(c, a)];
                [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
            })
            .collect();
    }
    (points, faces)
}

fn unit([x, y, z]: Point) -> Point {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

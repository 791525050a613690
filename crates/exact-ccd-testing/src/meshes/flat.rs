//! Flat worlds: scenes whose primitives are flat, parallel and in touch, as stacks of boxes and cloth on a
//! floor are.
//!
//! Coordinates along the axes have few bits, so that points coincide and planes are shared exactly. The
//! turned twin of a scene has the same coincident points, but its planes are flat only up to rounding.

use std::collections::HashMap;

use exact_ccd::Point;

/// A triangle mesh that moves in straight lines.
pub struct Scene {
    /// The name in tables.
    pub name: String,
    /// The vertices of each face.
    pub faces: Vec<[u32; 3]>,
    /// The positions of the vertices at t = 0 and at t = 1.
    pub ends: [Vec<Point>; 2],
}

/// All scenes, each followed by its turned twin. With `size` 1, they are large enough for a benchmark; with a
/// larger one, they have fewer primitives by its square or cube.
pub fn scenes(size: usize) -> Vec<Scene> {
    let plain = [
        boxes(8 / size),
        cloth("cloth that slides on a floor", 60 / size, [0.0, 0.0]),
        cloth("cloth that lands on a floor", 60 / size, [0.01, -0.01]),
        spheres(4 / size.min(2), 16 / size),
        voxels(9 / size as i32),
    ];
    plain
        .into_iter()
        .flat_map(|scene| [turned(&scene), scene].into_iter().rev())
        .collect()
}

/// The displacement of sliding primitives.
const SLIDE: Point = [0.1, 0.05, 0.0];

/// Two triangles for each quadrilateral.
fn triangles([a, b, c, d]: [u32; 4]) -> [[u32; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

fn moved(points: &[Point], by: Point) -> Vec<Point> {
    points
        .iter()
        .map(|x| [0, 1, 2].map(|k: usize| x[k] + by[k]))
        .collect()
}

/// A scene of bodies, each given by its vertices, its faces and its displacement.
fn scene(name: &'static str, bodies: impl IntoIterator<Item = (Vec<Point>, Vec<[u32; 3]>, Point)>) -> Scene {
    let (mut faces, mut ends) = (Vec::new(), [Vec::new(), Vec::new()]);
    for (points, of_body, displacement) in bodies {
        let first = ends[0].len() as u32;
        faces.extend(of_body.iter().map(|face| face.map(|vertex| first + vertex)));
        ends[1].extend(moved(&points, displacement));
        ends[0].extend(points);
    }
    let name = name.into();
    Scene { name, faces, ends }
}

/// The displacement of a layer: every other one slides.
fn of_layer(layer: usize) -> Point {
    if layer.is_multiple_of(2) { [0.0; 3] } else { SLIDE }
}

/// n × n × n places, the layer last.
fn grid(n: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..n * n * n).map(move |i| [i % n, i / n % n, i / n / n])
}

/// Unit cubes in a grid without gaps.
fn boxes(n: usize) -> Scene {
    let bodies = grid(n).map(|place| {
        let (points, faces) = surface(&[place.map(|x| x as i32)]);
        (points, faces, of_layer(place[2]))
    });
    scene("boxes in a grid", bodies)
}

/// A floor and a cloth of n × n cells each, which moves from one height to another while it slides. At the
/// start, lines of both along one axis lie above each other.
fn cloth(name: &'static str, n: usize, [from, to]: [f64; 2]) -> Scene {
    let sheet = |[x, height]: [f64; 2]| -> Vec<Point> {
        let place = |i: usize| [x + (i % (n + 1)) as f64, (i / (n + 1)) as f64, height];
        (0..(n + 1) * (n + 1)).map(place).collect()
    };
    let corner = |i: usize| (i / n * (n + 1) + i % n) as u32;
    let row = n as u32 + 1;
    let faces: Vec<_> = (0..n * n)
        .map(corner)
        .flat_map(|i| triangles([i, i + 1, i + row + 1, i + row]))
        .collect();
    let [x, y, _] = SLIDE;
    let bodies = [
        (sheet([0.0, 0.0]), faces.clone(), [0.0; 3]),
        (sheet([0.25, from]), faces, [x, y, to - from]),
    ];
    scene(name, bodies)
}

/// Spheres of radius 1 in a grid: octahedra whose edges are cut into n parts. Neighbours touch in a vertex.
fn spheres(count: usize, n: usize) -> Scene {
    let (points, faces) = sphere(n as i32);
    let bodies = grid(count).map(|place| {
        let at = moved(&points, place.map(|x| 2.0 * x as f64));
        (at, faces.clone(), of_layer(place[2]))
    });
    scene("spheres that touch", bodies)
}

/// The points of the octahedron |x| + |y| + |z| = n with integer coordinates, projected to the unit sphere.
fn sphere(n: i32) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut points = Vec::new();
    let mut indices = HashMap::new();
    let mut faces = Vec::new();
    for octant in 0..8 {
        let sign = [0, 1, 2].map(|k: i32| if octant >> k & 1 == 0 { 1 } else { -1 });
        let mut vertex = |x: i32, y: i32| {
            let place = [sign[0] * x, sign[1] * y, sign[2] * (n - x - y)];
            *indices.entry(place).or_insert_with(|| {
                let length = place.iter().map(|x| f64::from(x * x)).sum::<f64>().sqrt();
                points.push(place.map(|x| f64::from(x) / length));
                points.len() as u32 - 1
            })
        };
        for (x, y) in (0..n).flat_map(|x| (0..n - x).map(move |y| (x, y))) {
            faces.push([vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)]);
            if x + y + 2 <= n {
                faces.push([vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)]);
            }
        }
    }
    (points, faces)
}

/// Two balls of voxels with this radius; the upper one rests on the lower one and slides.
fn voxels(radius: i32) -> Scene {
    let ball: Vec<[i32; 3]> = grid(2 * radius as usize)
        .map(|place| place.map(|x| x as i32))
        .filter(|place| {
            let squares = place.map(|x| (2 * x + 1 - 2 * radius) * (2 * x + 1 - 2 * radius));
            squares.into_iter().sum::<i32>() <= 4 * radius * radius
        })
        .collect();
    let (points, faces) = surface(&ball);
    let above = moved(&points, [0.0, 0.0, 2.0 * f64::from(radius)]);
    let bodies = [(points, faces.clone(), [0.0; 3]), (above, faces, SLIDE)];
    scene("balls of voxels", bodies)
}

/// The boundary of voxels.
fn surface(voxels: &[[i32; 3]]) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut points = Vec::new();
    let mut indices = HashMap::new();
    let mut faces = Vec::new();
    for voxel in voxels {
        for (axis, side) in (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]) {
            let mut neighbour = *voxel;
            neighbour[axis] += 2 * side - 1;
            if voxels.contains(&neighbour) {
                continue;
            }
            let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[u, v]: [i32; 2]| {
                let mut corner = *voxel;
                corner[axis] += side;
                corner[(axis + 1) % 3] += u;
                corner[(axis + 2) % 3] += v;
                *indices.entry(corner).or_insert_with(|| {
                    points.push(corner.map(f64::from));
                    points.len() as u32 - 1
                })
            });
            faces.extend(triangles(corners));
        }
    }
    (points, faces)
}

fn turned(scene: &Scene) -> Scene {
    Scene {
        name: format!("{}, turned", scene.name),
        faces: scene.faces.clone(),
        ends: scene
            .ends
            .each_ref()
            .map(|points| points.iter().map(turn).collect()),
    }
}

/// A point turned by 0.3 about the x-axis, then about the y-axis.
pub fn turn(&[x, y, z]: &Point) -> Point {
    let (sin, cos) = 0.3_f64.sin_cos();
    let [y, z] = [cos * y - sin * z, sin * y + cos * z];
    [cos * x + sin * z, y, cos * z - sin * x]
}

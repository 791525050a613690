//! Makes the meshes in `examples`: a sheet that drapes itself over a sphere in one time step.
//!
//! `drape_start.ply` is the start, the sheet flat above the sphere. At `drape_free.ply` it hangs
//! just off the sphere, and the step is free of contact. At `drape_contact.ply` it has sunk into
//! the sphere.
//!
//! ```sh
//! cargo run --release --example drape -p exact-ccd-mesh -- [FOLDER]
//! ```

use std::collections::HashMap;
use std::error::Error;
use std::fs::File;
use std::path::PathBuf;

use exact_ccd_mesh::{Frame, FrameError, Point};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(|| PathBuf::from("examples"), PathBuf::from);
    for (name, frame) in frames()? {
        frame.write_ply(File::create(folder.join(name))?)?;
    }
    Ok(())
}

/// The three files: names and contents.
///
/// They are computed by + − × ÷ and √ alone, whose results are the same on every machine.
fn frames() -> Result<[(&'static str, Frame); 3], FrameError> {
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
        Frame::new(positions, faces)
    };
    Ok([
        ("drape_start.ply", frame(&|x, y| [x, y, 1.5])?),
        ("drape_free.ply", frame(&|x, y| draped(x, y, 0.05))?),
        ("drape_contact.ply", frame(&|x, y| draped(x, y, -0.1))?),
    ])
}

/// The number of squares along each side of the sheet.
const SQUARES: u32 = 32;
const SIDE: f64 = 3.0;
/// The place of the sphere's centre under the sheet: off the middle, so that one corner hangs
/// lowest.
const CENTRE: [f64; 2] = [1.4, 1.3];

/// The vertices of the sheet, row by row.
fn sheet(place: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    let along = |i| SIDE * f64::from(i) / f64::from(SQUARES);
    (0..=SQUARES)
        .flat_map(|i| (0..=SQUARES).map(move |j| [along(i), along(j)]))
        .map(|[x, y]| place(x - CENTRE[0], y - CENTRE[1]))
        .collect()
}

/// Two triangles a square.
fn sheet_faces() -> Vec<[u32; 3]> {
    let row = SQUARES + 1;
    (0..SQUARES)
        .flat_map(|i| (0..SQUARES).map(move |j| i * row + j))
        .flat_map(|v| [[v, v + row, v + row + 1], [v, v + row + 1, v + 1]])
        .collect()
}

/// The place of a point of the sheet draped over the unit sphere, moved up by `lift`.
///
/// A stereographic projection, which preserves angles, down to where the slope of the sphere is 4 :
/// 3; from there the sheet is straight.
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

/// The unit sphere: an octahedron whose faces are split in four, `levels` times.
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use exact_ccd_mesh::{Bvh, Motion, StepReport};

    use super::*;

    fn committed(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../examples")
            .join(name)
    }

    fn report(end: &str) -> StepReport {
        let motion = Motion::read(committed("drape_start.ply"), committed(end)).unwrap();
        StepReport::new(motion.step().unwrap(), &Bvh, &|_| ())
    }

    #[test]
    fn the_committed_files_are_those_of_this_example() {
        for (name, frame) in frames().unwrap() {
            let mut made = Vec::new();
            frame.write_ply(&mut made).unwrap();
            assert!(made == std::fs::read(committed(name)).unwrap(), "{name}");
        }
    }

    #[test]
    fn one_step_is_free_and_the_other_is_not() {
        assert!(report("drape_free.ply").is_free());
        let contact = report("drape_contact.ply");
        assert!(!contact.is_free());
        assert_eq!(contact.touching.total(), 0);
    }
}

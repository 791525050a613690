//! A mass-spring cloth falls onto a triangle and sticks to it, in 100 steps certified to be free of contact.

use std::{error::Error, sync::Arc};

use exact_ccd_mesh::{Audit, CONTACT, Detector, Frame, FreeStepOptions, Point, TriangleMesh};

const SIDE: u32 = 16;
const DT: f64 = 0.01;

struct Sim {
    mesh: Arc<TriangleMesh>,
    detector: Detector,
    x: Vec<Point>,
    v: Vec<Point>,
}

impl Sim {
    fn step(&mut self, rest: &[Point]) -> Result<(), Box<dyn Error>> {
        let Self { mesh, detector, x, v } = self;
        for [i, j] in mesh.edges().iter().map(|edge| edge.map(|vertex| vertex as usize)) {
            let force = 2e3 * (1.0 - distance(rest[i], rest[j]) / distance(x[i], x[j]));
            for axis in 0..3 {
                let impulse = DT * force * (x[j][axis] - x[i][axis]);
                (v[i][axis], v[j][axis]) = (v[i][axis] + impulse, v[j][axis] - impulse);
            }
        }
        v[3..].iter_mut().for_each(|v| v[2] -= DT * 9.81); // The triangle is at rest.
        for contact in detector.collisions(x, &advanced(x, v), CONTACT)? {
            contact.pair.vertices(mesh).into_iter().flatten().for_each(|i| v[i as usize] = [0.0; 3]);
        }
        *x = detector.free_step(x, &advanced(x, v), &FreeStepOptions::default())?.positions;
        Ok(())
    }
}

fn advanced(x: &[Point], v: &[Point]) -> Vec<Point> {
    x.iter().zip(v).map(|(x, v)| [0, 1, 2].map(|axis| x[axis] + DT * v[axis])).collect()
}

fn distance([a, b, c]: Point, [d, e, f]: Point) -> f64 {
    (a - d).hypot(b - e).hypot(c - f)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut x = vec![[-1.0, -0.2, 0.0], [1.0, -0.2, 0.0], [0.0, 0.4, 0.0]];
    let grid = |k: u32| [0.06 * f64::from(k / SIDE) - 0.5, 0.06 * f64::from(k % SIDE) - 0.5, 0.2];
    x.extend((0..SIDE * SIDE).map(grid));
    let corners = (0..SIDE * (SIDE - 1)).filter(|k| k % SIDE < SIDE - 1).map(|k| k + 3);
    let cells = corners.flat_map(|v| [[v, v + SIDE, v + SIDE + 1], [v, v + SIDE + 1, v + 1]]);
    let mesh = Arc::new(TriangleMesh::new(x.len(), cells.chain([[0, 1, 2]]).collect())?);
    let (rest, v, detector) = (x.clone(), vec![[0.0; 3]; x.len()], Detector::new(mesh.clone()));
    let (mut sim, mut audit) = (Sim { mesh, detector, x, v }, Audit::default());
    for _ in 0..100 {
        sim.step(&rest)?;
        assert_eq!(audit.examine(Frame::new(sim.x.clone(), sim.mesh.faces().to_vec())?)?, None);
    }
    println!("{} frames free of contact", audit.frames());
    Ok(())
}

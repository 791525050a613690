//! A mass-spring cloth falls onto a triangle in 100 steps, each certified to be free of contact.

use std::{error::Error, sync::Arc};

use exact_ccd_mesh::{Audit, Detector, Frame, FreeStepOptions, Point, TriangleMesh};

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
        v.iter_mut().for_each(|v| v[2] -= DT * 9.81);
        v[..3].fill([0.0; 3]); // The triangle is fixed.
        let end = |x: &Point, v: &Point| [0, 1, 2].map(|axis| x[axis] + DT * v[axis]);
        let x1: Vec<Point> = x.iter().zip(&*v).map(|(x, v)| end(x, v)).collect();
        for contact in detector.contacts(x, &x1, 1.0)? {
            let vertices = contact.pair.vertices(mesh).into_iter().flatten();
            vertices.for_each(|vertex| v[vertex as usize] = [0.0; 3]); // The cloth sticks.
        }
        let x1: Vec<Point> = x.iter().zip(&*v).map(|(x, v)| end(x, v)).collect();
        *x = detector.free_step(x, &x1, &FreeStepOptions::default())?.positions;
        Ok(())
    }
}

fn distance([a, b, c]: Point, [d, e, f]: Point) -> f64 {
    (a - d).hypot(b - e).hypot(c - f)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut x = vec![[-1.0, -0.2, 0.0], [1.0, -0.2, 0.0], [0.0, 0.4, 0.0]];
    let place = |k: u32| f64::from(k) / f64::from(SIDE - 1) - 0.5;
    x.extend((0..SIDE * SIDE).map(|k| [place(k / SIDE), place(k % SIDE), 0.2]));
    let corners = (0..SIDE * (SIDE - 1)).filter(|k| k % SIDE < SIDE - 1).map(|k| k + 3);
    let cells = corners.flat_map(|v| [[v, v + SIDE, v + SIDE + 1], [v, v + SIDE + 1, v + 1]]);
    let mesh = Arc::new(TriangleMesh::new(x.len(), cells.chain([[0, 1, 2]]).collect())?);
    let (rest, v, detector) = (x.clone(), vec![[0.0; 3]; x.len()], Detector::new(mesh.clone()));
    let mut sim = Sim { mesh, detector, x, v };
    let mut audit = Audit::default();
    for _ in 0..100 {
        sim.step(&rest)?;
        assert_eq!(audit.examine(Frame::new(sim.x.clone(), sim.mesh.faces().to_vec())?)?, None);
    }
    println!("{} frames free of contact", audit.frames());
    Ok(())
}

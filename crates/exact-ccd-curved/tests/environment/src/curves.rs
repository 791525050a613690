//! Curved motion: no bound of an error is known in another environment.

use std::hint::black_box;

use exact_ccd::{Separation, VertexVertex};
use exact_ccd_curved::{
    CurvedStepError, CurvedStepOptions, Polynomial, RigidMotion, RigidPoint, SearchError, SearchOptions,
    Trajectory, curved_step, time_of_impact,
};
use exact_ccd_mesh::TriangleMesh;

/// Parabolas through a floor at z = 0.
fn parabolas() -> Vec<Polynomial<3>> {
    let triangle = |place: f64, z: [f64; 3]| {
        [[0.0, 0.0], [0.25, 0.0], [0.0, 0.25]].map(|[x, y]| Polynomial::new(z.map(|z| [place + x, y, z])))
    };
    let falling = (0..200).flat_map(|i| triangle(f64::from(i), [1.0 + f64::from(i), 0.5, -1.0]));
    falling.chain(triangle(0.0, [0.0; 3])).collect()
}

/// The step of the parabolas: `Ok` of the bits of its free time, or the error of the environment.
pub fn step() -> Result<u64, ()> {
    let curves = parabolas();
    let faces = (0..curves.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let mesh = TriangleMesh::new(curves.len(), faces.collect()).expect("the faces are valid");
    let options = CurvedStepOptions::default();
    match curved_step(&mesh, &curves, Separation::default(), &options) {
        Ok(step) => Ok(step.answer.free_until.to_bits()),
        Err(CurvedStepError::Search(SearchError::Environment)) => Err(()),
        Err(error) => panic!("{error}"),
    }
}

/// The same for two points.
pub fn points() -> Result<u64, ()> {
    let curves = [parabolas()[0], Polynomial::new([[0.0; 3]; 3])];
    match time_of_impact::<VertexVertex, _>(&curves, Separation::default(), &SearchOptions::default()) {
        Ok(answer) => Ok(answer.free_until.to_bits()),
        Err(SearchError::Environment) => Err(()),
        Err(error) => panic!("{error}"),
    }
}

/// The bound of the deviation of a curve that is made on this thread.
pub fn deviation(curve: &Polynomial<3>) -> f64 {
    curve.deviation(0.0, 1.0)
}

pub fn curve() -> Polynomial<3> {
    parabolas()[0]
}

/// A constant curve at a subnormal place, and a point that turns by a subnormal angle, made on this thread.
pub fn subnormal() -> (Polynomial<1>, RigidPoint) {
    let tiny = black_box(f64::from_bits(1));
    let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], tiny, [0.0; 3]).expect("the numbers are finite");
    (
        Polynomial::from_coefficients([[tiny; 3]]),
        motion.point([1.0, 0.0, 0.0]),
    )
}

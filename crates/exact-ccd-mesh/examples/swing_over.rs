//! The link of a robot swings into a pyramid: gradient steps raise the end of the swing until it is free.
//!
//! `cargo run -p exact-ccd-mesh --example swing_over`
//!
//! The link is an edge from a joint to its tip. Two parameters are free: the lift of the link, and the
//! height of the joint at the end. Each step follows the derivatives of the time of impact, until its linear
//! model reaches t = 1.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;

use exact_ccd::{NotDifferentiable, Options, Separation, with_kind};
use exact_ccd_mesh::{Detector, PairKind, Point, Step, TriangleMesh};

/// The length of the link, and the distance that it keeps from the pyramid.
const LENGTH: f64 = 2.0;
const DISTANCE: f64 = 0.02;
const MOST_STEPS: usize = 100;

/// The joint and the tip.
fn link(swing: f64, [lift, height]: [f64; 2]) -> [Point; 2] {
    let along = [lift.cos() * swing.cos(), lift.cos() * swing.sin(), lift.sin()];
    let joint = [0.0, 0.0, 0.5 + height];
    [joint, [0, 1, 2].map(|axis| joint[axis] + LENGTH * along[axis])]
}

/// The derivatives of both points with respect to the lift and to the height.
fn derivatives(swing: f64, [lift, _]: [f64; 2]) -> [[Point; 2]; 2] {
    let tip = [-lift.sin() * swing.cos(), -lift.sin() * swing.sin(), lift.cos()];
    [[[0.0; 3], tip.map(|x| LENGTH * x)], [[0.0, 0.0, 1.0]; 2]]
}

/// The vertices of a pair, and the derivatives of its time of impact with respect to their ends.
fn time_gradient<K: PairKind>(
    step: Step<'_>,
    ids: [u32; 2],
    options: Options,
) -> Result<Vec<(u32, Point)>, NotDifferentiable> {
    let found = step.query::<K>(ids).zip(K::vertices(step.mesh(), ids));
    let (query, vertices) = found.ok_or(NotDifferentiable::Free)?;
    let [_, ends] = query.time_gradient(options)?.points;
    Ok(vertices
        .as_ref()
        .iter()
        .copied()
        .zip(ends.as_ref().iter().copied())
        .collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let sides = [[2, 3, 6], [3, 4, 6], [4, 5, 6], [5, 2, 6]];
    let mut detector = Detector::new(TriangleMesh::with_edges(7, sides.into(), &[[0, 1]])?);
    let pyramid = [
        [0.9, -0.4, 0.0],
        [1.7, -0.4, 0.0],
        [1.7, 0.4, 0.0],
        [0.9, 0.4, 0.0],
        [1.3, 0.05, 0.9],
    ];
    let options = Options::within(Separation::new(DISTANCE)?);

    let (from, to) = (-0.6, 0.6);
    let x0 = [&link(from, [0.0; 2])[..], &pyramid].concat();
    let mut free = [0.0; 2];
    for count in 0..MOST_STEPS {
        let x1 = [&link(to, free)[..], &pyramid].concat();
        let Some(contact) = detector.collision(&x0, &x1, options)? else {
            println!(
                "after {count} steps: free, with the lift {:.3} and the height {:.3}",
                free[0], free[1]
            );
            return Ok(());
        };
        let time = contact.impact.time.lower();
        println!("{:?} at t = {time:.4}", contact.pair);
        let mesh = detector.mesh().clone();
        let step = Step::new(&mesh, &x0, &x1)?;
        let ids = contact.pair.ids();
        let gradient = with_kind!(contact.pair.kind(), K => time_gradient::<K>(step, ids, options))?;
        // The chain rule: the first two vertices are the link.
        let slopes = derivatives(to, free).map(|points| {
            let of_link = gradient
                .iter()
                .filter_map(|(vertex, slope)| Some((points.get(*vertex as usize)?, slope)));
            of_link
                .map(|(by, slope)| (0..3).map(|axis| by[axis] * slope[axis]).sum::<f64>())
                .sum::<f64>()
        });
        let squared = slopes[0] * slopes[0] + slopes[1] * slopes[1];
        for (parameter, slope) in free.iter_mut().zip(slopes) {
            // At most 0.1 at a time: the linear model is good near the present parameters.
            *parameter += ((1.0 - time) * slope / squared).clamp(-0.1, 0.1);
        }
    }
    Err(format!("the swing is not free after {MOST_STEPS} steps").into())
}

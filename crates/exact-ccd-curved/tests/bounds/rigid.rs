//! Rigid motion against integers.

use exact_ccd_curved::RigidMotion;

use crate::check;
use crate::fixed::Fixed;

/// Directions whose length is an integer, the last number.
const DIRECTIONS: [([f64; 3], i64); 5] = [
    ([0.0, 0.0, 1.0], 1),
    ([-1.0, 2.0, 2.0], 3),
    ([3.0, 0.0, -4.0], 5),
    ([2.0, 3.0, 6.0], 7),
    ([-4.0, 8.0, 1.0], 9),
];

fn cross(a: &[Fixed; 3], b: &[Fixed; 3]) -> [Fixed; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k): (usize, usize)| a[j].times(&b[k]).minus(&a[k].times(&b[j])))
}

#[test]
fn errors_and_deviations_hold() {
    let mut random = fastrand::Rng::with_seed(5);
    for case in 0..10_000 {
        let (direction, length) = DIRECTIONS[case % DIRECTIONS.len()];
        let scale = 2.0_f64.powi(random.i32(-200..200));
        let number = |random: &mut fastrand::Rng| (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-30..30));
        let [center, start, displacement] = [0; 3].map(|_| [0; 3].map(|_| number(&mut random)));
        let angle = (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-40..12));
        let motion = RigidMotion::new(center, direction.map(|x| x * scale), angle, displacement).unwrap();

        let axis = direction.map(|x| Fixed::from(x).over(length));
        let arm = [0, 1, 2].map(|k: usize| Fixed::from(start[k]).minus(&Fixed::from(center[k])));
        let tangent = cross(&axis, &arm);
        let radius = cross(&tangent, &axis);
        let curve = |time: Fixed| {
            let [sine, cosine] = Fixed::from(angle).times(&time).sine_and_cosine();
            let versine = Fixed::from(1.0).minus(&cosine);
            [0, 1, 2].map(|k: usize| {
                let turned = sine.times(&tangent[k]).minus(&versine.times(&radius[k]));
                let moved = time.times(&Fixed::from(displacement[k]));
                Fixed::from(start[k]).plus(&turned).plus(&moved)
            })
        };
        check(&motion.point(start), &curve, &mut random);
    }
}

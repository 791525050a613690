//! Positions, deviations and sines against integers with 700 binary places.

mod fixed;
mod polynomials;
mod rigid;
mod sine;

use exact_ccd_curved::Trajectory;
use fixed::Fixed;

/// The curve of a trajectory in integers, at a time that is one.
type Curve<'a> = &'a dyn Fn(Fixed) -> [Fixed; 3];

/// Checks the error of positions and the deviation at random times.
fn check(trajectory: &impl Trajectory, curve: Curve<'_>, random: &mut fastrand::Rng) {
    let mut times = [random.f64(), random.f64()];
    times.sort_by(f64::total_cmp);
    let [start, end] = times;
    for time in [0.0, start, end, 1.0] {
        let position = trajectory.at(time);
        let exact = curve(Fixed::from(time));
        let error = distance_squared(position.point.map(Fixed::from), exact);
        assert!(
            error <= Fixed::from(position.error).squared().widened(),
            "{time} {position:?}"
        );
    }
    let (s, e) = (Fixed::from(start), Fixed::from(end));
    let deviation = Fixed::from(trajectory.deviation(start, end).min(1e30));
    for relative in [0.1, 0.5, random.f64()].map(Fixed::from) {
        let time = s.plus(&relative.times(&e.minus(&s)));
        let (p, q) = (curve(s.clone()), curve(e.clone()));
        let chord = [0, 1, 2].map(|k: usize| p[k].plus(&relative.times(&q[k].minus(&p[k]))));
        let actual = distance_squared(curve(time), chord);
        assert!(
            actual <= deviation.squared().widened(),
            "{start} {end} {trajectory:p}"
        );
    }
}

fn distance_squared(a: [Fixed; 3], b: [Fixed; 3]) -> Fixed {
    [0, 1, 2]
        .map(|k: usize| a[k].minus(&b[k]).squared())
        .iter()
        .fold(Fixed::from(0.0), |sum, square| sum.plus(square))
}

//! The motion of one surface towards another.

use exact_ccd::{Options, Point, Separation};
use exact_ccd_curved::{CurvedStepOptions, End, RigidMotion, SearchOptions, Trajectory, curved_step};

use crate::surfaces::{Failure, Place, Surfaces};

/// A contact of two surfaces.
pub(crate) struct Hit {
    pub(crate) place: Place,
    /// The surfaces are apart before this time.
    pub(crate) time: f64,
    /// False if the surfaces may be apart for longer.
    pub(crate) is_converged: bool,
}

impl Hit {
    /// The contact of surfaces that pass through each other at the start.
    fn at_start(place: Place) -> Self {
        Self {
            place,
            time: 0.0,
            is_converged: true,
        }
    }
}

impl Surfaces {
    /// The earliest contact within a distance while the second surface moves in a straight line.
    pub(crate) fn cast(
        &self,
        velocity: Point,
        until: f64,
        distance: Separation,
    ) -> Result<Option<Hit>, Failure> {
        if let Some(place) = self.crossing()? {
            return Ok(Some(Hit::at_start(place)));
        }
        // By a power of two, velocities and times are scaled without rounding.
        let duration = power_of_two_above(until.min(self.horizon(velocity, distance.get())));
        let mut ends = self.positions.clone();
        for end in &mut ends[self.first_len..] {
            *end = [0, 1, 2].map(|axis: usize| end[axis] + velocity[axis] * duration);
        }
        let options = Options::within(distance).until((until / duration).min(1.0));
        let Some(contact) = self.detector().collision(&self.positions, &ends, options)? else {
            return Ok(None);
        };
        Ok(Some(Hit {
            place: self.place(contact.pair, [&self.positions, &ends], &contact.impact)?,
            time: product_below(duration, contact.impact.time.lower()),
            is_converged: true,
        }))
    }

    /// A time after which the surfaces are farther apart than a distance for good: their boxes have passed
    /// each other along an axis. Without motion, it is 0. It may be infinite.
    ///
    /// The gap is a sum of three numbers, with two roundings, each of at most u times the sum of their
    /// magnitudes; the quotient adds one. The bound adds 4 u of the sum, and 4 u of the quotient.
    fn horizon(&self, velocity: Point, distance: f64) -> f64 {
        if velocity == [0.0; 3] {
            return 0.0;
        }
        let (first, second) = self.positions.split_at(self.first_len);
        let mut horizon = f64::INFINITY;
        for axis in 0..3 {
            let speed = velocity[axis];
            if speed == 0.0 {
                continue;
            }
            let along = |x: &Point| if speed > 0.0 { x[axis] } else { -x[axis] };
            let front = first.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
            let back = second.iter().map(along).fold(f64::INFINITY, f64::min);
            let gap = front - back + distance;
            let error = 2.0 * f64::EPSILON * (front.abs() + back.abs() + distance);
            let time = (gap + error) / speed.abs() * (1.0 + 2.0 * f64::EPSILON);
            horizon = horizon.min(time.max(0.0));
        }
        horizon
    }

    /// The earliest contact while both surfaces move as rigid bodies, each with the motion of its own, in
    /// `duration`.
    pub(crate) fn cast_rigid(
        &self,
        motions: [RigidMotion; 2],
        duration: f64,
    ) -> Result<Option<Hit>, Failure> {
        if let Some(place) = self.crossing()? {
            return Ok(Some(Hit::at_start(place)));
        }
        let motion = |vertex: usize| motions[usize::from(vertex >= self.first_len)];
        let points = self.positions.iter().enumerate();
        let trajectories: Vec<_> = points
            .map(|(vertex, &start)| motion(vertex).point(start))
            .collect();
        let options = CurvedStepOptions::default()
            .with_search(SearchOptions::default())
            .with_can_collide(self.between());
        let step = curved_step(&self.mesh, &trajectories, exact_ccd::CONTACT, &options)?;
        let Some(pair) = step.pair.filter(|_| !step.answer.is_free()) else {
            return Ok(None);
        };
        let time = step.answer.free_until;
        let positions: Vec<Point> = trajectories.iter().map(|curve| curve.at(time).point).collect();
        Ok(Some(Hit {
            place: self.closest(pair, &positions)?,
            time: product_below(duration, time),
            is_converged: step.answer.end == End::Tolerance,
        }))
    }
}

/// A normal power of two that is at least a time, and 1 for the time 0.
fn power_of_two_above(time: f64) -> f64 {
    let mut power = 1.0;
    while power < time {
        power *= 2.0;
    }
    while time > 0.0 && power > f64::MIN_POSITIVE && 0.5 * power >= time {
        power *= 0.5;
    }
    power
}

/// The product of two numbers that are not negative, rounded down.
fn product_below(a: f64, b: f64) -> f64 {
    let product = a * b;
    if a.mul_add(b, -product) < 0.0 {
        product.next_down()
    } else {
        product
    }
}

//! Casts of random triangles with coordinates from a coarse grid, in straight lines and turning: the exact
//! dispatcher and parry's own. `cargo run --release --features f64 --example random_casts`
use std::fmt;

use exact_ccd_parry::f64::ExactDispatcher;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{
    DefaultQueryDispatcher, NonlinearRigidMotion, QueryDispatcher, ShapeCastHit, ShapeCastOptions,
    Unsupported,
};
use parry3d_f64::shape::Triangle;

/// Differences of times below this count as agreement.
const TOLERANCE: f64 = 1e-3;

#[derive(Default)]
struct Counts {
    both: usize,
    neither: usize,
    missed: usize,
    invented: usize,
    early: usize,
    late: usize,
}

impl Counts {
    fn add(&mut self, exact: Option<ShapeCastHit>, theirs: Option<ShapeCastHit>) {
        match (exact, theirs) {
            (None, None) => self.neither += 1,
            (Some(_), None) => self.missed += 1,
            (None, Some(_)) => self.invented += 1,
            (Some(exact), Some(theirs)) => {
                self.both += 1;
                let later = theirs.time_of_impact - exact.time_of_impact;
                self.late += usize::from(later > TOLERANCE);
                self.early += usize::from(later < -TOLERANCE);
            }
        }
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            both,
            neither,
            missed,
            invented,
            early,
            late,
        } = self;
        write!(
            f,
            "{both} hits of both, {neither} of neither, {missed} of the exact dispatcher only, {invented} of "
        )?;
        write!(
            f,
            "parry only; parry's time is earlier {early} times, and later {late} times"
        )
    }
}

fn main() -> Result<(), Unsupported> {
    let mut random = fastrand::Rng::with_seed(5);
    let [mut straight, mut turning] = [Counts::default(), Counts::default()];
    for _ in 0..20_000 {
        let mut vector = |steps: i32| {
            let mut coordinate = || f64::from(random.i32(-steps..=steps)) / 4.0;
            Vector::new(coordinate(), coordinate(), coordinate())
        };
        let [a, b, c, d, e, f] = [4; 6].map(&mut vector);
        let (first, second) = (Triangle::new(a, b, c), Triangle::new(d, e, f));
        let pose = Pose::from_translation(vector(6));
        let velocity = vector(16);
        let options = ShapeCastOptions::with_max_time_of_impact(1.0);
        let [exact, parry]: [&dyn QueryDispatcher; 2] = [&ExactDispatcher, &DefaultQueryDispatcher];
        let cast = |with: &dyn QueryDispatcher| with.cast_shapes(&pose, velocity, &first, &second, options);
        straight.add(cast(exact)?, cast(parry)?);

        let moving = NonlinearRigidMotion::new(pose, vector(4), velocity, vector(12));
        let still = NonlinearRigidMotion::constant_position(Pose::IDENTITY);
        let cast = |with: &dyn QueryDispatcher| {
            with.cast_shapes_nonlinear(&still, &first, &moving, &second, 0.0, 1.0, true)
        };
        turning.add(cast(exact)?, cast(parry)?);
    }
    println!("straight: {straight}");
    println!("turning: {turning}");
    Ok(())
}

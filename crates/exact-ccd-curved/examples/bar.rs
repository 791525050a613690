//! A bar turns about one end towards a post: the angle that is certainly free, against π / 2.
//!
//! ```sh
//! cargo run -p exact-ccd-curved --example bar
//! ```

#![expect(clippy::print_stdout, reason = "the result is a table")]

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::time::Instant;

use exact_ccd::{CONTACT, EdgeEdge};
use exact_ccd_curved::{Polynomial, RigidMotion, SearchOptions, Trajectory, time_of_impact};

fn main() -> Result<(), Box<dyn Error>> {
    let post = [-1.0, 1.0].map(|z| Polynomial::new([[0.0, 1.0, z]]));
    println!("turns   tolerance   certainly free until   contact by          π / 2 in between   chords   µs");
    for turns in [0.5, 10.0, 1000.0] {
        let angle = turns * std::f64::consts::TAU;
        let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3])?;
        let bar = [[0.0; 3], [2.0, 0.0, 0.0]].map(|end| motion.point(end));
        let points: [&dyn Trajectory; 4] = [&bar[0], &bar[1], &post[0], &post[1]];
        for tolerance in [1e-3, 1e-6, 1e-12] {
            let options = SearchOptions::default().with_time_tolerance(tolerance / angle);
            let start = Instant::now();
            let answer = time_of_impact::<EdgeEdge, _>(&points, CONTACT, &options)?;
            let elapsed = start.elapsed().as_secs_f64() * 1e6;
            let free = answer.free_until * angle;
            let by = answer.within.ok_or("no contact")?.by * angle;
            let is_between = free <= FRAC_PI_2 && FRAC_PI_2 <= by;
            println!(
                "{turns:5}   {tolerance:9.0e}   {free:.16}     {by:.16}  {is_between:16}   {:6}   {elapsed:4.0}",
                answer.chords
            );
        }
    }
    Ok(())
}

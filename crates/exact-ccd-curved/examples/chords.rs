//! Draws the chords of the search in docs/curved-motion.md: the path of the tip of a bar, the chord of
//! each interval of time, and the band of its deviation.
//!
//! ```sh
//! cargo run -p exact-ccd-curved --example chords > docs/curved-motion/chords.svg
//! ```
#![expect(clippy::print_stdout, reason = "the result is a drawing")]

use std::error::Error;
use std::fmt::Write;

use exact_ccd_curved::{RigidMotion, Trajectory};

/// Pixels for one unit.
const SCALE: f64 = 125.0;

fn main() -> Result<(), Box<dyn Error>> {
    // A turn by two radians of a point at the distance 1, cut into one, two and four chords.
    let tip = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], 2.0, [0.0; 3])?.point([1.0, 0.0, 0.0]);
    let mut svg = String::from(concat!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 300" font-family="sans-serif" font-size="14">"#,
        "\n<rect width=\"960\" height=\"300\" fill=\"white\"/>\n",
    ));
    for (column, count) in [1, 2, 4].into_iter().enumerate() {
        let place = |[x, y, _]: [f64; 3]| (125.0 + 325.0 * column as f64 + SCALE * x, 195.0 - SCALE * y);
        let time = |i: usize, n: usize| i as f64 / n as f64;
        let mut largest = 0.0_f64;
        for i in 0..count {
            let [start, end] = [i, i + 1].map(|i| time(i, count));
            let deviation = tip.deviation(start, end);
            largest = largest.max(deviation);
            let [(x0, y0), (x1, y1)] = [start, end].map(|time| place(tip.at(time).point));
            writeln!(
                svg,
                r##"<path d="M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}" stroke="#9ecae1" stroke-opacity="0.6" stroke-linecap="round" stroke-width="{:.1}"/>
<path d="M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}" stroke="#08519c" stroke-width="1.5"/>"##,
                2.0 * SCALE * deviation
            )?;
        }
        let arc = (0..=64).map(|i| {
            let (x, y) = place(tip.at(time(i, 64)).point);
            format!("{x:.1},{y:.1}")
        });
        let points = arc.collect::<Vec<_>>().join(" ");
        let (x, y) = place([0.3, -0.76, 0.0]);
        writeln!(
            svg,
            r##"<polyline points="{points}" fill="none" stroke="#d94801" stroke-width="2"/>
<text x="{x:.1}" y="{y:.1}" text-anchor="middle">{count} chord{}, Δ = {largest:.4}</text>"##,
            if count == 1 { "" } else { "s" }
        )?;
    }
    println!("{svg}</svg>");
    Ok(())
}

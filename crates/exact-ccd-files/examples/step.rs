//! Computes the first contact of the step from one mesh file to another.
//!
//! ```sh
//! cargo run --release --example step -p exact-ccd-files -- \
//!     examples/drape_start.ply examples/drape_contact.ply
//! ```

#![expect(clippy::print_stdout, reason = "an example prints its result")]

use std::error::Error;

use exact_ccd_files::read_motion;
use exact_ccd_mesh::step;

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args_os().skip(1);
    let (start, end) = files.next().zip(files.next()).ok_or("expected START END")?;

    let motion = read_motion(start, end)?;
    let report = step(&motion.mesh, &motion.x0, &motion.x1)?;
    match report.earliest {
        None => println!("free of contact"),
        Some(contact) => println!(
            "free of contact before t = {:?}: {:?}",
            contact.impact.time.lower(),
            contact.pair
        ),
    }
    Ok(())
}

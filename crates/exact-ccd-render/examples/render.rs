//! Renders mesh files as a picture, or as an animation if there are several. The first contact of a
//! step is marked.
//!
//! ```sh
//! cargo run --release --example render -p exact-ccd-render -- OUT.png FRAMES...
//! ```

use std::error::Error;
use std::fs::File;

use exact_ccd_files::read_frame;
use exact_ccd_mesh::{Aabb, Audit, Frame, Violation};
use exact_ccd_render::{Marks, View, render, write_apng};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let output = arguments.next().ok_or("expected OUT.png FRAMES...")?;
    let frames = arguments.map(read_frame).collect::<Result<Vec<_>, _>>()?;
    let bounds = frames
        .iter()
        .map(Frame::bounds)
        .fold(Aabb::EMPTY, |a, b| a.union(&b));
    let view = View::of(&bounds, [1.0, -2.0, 1.0], [640, 480]);
    let mut audit = Audit::default();
    let mut pictures = Vec::new();
    for frame in &frames {
        let marks = match audit.examine(frame.clone())? {
            None => Marks::default(),
            Some(Violation::Contact { contact, .. }) => Marks::pair(&frame.mesh, contact.pair),
            Some(Violation::Intersection { intersection, .. }) => {
                Marks::intersection(&frame.mesh, intersection)
            }
        };
        pictures.push(render(frame, &view, &marks));
    }
    write_apng(File::create(output)?, &pictures, 0.5)?;
    Ok(())
}

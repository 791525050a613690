//! Writes the page of a motion that is audited frame by frame:
//! `cargo run --release -p exact-ccd-view --example audit -- OUT.html`.

use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};

use exact_ccd_mesh::{Aabb, Audit, Frame, FrameError, Violation};
use exact_ccd_view::Page;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args_os().nth(1).ok_or("expected OUT.html")?;
    let first = frame(0)?;
    let bounds: Aabb = first.positions.iter().copied().collect();
    let mut page = Page::new("A falling triangle", first.mesh.clone(), &bounds);
    let mut audit = Audit::default();
    for i in 0..12 {
        let frame = frame(i)?;
        page.add_frame(format!("frame {i}"), &frame.positions)?;
        match audit.examine(frame)? {
            None => continue,
            Some(Violation::Contact { contact, .. }) => page.add_contact(&contact)?,
            Some(Violation::Intersection { intersection, .. }) => page.add_intersection(intersection)?,
        }
        break;
    }
    let mut writer = BufWriter::new(File::create(file)?);
    page.write(&mut writer)?;
    Ok(writer.flush()?)
}

/// A triangle that turns and falls onto a tetrahedron.
fn frame(i: u32) -> Result<Frame, FrameError> {
    let (angle, z) = (0.2 * f64::from(i), 1.5 - 0.13 * f64::from(i));
    let [x, y] = [angle.cos(), angle.sin()];
    let positions = vec![
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [-0.5, 0.9, 0.0],
        [-0.5, -0.9, 0.0],
        [0.4 + x, y, z],
        [0.4 - x, -y, z],
        [0.4, 0.0, z + 0.5],
    ];
    Frame::new(
        positions,
        vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2], [4, 5, 6]],
    )
}

//! Writes a page of each kind into a folder: `cargo run --release -p exact-ccd-view --example pages -- DIR`.

use std::error::Error;
use std::f64::consts::TAU;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use exact_ccd::{CONTACT, EdgeEdge, Query, Separation, VertexFace};
use exact_ccd_mesh::{Aabb, Audit, Bvh, Candidates, Frame, Motion, Point, Violation};
use exact_ccd_view::{Page, PageError};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(|| PathBuf::from("."), PathBuf::from);
    fs::create_dir_all(&folder)?;
    let write = |name: &str, page: &Page| write(&folder.join(name), page);

    // Two wavy sheets, one of which falls onto the other.
    let motion = sheets(24)?;
    write("step.html", &step("Two sheets", &motion, usize::MAX)?)?;
    write(
        "large.html",
        &step("Two sheets of 90,000 faces each", &sheets(212)?, 100)?,
    )?;
    write("audit.html", &audit()?)?;

    let contact = Separation::new(0.0)?;
    // The cubic has two roots, of which one is a contact.
    let vertex_face = Query::<VertexFace>::new(
        [
            [1.5, -1.0, 0.25],
            [1.5, 0.25, -1.5],
            [0.5, -1.5, 0.0],
            [-1.0, 0.25, 1.25],
        ],
        [
            [0.375, 0.5, -0.875],
            [2.4375, -0.5, -0.375],
            [0.3125, -0.1875, 0.9375],
            [-1.1875, -0.5, 0.5],
        ],
    )?;
    write(
        "vertex-face.html",
        &Page::of_query("A vertex and a face", &vertex_face, contact),
    )?;
    write(
        "edge-edge.html",
        &Page::of_query("Two edges that meet twice", &sliding_edges(0.0)?, contact),
    )?;
    let apart = sliding_edges(2.0)?;
    write("free.html", &Page::of_query("Two edges apart", &apart, contact))?;
    let near = Separation::new(0.1)?;
    let twice = sliding_edges(0.0)?;
    write("near.html", &Page::of_query("Two edges within 0.1", &twice, near))?;
    Ok(())
}

fn write(file: &Path, page: &Page) -> std::io::Result<()> {
    let mut writer = BufWriter::new(File::create(file)?);
    page.write(&mut writer)?;
    writer.flush()
}

fn step(title: &str, motion: &Motion, most: usize) -> Result<Page, Box<dyn Error>> {
    let step = motion.step()?;
    let mut contacts = Candidates::new(step, &Bvh).collisions(step, CONTACT);
    contacts.truncate(most);
    Ok(Page::of_step(title, step, &[], &contacts)?)
}

/// Two sheets of n by n squares above each other, which approach.
fn sheets(n: u32) -> Result<Motion, Box<dyn Error>> {
    let frame = |gap: f64| {
        let sheet = |height: f64, waves: f64| {
            (0..=n).flat_map(move |i| {
                (0..=n).map(move |j| {
                    let [x, y] = [i, j].map(|k| 2.0 * f64::from(k) / f64::from(n) - 1.0);
                    let bump = 0.1 * (TAU * waves * x).sin() * (TAU * waves * y + 0.7).cos();
                    [x + 0.013 * height, y + 0.007 * height, height + bump]
                })
            })
        };
        let positions: Vec<Point> = sheet(0.0, 1.0).chain(sheet(gap, 1.5)).collect();
        let row = n + 1;
        let squares =
            (0..2).flat_map(|k| (0..n).flat_map(move |i| (0..n).map(move |j| (k * row + i) * row + j)));
        let faces = squares.flat_map(|v| [[v, v + row, v + row + 1], [v, v + row + 1, v + 1]]);
        Frame::new(positions, faces.collect())
    };
    Ok(Motion::new(frame(0.6)?, frame(0.15)?)?)
}

/// A rod that turns and falls onto a tetrahedron, in twelve frames, until the first violation.
fn audit() -> Result<Page, Box<dyn Error>> {
    let frame = |i: u32| {
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
    };
    let first = frame(0)?;
    let bounds: Aabb = first.positions.iter().copied().collect();
    let mut page = Page::new("A falling triangle", first.mesh.clone(), &bounds);
    let mut audit = Audit::default();
    for i in 0..12 {
        let frame = frame(i)?;
        page.add_frame(format!("frame {i}"), &frame.positions)?;
        if let Some(violation) = audit.examine(frame)? {
            add(&mut page, violation)?;
            break;
        }
    }
    Ok(page)
}

fn add(page: &mut Page, violation: Violation) -> Result<(), PageError> {
    match violation {
        Violation::Contact { contact, .. } => page.add_contact(&contact),
        Violation::Intersection { intersection, .. } => page.add_intersection(intersection),
    }
}

/// An edge that slides along itself and tilts, above another edge at rest.
fn sliding_edges(height: f64) -> Result<Query<EdgeEdge>, exact_ccd::NonFinite> {
    let [b0, b1] = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    Query::new(
        [[-0.2, 0.1, height + 0.5], [1.8, -0.3, height - 0.75], b0, b1],
        [[-1.8, -0.2, height - 0.75], [0.2, 0.4, height + 0.5], b0, b1],
    )
}

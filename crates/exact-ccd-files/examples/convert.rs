//! Converts a mesh file of any format into a PLY file with the same numbers, bit for bit.
//!
//! ```sh
//! cargo run --release --example convert -p exact-ccd-files -- MESH.obj MESH.ply
//! ```

use std::error::Error;
use std::fs::File;

use exact_ccd_files::{read_frame, write_ply};

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args_os().skip(1);
    let (mesh, ply) = files.next().zip(files.next()).ok_or("expected MESH PLY")?;
    write_ply(File::create(ply)?, &read_frame(mesh)?)?;
    Ok(())
}

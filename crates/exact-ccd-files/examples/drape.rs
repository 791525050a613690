//! Generates the meshes in `examples`: a sheet that drapes over a sphere in one time step.
//!
//! In `drape_start.ply` the sheet is flat above the sphere. In `drape_free.ply` it hangs just above
//! the sphere, and the step is free of contact. In `drape_contact.ply` it has sunk into the sphere.
//!
//! ```sh
//! cargo run --release --example drape -p exact-ccd-files -- [FOLDER]
//! ```

use std::error::Error;
use std::fs::File;
use std::path::PathBuf;

use exact_ccd_files::write_ply;
use exact_ccd_mesh::Frame;
use exact_ccd_testing::meshes::drape;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(|| PathBuf::from("examples"), PathBuf::from);
    for (name, (positions, faces)) in drape::frames() {
        write_ply(File::create(folder.join(name))?, &Frame::new(positions, faces)?)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use exact_ccd_files::{read_motion, write_ply};
    use exact_ccd_mesh::{Bvh, Frame, StepReport};
    use exact_ccd_testing::meshes::drape::frames;

    fn committed(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../examples")
            .join(name)
    }

    fn report(end: &str) -> StepReport {
        let motion = read_motion(committed("drape_start.ply"), committed(end)).unwrap();
        StepReport::new(motion.step().unwrap(), &Bvh, &|_| ())
    }

    #[test]
    fn the_committed_files_are_the_generated_ones() {
        for (name, (positions, faces)) in frames() {
            let mut generated = Vec::new();
            write_ply(&mut generated, &Frame::new(positions, faces).unwrap()).unwrap();
            assert!(generated == std::fs::read(committed(name)).unwrap(), "{name}");
        }
    }

    #[test]
    fn one_step_is_free_and_the_other_is_not() {
        assert!(report("drape_free.ply").is_free());
        let contact = report("drape_contact.ply");
        assert!(!contact.is_free());
        assert_eq!(contact.touching.total(), 0);
    }
}

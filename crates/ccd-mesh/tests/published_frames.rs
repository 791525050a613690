//! The frames of published simulations, where they are at hand.

use std::path::{Path, PathBuf};

use ccd_mesh::Motion;

fn data() -> PathBuf {
    let beside_the_repository = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    std::env::var_os("EXACT_CCD_DATA").map_or_else(beside_the_repository, PathBuf::from)
}

#[track_caller]
fn assert_counts(scene: &str, start: &str, end: &str, vertex_count: usize, face_count: usize) {
    let frames = data().join("scenes").join(scene).join("frames");
    if !frames.is_dir() {
        println!("skipped: there is no {}", frames.display());
        return;
    }
    let motion = Motion::read(frames.join(start), frames.join(end)).unwrap();
    assert_eq!(motion.mesh.vertex_count(), vertex_count);
    assert_eq!(motion.mesh.faces().len(), face_count);
    assert_ne!(motion.x0, motion.x1);
}

#[test]
fn rod_twist() {
    assert_counts("rod-twist", "3036.ply", "3037.ply", 39_940, 79_864);
}

#[test]
fn cloth_ball() {
    assert_counts(
        "cloth-ball",
        "cloth_ball92.ply",
        "cloth_ball93.ply",
        46_598,
        92_230,
    );
}

#[test]
fn cloth_funnel() {
    assert_counts("cloth-funnel", "227.ply", "228.ply", 9_450, 18_484);
}

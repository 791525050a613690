//! Recordings in caches of positions, beside their mesh.

use crate::folder::Folder;
use crate::meshes::{off, tip_above_square};

/// The heights of the tip, exact in single precision.
const HEIGHTS: [f64; 4] = [3.0, 1.0, -2.0, 5.0];

fn mdd(heights: &[f64]) -> Vec<u8> {
    let frames: Vec<_> = heights
        .iter()
        .map(|&height| tip_above_square(height).positions)
        .collect();
    let counts = [frames.len(), frames[0].len()].map(|count| (count as u32).to_be_bytes());
    let times = (0..frames.len()).map(|frame| 0.5 * frame as f32);
    let numbers = frames.iter().flatten().flatten().map(|&x| x as f32);
    let numbers = times.chain(numbers).flat_map(f32::to_be_bytes);
    counts.into_iter().flatten().chain(numbers).collect()
}

fn pc2(heights: &[f64]) -> Vec<u8> {
    let frames: Vec<_> = heights
        .iter()
        .map(|&height| tip_above_square(height).positions)
        .collect();
    let words = [
        1,
        frames[0].len() as u32,
        1.0_f32.to_bits(),
        1.0_f32.to_bits(),
        frames.len() as u32,
    ];
    let numbers = frames.iter().flatten().flatten().map(|&x| (x as f32).to_bits());
    let words = words.into_iter().chain(numbers).flat_map(u32::to_le_bytes);
    b"POINTCACHE2\0".iter().copied().chain(words).collect()
}

/// A folder with `mesh.off`, whose positions do not count, and caches.
fn folder(heights: &[f64]) -> Folder {
    let folder = Folder::new();
    folder.write("mesh.off", off(&tip_above_square(-7.0)));
    folder.write("motion.mdd", mdd(heights));
    folder.write("motion.pc2", pc2(heights));
    folder
}

#[test]
fn an_audit_of_a_cache_names_its_frames_and_times() {
    let folder = folder(&HEIGHTS);
    for (cache, times) in [
        ("motion.mdd", "from time 0 to 1"),
        ("motion.pc2", "from time 1 to 3"),
    ] {
        let run = folder.run(&["audit", "mesh.off", cache, "--no-seconds"]);
        assert_eq!((run.status, run.stderr.as_str()), (1, ""));
        let contact =
            format!("contact between frame 1 ({cache}, frame 1) and frame 2 ({cache}, frame 2) at t = 0.3");
        assert!(run.stdout.contains(&contact), "{}", run.stdout);
        assert!(
            run.stdout
                .ends_with(&format!("frames: 3 of 4 examined, {times}\n")),
            "{}",
            run.stdout
        );
    }
}

#[test]
fn a_step_between_the_two_frames_of_a_cache() {
    let folder = folder(&HEIGHTS[1..3]);
    let run = folder.run(&["step", "mesh.off", "motion.pc2", "--toi"]);
    assert_eq!(run.status, 1);
    assert!(run.stdout.contains("contact at t = 0.3"), "{}", run.stdout);
    folder.write("motion.pc2", pc2(&HEIGHTS));
    let run = folder.run(&["step", "mesh.off", "motion.pc2"]);
    let message = "motion.pc2: 4 frames, expected 2; `exact-ccd audit` examines longer motions\n";
    assert!(run.status == 2 && run.stderr.ends_with(message), "{}", run.stderr);
}

#[test]
fn errors_of_caches_name_the_file_and_the_remedy() {
    let folder = folder(&HEIGHTS);
    let whole = pc2(&HEIGHTS);
    folder.write("motion.pc2", &whole[..whole.len() - 1]);
    for (arguments, message) in [
        (
            &["audit", "mesh.off", "motion.pc2"][..],
            "motion.pc2: frame 3: the file ends, expected 4 frames of 7 vertices, 368 bytes (export the cache again)",
        ),
        (
            &["audit", "motion.mdd"],
            "motion.mdd: there is no reader for a cache of positions alone; a cache has the positions without the \
             faces: give its mesh before it, as in `exact-ccd audit MESH.obj CACHE.pc2`",
        ),
        (
            &["audit", "mesh.off", "other.mdd"],
            "other.mdd: no such file or folder, expected a cache of positions",
        ),
    ] {
        let run = folder.run(arguments);
        assert!(run.status == 2 && run.stderr.contains(message), "{}", run.stderr);
    }
}

//! Caches of positions, PC2 and MDD, in files that the tests write as the formats are described.

use std::path::PathBuf;

use exact_ccd_files::{FrameSequence, Polygons};

use super::temporary;

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const FRAMES: [[f32; 9]; 2] = [
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    [0.1, 0.0, -0.0, 1.0, 1e-45, 0.0, 0.0, 1.0, 3e38],
];

fn pc2(header: (i32, i32, f32, f32, i32), positions: &[[f32; 9]]) -> Vec<u8> {
    let (version, vertices, first, step, frames) = header;
    let mut file = b"POINTCACHE2\0".to_vec();
    file.extend(version.to_le_bytes());
    file.extend(vertices.to_le_bytes());
    file.extend(first.to_le_bytes());
    file.extend(step.to_le_bytes());
    file.extend(frames.to_le_bytes());
    file.extend(positions.iter().flatten().flat_map(|x| x.to_le_bytes()));
    file
}

fn mdd(counts: [i32; 2], times: &[f32], positions: &[[f32; 9]]) -> Vec<u8> {
    let mut file: Vec<u8> = counts.iter().flat_map(|count| count.to_be_bytes()).collect();
    file.extend(times.iter().flat_map(|time| time.to_be_bytes()));
    file.extend(positions.iter().flatten().flat_map(|x| x.to_be_bytes()));
    file
}

fn valid_pc2() -> Vec<u8> {
    pc2((1, 3, 5.0, 0.5, 2), &FRAMES)
}

fn open(folder: &str, name: &str, cache: &[u8]) -> (PathBuf, Result<FrameSequence, String>) {
    let mesh = temporary(&format!("point_cache/{folder}/mesh.obj"), MESH);
    let path = temporary(&format!("point_cache/{folder}/{name}"), cache);
    let sequence = FrameSequence::open_cache(mesh, &path, Polygons::Refuse);
    (path, sequence.map_err(|error| error.to_string()))
}

#[track_caller]
fn assert_error(folder: &str, name: &str, cache: &[u8], message: &str) {
    let (_, sequence) = open(folder, name, cache);
    let error = sequence.unwrap_err();
    assert!(error.ends_with(&format!("{name}: {message}")), "{error}");
}

#[test]
fn both_formats_have_the_same_frames() {
    for (name, cache, times) in [
        ("a.pc2", valid_pc2(), [5.0, 5.5]),
        ("a.mdd", mdd([2, 3], &[0.25, 0.5], &FRAMES), [0.25, 0.5]),
    ] {
        let (path, sequence) = open("both", name, &cache);
        let sequence = sequence.unwrap();
        assert_eq!(sequence.len(), 2);
        assert_eq!(sequence.name(1), format!("{}, frame 1", path.display()));
        assert_eq!(sequence.mesh_file(1).file_name().unwrap(), "mesh.obj");
        // In any order.
        for frame in [1, 0] {
            assert_eq!(sequence.time(frame), Some(times[frame]));
            let file = sequence.read(frame).unwrap();
            let bits = |x: f64| x.to_bits();
            let positions = file.frame.positions.as_flattened().iter().copied().map(bits);
            assert!(positions.eq(FRAMES[frame].iter().map(|&x| bits(f64::from(x)))));
            assert_eq!(file.frame.mesh.faces(), [[0, 1, 2]]);
        }
        let error = sequence.read(2).unwrap_err().to_string();
        assert!(error.ends_with("expected a frame below 2, found 2"), "{error}");
    }
}

#[test]
fn a_frame_is_read_when_it_is_needed() {
    let (path, sequence) = open("later", "a.pc2", &valid_pc2());
    let sequence = sequence.unwrap();
    let other = pc2((1, 3, 5.0, 0.5, 2), &[FRAMES[0], FRAMES[0]]);
    std::fs::write(&path, other).unwrap();
    let frame = sequence.read(1).unwrap().frame;
    assert_eq!(frame.positions, sequence.read(0).unwrap().frame.positions);
    std::fs::write(&path, &valid_pc2()[..32 + 36 + 8]).unwrap();
    sequence.read(0).unwrap();
    let error = sequence.read(1).unwrap_err().to_string();
    assert!(
        error.ends_with("frame 1: the file ends, expected the positions of this frame"),
        "{error}"
    );
}

#[test]
fn errors_name_what_was_expected() {
    let mut magic = valid_pc2();
    magic[5] = b'X';
    let message = "expected `POINTCACHE2` at the beginning of a PC2 file, found `POINTXACHE2\\0`";
    assert_error("magic", "a.pc2", &magic, message);
    assert_error("short", "a.pc2", &magic[..20], message);
    assert_error(
        "empty",
        "a.pc2",
        b"",
        "the file ends, expected the header of PC2, 32 bytes",
    );
    assert_error(
        "empty",
        "a.mdd",
        b"\0\0\0",
        "the file ends, expected the header of MDD, 8 bytes",
    );
    let version = pc2((2, 3, 0.0, 1.0, 2), &FRAMES);
    assert_error(
        "version",
        "a.pc2",
        &version,
        "expected the version 1 of PC2, found 2",
    );
    for frames in [0, -1, i32::MIN] {
        let message = "expected at least one frame and one vertex, found 0 frames of 3 vertices";
        assert_error("none", "a.pc2", &pc2((1, 3, 0.0, 1.0, frames), &[]), message);
        assert_error("none", "a.mdd", &mdd([frames, 3], &[], &[]), message);
    }
    for step in [f32::NAN, f32::INFINITY, -1.0] {
        let message = format!(
            "expected a first frame and a number of frames for each sample, which is not negative, found 5 and {step}"
        );
        assert_error("rate", "a.pc2", &pc2((1, 3, 5.0, step, 2), &FRAMES), &message);
    }
}

#[test]
fn another_number_of_vertices_is_an_error() {
    let (_, sequence) = open("count", "a.pc2", &pc2((1, 6, 0.0, 1.0, 1), &FRAMES));
    let error = sequence.unwrap_err();
    assert!(error.contains("a.pc2: expected 3 vertices, as of "), "{error}");
    assert!(error.ends_with("mesh.obj, found 6 vertices"), "{error}");
}

#[test]
fn a_cache_that_is_cut_off_names_the_frame() {
    let whole = valid_pc2();
    for (length, frame) in [(32, 0), (67, 0), (68, 1), (103, 1)] {
        let message = format!(
            "frame {frame}: the file ends, expected 2 frames of 3 vertices, 104 bytes (export the cache again)"
        );
        assert_error("cut", "a.pc2", &whole[..length], &message);
    }
    let mut longer = whole;
    longer.push(0);
    let message = "expected 2 frames of 3 vertices, 104 bytes (export the cache again), found 105 bytes";
    assert_error("longer", "a.pc2", &longer, message);
    let message =
        "frame 0: the file ends, expected 2 frames of 3 vertices, 88 bytes (export the cache again)";
    assert_error("cut", "a.mdd", &mdd([2, 3], &[0.0], &[]), message);
    // No allocation follows from the numbers in the header.
    assert_error(
        "huge",
        "a.mdd",
        &mdd([i32::MAX, i32::MAX], &[], &[]),
        "frame 0: the file ends, expected 2147483647 frames of 2147483647 vertices, 18446744073709551615 bytes \
         (export the cache again)",
    );
}

#[test]
fn a_position_that_is_not_finite_is_named_with_frame_and_vertex() {
    let mut frames = FRAMES;
    frames[1][5] = f32::NAN;
    let (_, sequence) = open("finite", "a.mdd", &mdd([2, 3], &[0.0, 1.0], &frames));
    let sequence = sequence.unwrap();
    sequence.read(0).unwrap();
    let error = sequence.read(1).unwrap_err().to_string();
    assert!(
        error.contains("a.mdd: frame 1: ") && error.contains("vertex 1"),
        "{error}"
    );
}

#[test]
fn times_do_not_decrease() {
    for (times, found) in [([1.0, 0.5], "frame 1: "), ([f32::NAN, 0.0], "frame 0: ")] {
        let (_, sequence) = open("times", "a.mdd", &mdd([2, 3], &times, &FRAMES));
        let error = sequence.unwrap_err();
        assert!(
            error.contains(found) && error.contains("times that do not decrease"),
            "{error}"
        );
    }
    // Programs that have no times write zeros.
    let (_, sequence) = open("times", "a.mdd", &mdd([2, 3], &[0.0, 0.0], &FRAMES));
    assert_eq!(sequence.unwrap().time(1), Some(0.0));
}

#[test]
fn compressed_caches_are_refused() {
    assert_error(
        "gzip",
        "a.pc2.gz",
        &valid_pc2(),
        "expected a cache without compression (decompress it), found gzip",
    );
}

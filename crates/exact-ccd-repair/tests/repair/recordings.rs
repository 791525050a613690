//! Recordings: the motion between repaired frames is free, and nearly as smooth as before.

use exact_ccd_mesh::vector::{dot, minus};
use exact_ccd_mesh::{Audit, CONTACT, Frame, Point};
use exact_ccd_repair::{RepairOptions, repair_recording};

use crate::is_free;
use crate::shapes::{Body, bar, grid, joined};

const FRAMES: usize = 36;

/// A bar that turns under a cloth, which sinks into it in a third of the frames. The vertices of the bar come
/// first.
fn sinking_cloth() -> (Body, usize, Vec<Vec<Point>>) {
    let bar = bar(3, [1.0, 0.4, 0.2]).moved([-0.5, -0.2, 0.0]);
    let count = bar.positions.len();
    let body = joined([bar, grid(12, 1.5).moved([-0.77, -0.73, 0.0])]);
    let frame = |frame: usize| {
        let height = 0.25 + 0.1 * (std::f64::consts::TAU * (frame as f64 - 1.5) / FRAMES as f64).cos();
        let (sine, cosine) = (0.03 * frame as f64).sin_cos();
        let place = |(vertex, &[x, y, z]): (usize, &Point)| {
            if vertex < count {
                [cosine * x - sine * y, sine * x + cosine * y, z]
            } else {
                [x, y, height]
            }
        };
        body.positions.iter().enumerate().map(place).collect()
    };
    let frames = (0..FRAMES).map(frame).collect();
    (body, count, frames)
}

/// The second differences that 95 % of the vertices in all frames do not exceed.
fn acceleration(frames: &[Vec<Point>]) -> f64 {
    let of_vertex = |[a, b, c]: [&Point; 3]| {
        let change = minus(minus(*c, *b), minus(*b, *a));
        dot(change, change).sqrt()
    };
    let mut all: Vec<f64> = frames
        .windows(3)
        .flat_map(|window| (0..window[0].len()).map(|v| of_vertex([0, 1, 2].map(|k: usize| &window[k][v]))))
        .collect();
    all.sort_unstable_by(f64::total_cmp);
    all[all.len() * 95 / 100]
}

#[test]
fn a_cloth_over_a_turning_bar_is_free_in_all_frames_and_between_them() {
    let (body, count, frames) = sinking_cloth();
    let intersects = |x: &&Vec<Point>| !is_free(&body.mesh, x, CONTACT.separation);
    assert_eq!(frames.iter().filter(intersects).count(), FRAMES / 3);
    let options = RepairOptions::default().with_pinned((0..count as u32).collect());
    let recording = repair_recording(&body.mesh, &frames, &options).expect("the frames fit the mesh");
    assert_eq!(recording.blocked, None);
    assert_eq!(recording.frames.len(), FRAMES);
    let mut audit = Audit::default();
    for (positions, given) in recording.frames.iter().zip(&frames) {
        assert_eq!(positions[..count], given[..count]);
        let frame = Frame::new(positions.clone(), body.mesh.faces().to_vec()).expect("it is a mesh");
        assert_eq!(audit.examine(frame).expect("the frames have one mesh"), None);
        let away = |(&a, &b): (&Point, &Point)| {
            minus(a, b)
                .into_iter()
                .fold(0.0_f64, |most, part| most.max(part.abs()))
        };
        let most: f64 = positions.iter().zip(given).map(away).fold(0.0, f64::max);
        assert!(most < 0.1, "{most}");
    }
    let [before, after] = [&frames, &recording.frames].map(|frames| acceleration(frames));
    assert!(after <= 2.0 * before, "{after} after {before}");
}

#[test]
fn a_script_that_leaves_no_place_is_named() {
    let (body, _, frames) = sinking_cloth();
    let all = (0..body.positions.len() as u32).collect();
    let recording = repair_recording(&body.mesh, &frames, &RepairOptions::default().with_pinned(all))
        .expect("the frames fit the mesh");
    let blocked = recording.blocked.expect("the cloth cannot give way");
    let first = frames
        .iter()
        .position(|x| !is_free(&body.mesh, x, CONTACT.separation));
    assert_eq!(Some(blocked.frame), first);
    assert_eq!(recording.frames, frames[..blocked.frame]);
    assert!(!blocked.contacts.is_empty());
    // The first frame intersects.
    let late = &frames[blocked.frame..];
    let recording = repair_recording(&body.mesh, late, &RepairOptions::default().with_max_rounds(0))
        .expect("the frames fit the mesh");
    let blocked = recording.blocked.expect("no round is allowed");
    assert_eq!((blocked.frame, recording.frames.len()), (0, 0));
    assert!(!blocked.crossings.is_empty());
}

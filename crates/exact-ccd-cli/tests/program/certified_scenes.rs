//! Certificates of the published scenes, of their first contacts and of the steps before them, and of a
//! simulated motion.

use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd_check::check::{Proved, Step};
use exact_ccd_check::{Failure, check, ply};

use crate::folder::Folder;

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn frames_in(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    files
}

fn verify(certificate: &[u8], frames: &[PathBuf]) -> Result<Proved, Failure> {
    check(
        certificate,
        frames.iter().map(|file| ply::read(&fs::read(file).unwrap())),
    )
}

/// The certificate of these frames, which is accepted and short, its statements, and its size in words.
fn certify(command: &[&str], frames: &[PathBuf]) -> (Vec<u8>, Vec<Step>, String) {
    let folder = Folder::new();
    let files = frames.iter().map(|file| file.to_str().unwrap());
    let arguments: Vec<&str> = command.iter().copied().chain(files).collect();
    let run = folder.run(&[&arguments[..], &["--certificate", "proof"]].concat());
    assert!(run.status < 2 && run.stderr.is_empty(), "{}", run.stderr);
    let certificate = fs::read(folder.path("proof")).unwrap();
    let steps = verify(&certificate, frames).unwrap().steps;
    let pairs: usize = steps.iter().map(|step| step.pairs).sum();
    let size = format!("{} bytes for {pairs} pairs of {:?}", certificate.len(), frames[0]);
    // The header, the proof of contact, and the flags, times and lengths of tables of each step.
    assert!(certificate.len() <= 8 * pairs + 1000 + 64 * steps.len(), "{size}");
    (certificate, steps, size)
}

/// The certificates of the first contact of a published step, and of the step to the time before it, both
/// with a distance of 0 and of 5e-8. The meshes pass through their obstacles at t = 0.
fn certify_scene(name: &str) -> [String; 2] {
    let data = std::env::var_os("EXACT_CCD_DATA");
    let data = data.map_or_else(|| Path::new(REPOSITORY).join("../shared/data"), PathBuf::from);
    let frames = frames_in(&data.join("scenes").join(name).join("frames"));
    ["0", "5e-8"].map(|distance| {
        let command = ["step", "--no-start-check", "--min-distance", distance];
        let (mut certificate, steps, size) = certify(&command, &frames);
        let [step] = steps[..] else {
            panic!("one step has {} statements", steps.len())
        };
        let (free, contact) = (step.head.free.unwrap(), step.head.contact.unwrap());
        assert!(0.0 < free && free.next_up() == contact && step.contact.is_some());
        // Free to the time at which there is contact is false.
        let times = 33..49;
        assert_eq!(
            certificate[times.clone()],
            [free.to_le_bytes(), contact.to_le_bytes()].concat()
        );
        certificate[times]
            .copy_from_slice(&[contact.to_le_bytes(), contact.next_up().to_le_bytes()].concat());
        assert!(matches!(verify(&certificate, &frames), Err(Failure::Refused(_))));
        size
    })
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_first_contact_of_cloth_funnel_is_proved() {
    println!("{:?}", certify_scene("cloth-funnel"));
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_first_contact_of_cloth_ball_is_proved() {
    println!("{:?}", certify_scene("cloth-ball"));
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_first_contact_of_rod_twist_is_proved() {
    println!("{:?}", certify_scene("rod-twist"));
}

#[test]
fn the_path_of_a_simulation_is_proved_free_of_contact() {
    let folder = Folder::new();
    let scene = format!("{REPOSITORY}/examples/scenes/small-mat-twist.toml");
    let run = folder.run(&[
        "simulate", &scene, "--steps", "50", "--output", "result", "--path",
    ]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let frames = frames_in(&folder.path("result/path"));
    let (mut certificate, steps, size) = certify(&["audit"], &frames);
    println!("{size}");
    assert_eq!(steps.len() + 1, frames.len());
    assert!(
        steps
            .iter()
            .all(|step| step.head.free == Some(1.0) && step.contact.is_none())
    );
    // Without the last step, with another distance, and with another motion, nothing is proved.
    assert!(verify(&certificate, &frames[1..]).is_err());
    let reversed: Vec<PathBuf> = frames.iter().rev().cloned().collect();
    assert!(verify(&certificate, &reversed).is_err());
    certificate[24..32].copy_from_slice(&1.0_f64.to_le_bytes());
    assert!(verify(&certificate, &frames).is_err());
}

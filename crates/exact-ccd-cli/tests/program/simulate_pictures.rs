//! The pictures, animations and plots of a simulation.

use std::fs;

use crate::folder::Folder;
use crate::simulate::{SCENE, folder};

#[test]
fn there_is_a_picture_of_each_time_step() {
    let folder = folder();
    let run = |more: &[&str]| {
        let arguments = ["simulate", "scene.toml", "--output", "result", "--render"];
        let run = folder.run(&[arguments.as_slice(), more].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    };
    let pictures = || fs::read_dir(folder.path("result/pictures")).unwrap().count();
    let read = |name: &str| fs::read(folder.path(&format!("result/{name}"))).unwrap();
    run(&["--steps", "4"]);
    assert_eq!(pictures(), 5);
    run(&["--resume"]);
    assert_eq!(pictures(), 11);
    assert_eq!(frames_of(&read("motion.png")), Some(11));
    assert!(read("motion.gif").starts_with(b"GIF89a"));
    assert_eq!(frames_of(&read("pictures/000010.png")), None);
    for (plot, names) in [
        ("energies.svg", ["energy / J", "kinetic", "scene: energies"]),
        (
            "minimal-distance.svg",
            ["distance / m", "scene: minimal distance", "time / ms"],
        ),
    ] {
        let plot = folder.read(&format!("result/{plot}"));
        assert!(plot.starts_with("<svg ") && names.iter().all(|name| plot.contains(name)));
    }
    // The cube falls.
    assert_ne!(read("pictures/000000.png"), read("pictures/000005.png"));
}

/// The number of frames of an animated PNG file, from its acTL chunk. `None` for a still picture.
fn frames_of(png: &[u8]) -> Option<u32> {
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    let control = png.windows(4).position(|name| name == b"acTL")?;
    let count = png.get(control + 4..control + 8)?;
    Some(u32::from_be_bytes(count.try_into().unwrap()))
}

/// Pictures are written as the run goes: also by a run that ends with an error, up to then.
#[test]
fn pictures_are_written_as_the_run_goes() {
    let folder = Folder::new();
    folder.write(
        "scene.toml",
        SCENE.replace("[settings]", "[settings]\nmax-iterations = 1"),
    );
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--output",
        "out",
        "--render",
        "--strict",
    ]);
    assert_eq!(run.status, 2, "{run:?}");
    let pictures = fs::read_dir(folder.path("out/pictures")).unwrap().count();
    assert!((2..11).contains(&pictures), "{pictures}");
    assert!(!folder.path("out/motion.png").exists());
    assert!(folder.path("out/pictures/000000.png").exists());
}

/// The table `[render]` has the settings of the pictures, and none of the simulation.
#[test]
fn pictures_have_settings() {
    let folder = folder();
    let mut results = std::collections::HashSet::new();
    for (name, table) in [
        ("default", ""),
        ("up", "up = [1.0, 0.0, 0.0]"),
        ("camera", "camera = [0.0, 1.0, 1.0]"),
        ("all", "subject = \"all\""),
        (
            "box",
            "subject = { box = { lower = [0.0, 0.0, 0.0], upper = [0.1, 0.1, 0.1] } }",
        ),
        ("follow", "follow = true"),
    ] {
        let scene = format!("{SCENE}\n[render]\nsize = [320, 200]\nspeed = 0.5\n{table}\n");
        folder.write("settings.toml", scene);
        let run = folder.run(&[
            "simulate",
            "settings.toml",
            "--output",
            name,
            "--render",
            "--steps",
            "3",
        ]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{table}");
        let picture = fs::read(folder.path(&format!("{name}/pictures/000003.png"))).unwrap();
        // The width and the height.
        assert_eq!(picture[16..24], [0, 0, 1, 64, 0, 0, 0, 200]);
        assert!(results.insert(picture), "{name}");
        let frame = |name: &str| fs::read(folder.path(&format!("{name}/frames/000003.ply"))).unwrap();
        assert_eq!(frame(name), frame("default"));
        // At half the speed, a time step of 0.02 s takes 0.04 s.
        let animation = fs::read(folder.path(&format!("{name}/motion.png"))).unwrap();
        let control = animation.windows(4).position(|name| name == b"fcTL").unwrap();
        assert_eq!(animation[control + 24..control + 28], [0, 40, 3, 232]);
    }
    folder.write("settings.toml", format!("{SCENE}\n[render]\nsize = [0, 200]\n"));
    let run = folder.run(&["simulate", "settings.toml"]);
    assert_eq!(
        run.error(),
        "settings.toml, line 17, render.size: out of range, expected a width and a height from 16 to 4096 pixels"
    );
}

/// Plots are drawn for any numbers in the table.
#[test]
fn plots_of_any_numbers_are_drawn() {
    let folder = folder();
    let arguments = [
        "simulate",
        "scene.toml",
        "--output",
        "out",
        "--steps",
        "2",
        "--render",
    ];
    assert_eq!(folder.run(&arguments).status, 0);
    let statistics = folder.read("out/statistics.csv");
    let row = statistics.lines().nth(1).unwrap();
    for number in ["inf", "-inf", "NaN", "1e308", "-1e308", "1e-320", "-0"] {
        // The columns of the time, the minimal distance and the energies.
        let changed = row.split(',').enumerate().map(|(column, value)| match column {
            1 | 7 | 10..=14 => number,
            _ => value,
        });
        let changed: Vec<&str> = changed.collect();
        folder.write("out/statistics.csv", statistics.replace(row, &changed.join(",")));
        let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{number}");
        assert!(folder.read("out/energies.svg").ends_with("</svg>\n"));
    }
}

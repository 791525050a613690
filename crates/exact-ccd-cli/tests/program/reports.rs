//! JSON reports against their schema, lists of all contacts, and the files for ParaView.

use exact_ccd_files::{MeshFile, Polygons, read_frame};
use exact_ccd_mesh::Frame;
use serde_json::{Value, json};

use crate::contact_lists::lines;
use crate::folder::{Folder, Run};
use crate::meshes::{fall, tip_above_square};
use crate::queries::{miss, pass, slide};
use crate::query_rows::rows;
use crate::schema::Schema;
use crate::simulate;

#[track_caller]
pub(crate) fn json_of(run: &Run) -> Value {
    assert_eq!(run.stdout.lines().count(), 1, "{run:?}");
    serde_json::from_str(&run.stdout).unwrap()
}

#[test]
fn every_report_has_its_schema() {
    let schema = Schema::of_reports();
    for (from, to) in [(1.0, -2.0), (1.0, 0.5), (-1.0, 1.0), (0.0, 0.0)] {
        let folder = fall(from, to);
        for options in [
            &[][..],
            &["--toi"],
            &["--any"],
            &["--no-start-check"],
            &["--min-distance", "0.125", "--inner-distance", "0"],
            &["--with", "end.ply"],
            &["--half-space", "0,0,0.25,0,0,1", "--any"],
            &["--all", "all.csv", "--view", "page.html"],
            &["--certificate", "step.cert"],
        ] {
            let run = folder.run(&[&["step", "start.ply", "end.ply", "--json"], options].concat());
            schema.assert("motion", &json_of(&run));
        }
        for options in [
            &[][..],
            &["--all", "all.csv"],
            &["--min-distance", "0.125"],
            &["--with", "end.ply"],
            &["--half-space", "0,0,0.25,0,0,1", "--all", "all.jsonl"],
            &["--certificate", "audit.cert"],
        ] {
            let run = folder.run(&[&["audit", "start.ply", "end.ply", "--json"], options].concat());
            schema.assert("motion", &json_of(&run));
        }
        schema.assert(
            "round",
            &json_of(&folder.run(&["round", "start.ply", "end.ply", "--json"])),
        );
    }
    let folder = Folder::new();
    folder.write(
        "vf.csv",
        [miss(), pass(), slide()].map(|query| rows(&query, "")).concat(),
    );
    for method in ["exact", "parity", "FPRF", "TI"] {
        let run = folder.run(&["queries", "--kind", "vf", "--method", method, "--json", "vf.csv"]);
        assert_eq!(run.stdout.lines().count(), 3, "{run:?}");
        for line in run.stdout.lines() {
            schema.assert("query", &serde_json::from_str(line).unwrap());
        }
    }
    std::fs::create_dir_all(folder.path("data/vertex-face")).unwrap();
    folder.write("data/vertex-face/0.csv", rows(&pass(), ",1"));
    // With a method that has no times of impact, and with queries of one class only.
    for methods in ["exact", "exact,parity,IRF"] {
        let run = folder.run(&["bench", "data", "--method", methods, "--json"]);
        let report = json_of(&run);
        schema.assert("bench", &report);
        let rows = report["tables"][0]["rows"].as_array().unwrap();
        assert_eq!(rows.len(), methods.split(',').count());
        assert_eq!(rows[0]["answered"], json!({"colliding": 1, "free": 0}));
    }
    for (options, output, counts) in [
        (&[][..], "vf.parquet", [3, 0, 0]),
        (&["--answers"], "again.csv", [3, 0, 0]),
        (&["data/vertex-face/0.csv"], "all.parquet", [4, 1, 0]),
    ] {
        let run = folder.run(
            &[
                &["convert", "--kind", "vf", "--json", "-o", output, "vf.csv"],
                options,
            ]
            .concat(),
        );
        assert_eq!(run.status, 0, "{run:?}");
        let report = json_of(&run);
        schema.assert("convert", &report);
        let [queries, colliding, free] = counts;
        assert_eq!(
            report,
            json!({"version": 1, "command": "convert", "output": output, "kind": "vf", "queries": queries, "colliding": colliding, "free": free})
        );
    }
    let run = folder.run(&["convert", "--json", "-o", "-", "vf.csv"]);
    assert_eq!(
        run.error(),
        "--json needs a file of --output: with -, standard output has the queries"
    );
}

#[test]
fn time_steps_as_json_lines() {
    let schema = Schema::of_reports();
    let folder = simulate::folder();
    let run = folder.run(&["simulate", "scene.toml", "--json", "--dump-queries", "queries"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let lines: Vec<Value> = run
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let (first, rest) = lines.split_first().unwrap();
    schema.assert("simulation", first);
    assert_eq!([&first["vertices"], &first["steps"]], [&json!(12), &json!(10)]);
    let (last, steps) = rest.split_last().unwrap();
    schema.assert("dumped_queries", last);
    assert_eq!(steps.len(), 10);
    for (step, number) in steps.iter().zip(1..) {
        schema.assert("time_step", step);
        assert_eq!(step["step"], json!(number));
    }
    assert_eq!(steps[9]["time_s"], json!(0.2));
    assert!(steps[9]["contacts"].as_u64() > Some(0));
}

#[test]
fn answers_as_json_lines() {
    let folder = Folder::new();
    folder.write(
        "vf.csv",
        [miss(), pass(), slide()].map(|query| rows(&query, "")).concat(),
    );
    let run = folder.run(&["queries", "--kind", "vf", "--json", "vf.csv"]);
    assert_eq!(
        run.stdout,
        "{\"version\":1,\"command\":\"queries\",\"query\":0,\"contact\":false,\"count\":0,\"toi\":null}\n\
         {\"version\":1,\"command\":\"queries\",\"query\":1,\"contact\":true,\"count\":1,\"toi\":0.3333333333333333}\n\
         {\"version\":1,\"command\":\"queries\",\"query\":2,\"contact\":true,\"count\":-1,\"toi\":0.5}\n"
    );
    let run = folder.run(&[
        "queries", "--kind", "vf", "--json", "--method", "parity", "vf.csv",
    ]);
    assert!(run.stdout.contains("\"count\":\"boundary\""), "{run:?}");
}

/// The mesh and the points with their times in the files for ParaView.
#[track_caller]
fn impact(folder: &Folder) -> (Frame, Vec<[f64; 3]>) {
    let points = folder.path("out/contacts.vtp");
    let points = MeshFile::read(points, Polygons::Refuse).unwrap().frame;
    (
        read_frame(folder.path("out/impact.vtu")).unwrap(),
        points.positions,
    )
}

#[test]
fn the_impact_is_written_for_paraview() {
    let folder = fall(1.0, -1.0);
    let run = folder.run(&[
        "step",
        "start.ply",
        "end.ply",
        "--paraview",
        "out",
        "--all",
        "all.jsonl",
    ]);
    assert_eq!(run.status, 1);
    let (mesh, points) = impact(&folder);
    assert_eq!(mesh, tip_above_square(0.0));
    let list = lines(&folder, "all.jsonl");
    assert_eq!(
        json!(points),
        list.iter()
            .map(|record| record["point"].clone())
            .collect::<Value>()
    );
    let text = folder.read("out/contacts.vtp");
    for name in ["time", "normal", "kind", "id_a", "id_b"] {
        assert!(text.contains(&format!(" Name=\"{name}\" ")), "{name}");
    }

    let run = folder.run(&["audit", "start.ply", "end.ply", "--as-given", "--paraview", "out"]);
    assert_eq!(run.status, 1);
    assert_eq!(impact(&folder), (mesh, points[..1].to_vec()));

    // An answer without a contact leaves no mesh of an earlier one.
    let run = folder.run(&["audit", "start.ply", "start.ply", "--paraview", "out"]);
    assert_eq!(run.status, 0, "{run:?}");
    assert!(!folder.path("out/impact.vtu").exists());
    folder.run(&["audit", "start.ply", "end.ply", "--as-given", "--paraview", "out"]);
    let run = folder.run(&["step", "start.ply", "start.ply", "--paraview", "out"]);
    assert_eq!(run.status, 0);
    assert!(!folder.path("out/impact.vtu").exists() && folder.path("out/contacts.vtp").exists());
}

#[test]
fn an_intersection_is_written_at_rest() {
    let folder = fall(-1.0, 1.0);
    for command in [&["step", "start.ply", "end.ply"][..], &["audit", "start.ply"]] {
        folder.run(&[command, &["--paraview", "out"]].concat());
        let (mesh, points) = impact(&folder);
        assert_eq!(mesh, tip_above_square(-1.0));
        // The first side of the tip meets the square in its middle.
        assert_eq!(points[0], [0.875, 0.5, 0.0]);
    }
}

#[test]
fn files_that_cannot_be_written_are_errors() {
    let folder = fall(1.0, -1.0);
    let error = |option: &[&str]| folder.run(&[&["step", "start.ply", "end.ply"], option].concat());
    folder.write("blocked", "");
    assert!(
        error(&["--paraview", "blocked"])
            .error()
            .starts_with("cannot write blocked: ")
    );
    assert!(
        error(&["--all", "missing/all.csv"])
            .error()
            .starts_with("cannot write missing/all.csv: ")
    );
}

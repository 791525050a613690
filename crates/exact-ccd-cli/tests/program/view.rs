//! The files that `--view` writes, beside the answers that are printed. `viewer/chromium` opens them.

use exact_ccd::{CONTACT, Query, VertexFace};
use serde_json::{Value, json};

use crate::folder::Folder;
use crate::meshes::fall;
use crate::queries::{miss, pass, slide};
use crate::query_rows::rows;
use crate::simulate;

/// The data of a page.
pub(crate) fn data(folder: &Folder, page: &str) -> Value {
    let html = folder.read(page);
    let start = html.split_once(" id=\"page\">").unwrap().1;
    serde_json::from_str(start.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn a_step_has_the_printed_contact_first() {
    let folder = fall(1.0, -1.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--view", "page.html"]);
    assert_eq!(run.status, 1);
    let page = data(&folder, "page.html");
    assert_eq!(page["title"], "start.ply to end.ply");
    let first = run.stdout.lines().nth(1).unwrap();
    assert_eq!(page["verdict"], first);
    assert_eq!(page["contacts"][0]["time"], json!(0.5));
    let primitives = &page["contacts"][0]["primitives"];
    let vertices = |side: usize| primitives[side]["vertices"].to_string().replace(',', ", ");
    assert_eq!(
        first,
        format!(
            "contact at t = 0.5: vertex {} and face {} (vertices {})",
            primitives[0]["id"],
            primitives[1]["id"],
            vertices(1).trim_matches(['[', ']'])
        )
    );
}

#[test]
fn a_step_has_all_contacts_whatever_is_searched_for() {
    let folder = fall(1.0, -1.0);
    let mut counts = Vec::new();
    for option in ["--json", "--toi", "--any"] {
        folder.run(&["step", "start.ply", "end.ply", option, "--view", "page.html"]);
        counts.push(data(&folder, "page.html")["contactCount"].clone());
    }
    assert!(
        counts[0].as_u64() > Some(0) && counts.iter().all(|count| *count == counts[0]),
        "{counts:?}"
    );
}

#[test]
fn a_free_step_has_a_page() {
    let folder = fall(2.0, 1.0);
    assert_eq!(
        folder
            .run(&["step", "start.ply", "end.ply", "--view", "page.html"])
            .status,
        0
    );
    let page = data(&folder, "page.html");
    assert_eq!(
        (&page["contacts"], &page["verdict"]),
        (&json!([]), &json!("free of contact"))
    );
}

#[test]
fn an_audit_has_its_frames_up_to_the_violation() {
    let folder = fall(1.0, -1.0);
    let frames = ["start.ply", "start.ply", "end.ply", "start.ply"];
    let run = folder.run(&[&["audit"], &frames[..], &["--view", "page.html"]].concat());
    assert_eq!(run.status, 1);
    let page = data(&folder, "page.html");
    assert_eq!(page["frames"].as_array().unwrap().len(), 3);
    assert_eq!(page["frames"][2], json!({"number": 2, "label": "end.ply"}));
    let contact = &page["contacts"][0];
    assert_eq!((&contact["frame"], &contact["time"]), (&json!(1), &json!(0.5)));
    assert_eq!(page["verdict"], run.stdout.lines().nth(1).unwrap());
}

#[test]
fn an_audit_has_the_intersection_of_its_first_frame() {
    let folder = fall(-1.0, 1.0);
    let run = folder.run(&["audit", "start.ply", "--view", "page.html"]);
    assert_eq!(run.status, 1);
    let page = data(&folder, "page.html");
    let primitives = &page["contacts"][0]["primitives"];
    let [edge, face] = [0, 1].map(|side: usize| &primitives[side]["id"]);
    assert!(run.stdout.contains(&format!("edge {edge} (")) && run.stdout.contains(&format!("face {face} (")));
    assert_eq!(page["contacts"][0]["closest"][0][2], json!(0.0));
}

/// The page of these queries with these options.
fn of_queries(queries: &[Query<VertexFace>], options: &[&str]) -> Value {
    let folder = Folder::new();
    folder.write(
        "vf.csv",
        queries.iter().map(|query| rows(query, "")).collect::<String>(),
    );
    let run = folder.run(
        &[
            &["queries", "--kind", "vf", "vf.csv", "--view", "page.html"],
            options,
        ]
        .concat(),
    );
    assert_eq!(run.status, 0, "{run:?}");
    data(&folder, "page.html")
}

#[test]
fn the_first_query_in_contact_is_shown() {
    let page = of_queries(&[miss(), pass(), slide()], &[]);
    assert_eq!(page["title"], "Query 1 in vf.csv");
    assert_eq!(
        page["query"]["times"][0][0].as_f64(),
        pass().time_of_impact(CONTACT)
    );
}

#[test]
fn a_query_is_chosen_by_its_number_or_is_the_first() {
    assert_eq!(
        of_queries(&[miss(), pass()], &["--view-query", "0"])["title"],
        "Query 0 in vf.csv"
    );
    assert_eq!(of_queries(&[miss(), miss()], &[])["title"], "Query 0 in vf.csv");
    let slides = of_queries(&[pass(), slide()], &["--view-query", "1"]);
    assert_eq!(slides["query"]["times"], json!([[0.5, 1.0]]));
}

#[test]
fn the_answer_of_the_page_is_exact_for_every_method() {
    let page = of_queries(&[pass()], &["--method", "parity"]);
    assert_eq!(
        page["query"]["times"][0][0].as_f64(),
        pass().time_of_impact(CONTACT)
    );
}

#[test]
fn a_query_that_does_not_exist_is_an_error() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&pass(), ""));
    let options = [
        "queries",
        "--kind",
        "vf",
        "vf.csv",
        "--view",
        "page.html",
        "--view-query",
        "1",
    ];
    let run = folder.run(&options);
    assert_eq!(
        run.error(),
        "there is no query 1 to show: expected a number from 0 below that of the queries"
    );
    assert!(!folder.path("page.html").exists());
}

#[test]
fn a_simulation_has_a_frame_for_each_time_step() {
    let folder = simulate::folder();
    let run = folder.run(&["simulate", "scene.toml", "--steps", "3", "--view", "page.html"]);
    assert_eq!(run.status, 0, "{run:?}");
    let page = data(&folder, "page.html");
    let frames = page["frames"].as_array().unwrap();
    let labels: Vec<&str> = frames
        .iter()
        .map(|frame| frame["label"].as_str().unwrap())
        .collect();
    assert_eq!(labels, ["0 s", "0.02 s", "0.04 s", "0.06 s"]);
    assert_eq!(page["up"], json!([0.0, 1.0, 0.0]));
    assert_eq!(page["faces"], 14);
}

/// The direction upwards on the page of a simulation: of the options, of the scene, against gravity, or y.
#[test]
fn the_scene_has_a_direction_upwards() {
    let up = |before: &str, options: &[&str]| {
        let folder = Folder::new();
        folder.write("scene.toml", simulate::SCENE.replace("[settings]\n", before));
        let simulate = ["simulate", "scene.toml", "--steps", "1", "--view", "page.html"];
        let run = folder.run(&[&simulate[..], options].concat());
        assert_eq!(run.status, 0, "{run:?}");
        data(&folder, "page.html")["up"].clone()
    };
    let sideways = "[settings]\ngravity = [0.0, 0.0, -4.0]\n";
    assert_eq!(up(sideways, &[]), json!([0.0, 0.0, 1.0]));
    assert_eq!(
        up("[settings]\ngravity = [0.0, 0.0, 0.0]\n", &[]),
        json!([0.0, 1.0, 0.0])
    );
    let rendered = "[render]\nup = [2.0, 0.0, 0.0]\n[settings]\n";
    assert_eq!(up(rendered, &[]), json!([1.0, 0.0, 0.0]));
    assert_eq!(up(rendered, &["--view-up", "-z"]), json!([0.0, 0.0, -1.0]));
    assert_eq!(up(rendered, &["--view-up", "0,3,4"]), json!([0.0, 0.6, 0.8]));
}

#[test]
fn a_direction_upwards_is_an_axis_or_three_numbers() {
    let folder = fall(1.0, -1.0);
    for bad in ["w", "0,0,0", "1,2", "nan,0,0", "1e200,0,0"] {
        let run = folder.run(&[
            "step",
            "start.ply",
            "end.ply",
            "--view",
            "page.html",
            "--view-up",
            bad,
        ]);
        assert_eq!(run.status, 2, "{bad}: {run:?}");
        assert!(
            run.stderr
                .contains("expected x, y, z, -x, -y, -z, or three finite numbers"),
            "{run:?}"
        );
    }
    folder.run(&[
        "step",
        "start.ply",
        "end.ply",
        "--view",
        "page.html",
        "--view-up",
        "y",
    ]);
    assert_eq!(data(&folder, "page.html")["up"], json!([0.0, 1.0, 0.0]));
}

/// The bodies have names, and the half space too; the charts have a value for each time step.
#[test]
fn a_simulation_has_its_bodies_and_charts() {
    let folder = Folder::new();
    let floor = "[[half-space]]\nname = \"floor\"\nnormal = [0.0, 2.0, 0.0]\npoint = [0.0, -1.0, 0.0]\n[[body]]\nname = \"cube\"\n";
    folder.write("scene.toml", simulate::SCENE.replacen("[[body]]\n", floor, 1));
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--steps",
        "3",
        "--view",
        "page.html",
        "--json",
    ]);
    assert_eq!(run.status, 0, "{run:?}");
    let page = data(&folder, "page.html");
    assert_eq!(page["verdict"], "all 3 time steps converged");
    assert_eq!(
        page["summary"],
        json!([
            "0.866 m across; contact distance 0.002 m",
            "3 time steps of 0.02 s"
        ])
    );
    assert_eq!(
        page["bodies"],
        json!([
            {"name": "cube", "kind": "solid", "vertices": {"start": 0, "end": 8}},
            {"name": "body-1", "kind": "obstacle", "vertices": {"start": 8, "end": 12}},
        ])
    );
    assert_eq!(
        page["halfSpaces"],
        json!([{"name": "floor", "point": [0.0, -1.0, 0.0], "normal": [0.0, 1.0, 0.0]}])
    );
    let history = &page["history"];
    assert_eq!(history["times"][0], 0.0);
    assert_eq!(history["times"].as_array().unwrap().len(), 4);
    let steps: Vec<Value> = run
        .stdout
        .lines()
        .skip(1)
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let curves = |chart: usize| history["charts"][chart]["curves"].as_array().unwrap();
    let kinetic = curves(0).iter().find(|curve| curve["name"] == "kinetic").unwrap();
    let contacts = curves(history["charts"].as_array().unwrap().len() - 1);
    for (step, statistics) in steps.iter().enumerate() {
        assert_eq!(kinetic["values"][step + 1], statistics["kinetic_J"]);
        assert_eq!(
            contacts[0]["values"][step + 1].as_f64(),
            statistics["contacts"].as_f64()
        );
    }
    assert_eq!(kinetic["values"][0], Value::Null);
}

/// A vertex in a half space is a contact of the page, which opens at the first frame that has one.
#[test]
fn an_audit_has_the_vertices_in_half_spaces() {
    let folder = Folder::new();
    for (name, height) in [("0.obj", 1.0), ("1.obj", 0.5), ("2.obj", -0.25), ("3.obj", -0.5)] {
        folder.write(name, format!("v 0 0 {height}\nv 1 0 2\nv 0 1 2\nf 1 2 3\n"));
    }
    let frames = ["audit", "0.obj", "1.obj", "2.obj", "3.obj"];
    for (options, count) in [(&[][..], 1), (&["--all", "all.csv"][..], 2)] {
        let page = ["--half-space", "0,0,0,0,0,2", "--view", "page.html"];
        let run = folder.run(&[&frames[..], &page, options].concat());
        assert_eq!(run.status, 1, "{run:?}");
        let page = data(&folder, "page.html");
        assert_eq!(
            page["halfSpaces"],
            json!([{"name": "", "point": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0]}])
        );
        let contacts = page["contacts"].as_array().unwrap();
        assert_eq!(contacts.len(), count);
        let first = &contacts[0];
        assert_eq!((&first["frame"], &first["time"]), (&json!(2), &json!(0.0)));
        assert_eq!(first["primitives"][0]["labels"], json!([0]));
        assert_eq!(
            first["primitives"][1],
            json!({"kind": "half-space", "id": 0, "vertices": [], "labels": []})
        );
        assert_eq!(first["closest"], json!([[0.0, 0.0, -0.25], [0.0, 0.0, 0.0]]));
        let verdict = page["verdict"].as_str().unwrap();
        assert_eq!(verdict, "contact in frame 2 (2.obj): vertex 0 and half space 0");
    }
}

/// A vertex that meets a half space in a step is a contact of the page at its first time, among the others.
#[test]
fn a_step_has_its_contacts_with_half_spaces() {
    let folder = fall(2.0, 1.0);
    let floor = |height: &str| format!("0,0,{height},0,0,1");
    // The tip falls from 2 to 1; the square at 0 is below the floor at all times.
    let options = ["--half-space", &floor("1.5"), "--view", "page.html"];
    let run = folder.run(&[&["step", "start.ply", "end.ply"][..], &options].concat());
    assert_eq!(run.status, 1, "{run:?}");
    let page = data(&folder, "page.html");
    let contacts = page["contacts"].as_array().unwrap();
    let times: Vec<f64> = contacts
        .iter()
        .map(|contact| contact["time"].as_f64().unwrap())
        .collect();
    assert!(
        times.is_sorted() && times[0] == 0.0 && times.contains(&0.5),
        "{times:?}"
    );
    let tip = contacts.iter().find(|contact| contact["time"] == 0.5).unwrap();
    assert_eq!(tip["primitives"][1]["kind"], "half-space");
    assert_eq!(tip["closest"][0][2], 1.5);
    assert_eq!(page["halfSpaces"].as_array().unwrap().len(), 1);
    assert_eq!(run.stdout.lines().nth(1).unwrap(), page["verdict"]);
}

/// The headline is the answer, for any input and rules; the parts are bodies.
#[test]
fn the_verdict_is_no_note() {
    let folder = fall(2.0, 1.0);
    folder.write("floor.obj", "v 0 0 -9\nv 1 0 -9\nv 0 1 -9\nf 1 2 3\n");
    let parts = [
        "--with",
        "floor.obj",
        "--min-distance",
        "1e-3",
        "--view",
        "page.html",
    ];
    for command in ["step", "audit"] {
        let run = folder.run(&[&[command, "start.ply", "end.ply"][..], &parts].concat());
        assert_eq!(run.status, 0, "{run:?}");
        let page = data(&folder, "page.html");
        assert_eq!(page["verdict"], "free of contact");
        let summary: Vec<&str> = page["summary"]
            .as_array()
            .unwrap()
            .iter()
            .map(|line| line.as_str().unwrap())
            .collect();
        assert!(
            summary[0].starts_with("part start: vertices 0 to "),
            "{summary:?}"
        );
        assert!(!summary.contains(&"free of contact"), "{summary:?}");
        let names: Vec<&Value> = [0, 1].map(|body: usize| &page["bodies"][body]["name"]).into();
        assert_eq!(names, ["start", "floor"]);
    }
}

/// A mesh that passes through itself at the start has this as its headline.
#[test]
fn an_intersection_at_the_start_is_the_verdict() {
    let folder = fall(-1.0, -2.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--view", "page.html"]);
    assert_eq!(run.status, 1);
    let page = data(&folder, "page.html");
    let verdict = page["verdict"].as_str().unwrap();
    assert!(verdict.starts_with("intersection at t = 0: "), "{verdict}");
    assert_eq!(run.stdout.lines().nth(1), Some(verdict));
}

#[test]
fn a_page_that_cannot_be_written_is_an_error() {
    let folder = fall(1.0, -1.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--view", "missing/page.html"]);
    assert!(
        run.error().starts_with("cannot write missing/page.html: "),
        "{run:?}"
    );
}

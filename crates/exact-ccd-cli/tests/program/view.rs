//! The files that `--view` writes, beside the answers that are printed. `viewer/chromium` opens them.

use exact_ccd::{Query, VertexFace};
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
    assert_eq!(page["summary"][0], first);
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
        (&page["contacts"], &page["summary"][0]),
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
    assert_eq!(page["summary"][0], run.stdout.lines().nth(1).unwrap());
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
    assert_eq!(page["query"]["times"][0][0].as_f64(), pass().time_of_impact());
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
    assert_eq!(page["query"]["times"][0][0].as_f64(), pass().time_of_impact());
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
    assert_eq!(page["up"], json!([-0.0, 9.81, -0.0]));
    assert_eq!(page["faces"], 14);
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

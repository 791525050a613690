//! The forms of coordinates, the kind of queries recognised from files, and empty input.

use exact_ccd::{Kind, Query, VertexEdge, VertexVertex};

use crate::contact_lists::row_of;
use crate::folder::Folder;
use crate::queries::{HEADER, miss, pass, slide};
use crate::query_rows::{file, rows};

/// Rows of one field for each coordinate.
fn fields<K: Kind>(query: &Query<K>, number: impl Fn(f64) -> String) -> String {
    let row = |[x, y, z]: [f64; 3]| [x, y, z].map(&number).join(",") + "\n";
    let points = query.points().iter().flat_map(AsRef::as_ref);
    points.copied().map(row).collect()
}

#[test]
fn decimals_hexadecimal_floats_and_fractions_are_the_same_queries() {
    let folder = Folder::new();
    let queries = [miss(), pass(), slide()];
    folder.write("fractions.csv", queries.map(|query| rows(&query, "")).concat());
    let answers = folder.run(&["queries", "--kind", "vf", "fractions.csv"]);
    assert_eq!(answers.status, 0);
    let hexadecimal = |x: f64| {
        format!(
            "{}0x{:x}p-3",
            if x < 0.0 { "-" } else { "" },
            (8.0 * x.abs()) as u64
        )
    };
    let forms: [&dyn Fn(f64) -> String; 3] =
        [&|x| x.to_string(), &hexadecimal, &|x| format!("{}/8", 8.0 * x)];
    for form in forms {
        folder.write("fields.csv", queries.map(|query| fields(&query, form)).concat());
        assert_eq!(folder.run(&["queries", "--kind", "vf", "fields.csv"]), answers);
    }
    // A decimal stands for the nearest f64; the fraction 1/10 is no f64.
    let tenth = |text: &str| {
        fields(
            &pass(),
            |x| if x == 0.25 { text.to_owned() } else { x.to_string() },
        )
    };
    folder.write("decimals.csv", tenth("0.1"));
    assert_eq!(folder.run(&["queries", "--kind", "vf", "decimals.csv"]).status, 0);
    folder.write("fractions.csv", tenth("1/10"));
    assert_eq!(
        folder.run(&["queries", "--kind", "vf", "fractions.csv"]).error(),
        "fractions.csv, line 1: x of p at t = 0: 1/10 is not exactly an f64"
    );
}

#[test]
fn the_ground_truth_may_follow_three_fields() {
    let folder = Folder::new();
    let with_truth = fields(&pass(), |x| x.to_string()).replace('\n', ",0\n");
    folder.write("vf.csv", with_truth);
    let run = folder.run(&["queries", "--kind", "vf", "vf.csv"]);
    assert_eq!(
        run.stderr,
        "1 queries, 1 in contact; against the ground truth: 1 false positives, 0 false negatives\n"
    );
}

fn meeting_vertices() -> Query<VertexVertex> {
    Query::new([[0.0; 3], [2.0, 0.0, 0.0]], [[1.0, 0.0, 0.0]; 2]).unwrap()
}

fn crossing_vertex() -> Query<VertexEdge> {
    let edge = [[0.0; 3], [1.0, 0.0, 0.0]];
    Query::new(
        [[0.5, 0.0, 1.0], edge[0], edge[1]],
        [[0.5, 0.0, -1.0], edge[0], edge[1]],
    )
    .unwrap()
}

#[test]
fn the_kind_is_recognised_where_it_is_certain() {
    let folder = Folder::new();
    for kind in ["vertex-face", "edge-edge"] {
        std::fs::create_dir(folder.path(kind)).unwrap();
        folder.write(&format!("{kind}/0.csv"), rows(&pass(), ""));
    }
    folder.write("ve.csv", file(&[crossing_vertex()]));
    folder.write("vv.csv", [file(&[meeting_vertices()]), b"\n".to_vec()].concat());
    let run = |arguments: &[&str]| folder.run(&[&["queries"], arguments].concat());
    for (path, kind, note) in [
        ("vertex-face/0.csv", "vf", ""),
        ("edge-edge/0.csv", "ee", ""),
        (
            "ve.csv",
            "ve",
            "exact-ccd: note: ve.csv: 6 rows are queries of the kind ve; --kind names another\n",
        ),
        (
            "vv.csv",
            "vv",
            "exact-ccd: note: vv.csv: 4 rows are queries of the kind vv; --kind names another\n",
        ),
    ] {
        let recognised = run(&[path]);
        let given = run(&["--kind", kind, path]);
        assert_eq!((recognised.status, given.status), (0, 0), "{recognised:?}");
        assert_eq!(recognised.stdout, given.stdout);
        assert_eq!(recognised.stderr, [note, &given.stderr].concat());
    }
    for kind in ["vf", "ee"] {
        let name = format!("{kind}.parquet");
        folder.write("eight.csv", rows(&pass(), ""));
        assert_eq!(
            folder
                .run(&["convert", "--kind", kind, "eight.csv", "-o", &name])
                .status,
            0
        );
        assert_eq!(run(&[&name]), run(&["--kind", kind, &name]));
    }
    // Eight rows are a query of vf or ee, or two of vv.
    let uncertain =
        "eight.csv: the kind of the queries is not certain from the file; --kind vf|ee|ve|vv names it";
    assert_eq!(run(&["eight.csv"]).error(), uncertain);
    assert_eq!(
        folder.run(&["convert", "eight.csv", "-o", "all.csv"]).error(),
        uncertain
    );
    assert!(
        run(&["-"])
            .error()
            .starts_with("-: the kind of the queries is not certain")
    );
    folder.write("damaged.parquet", "PAR1, and nothing that follows");
    let damaged = run(&["damaged.parquet"]);
    assert_eq!(damaged.error(), run(&["--kind", "vf", "damaged.parquet"]).error());
    let differ = run(&["ve.csv", "vv.csv"]);
    let last = "exact-ccd: error: vv.csv: queries of the kind vv, after others of the kind ve\n";
    assert!(differ.status == 2 && differ.stderr.ends_with(last), "{differ:?}");
    let missing = run(&["missing.csv"]);
    assert!(
        missing
            .error()
            .starts_with("missing.csv: no such file or folder, "),
        "{missing:?}"
    );
}

/// A given kind other than the folder's is used, and noted for the first file.
#[test]
fn a_kind_other_than_that_of_the_folder_is_noted() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("edge-edge")).unwrap();
    for name in ["edge-edge/0.csv", "edge-edge/1.csv", "0.csv"] {
        folder.write(name, rows(&pass(), ""));
    }
    let note = "exact-ccd: note: edge-edge/0.csv: read as queries of the kind vf by --kind; the folder is one of the \
                kind ee\n";
    for command in [
        &["queries", "--kind", "vf"][..],
        &["round", "--kind", "vf"],
        &["convert", "-o", "-", "--kind", "vf"],
    ] {
        let run = |names: &[&str]| folder.run(&[command, names].concat());
        let noted = run(&["edge-edge/0.csv", "edge-edge/1.csv"]);
        let silent = run(&["0.csv", "0.csv"]);
        assert_eq!((noted.status, &noted.stdout), (0, &silent.stdout), "{noted:?}");
        assert_eq!(noted.stderr, [note, &silent.stderr].concat());
    }
}

#[test]
fn an_empty_input_is_an_error() {
    let folder = Folder::new();
    folder.write("empty.csv", "\n\n");
    for json in [&[][..], &["--json"]] {
        let run = folder.run(&[&["queries", "--kind", "vf", "empty.csv", "empty.csv"], json].concat());
        assert_eq!(run.error(), "0 queries: the input is empty");
        assert_eq!(run.stdout, if json.is_empty() { HEADER } else { "" });
    }
    assert_eq!(
        folder.run(&["queries", "empty.csv"]).error(),
        "0 queries: the input is empty"
    );
    let run = folder.run_with_input(&["queries", "--kind", "ee", "-"], "");
    assert_eq!(run.error(), "0 queries: the input is empty");
    // The answers of another input stay.
    folder.write("answers.csv", HEADER);
    let run = folder.run(&["queries", "--kind", "vf", "empty.csv", "-o", "answers.csv"]);
    assert_eq!(run.error(), "0 queries: the input is empty");
    assert_eq!(folder.read("answers.csv"), HEADER);
}

#[test]
fn queries_are_converted_to_standard_output() {
    let folder = Folder::new();
    let text = String::from_utf8(file(&[pass(), miss()])).unwrap();
    folder.write("vf.csv", &text);
    let run = folder.run(&["convert", "--kind", "vf", "vf.csv", "-o", "-"]);
    assert_eq!(
        (run.status, run.stdout.as_str(), run.stderr.as_str()),
        (0, text.as_str(), "")
    );
    assert!(!folder.path("-").exists());
}

#[test]
fn converted_answers_may_be_about_a_distance_and_of_any_kind() {
    let folder = Folder::new();
    folder.write("ve.csv", file(&[crossing_vertex()]));
    folder.write("vv.csv", file(&[meeting_vertices()]));
    for (name, kind, d) in [
        ("ve.csv", "ve", "0"),
        ("ve.csv", "ve", "0.25"),
        ("vv.csv", "vv", "0"),
        ("vv.csv", "vv", "0.5"),
    ] {
        let columns = folder.run(&[
            "convert",
            "--kind",
            kind,
            name,
            "--answers",
            "--min-distance",
            d,
            "-o",
            "answers.parquet",
        ]);
        assert_eq!(columns.status, 0, "{columns:?}");
        let answers = folder.run(&["queries", "--kind", kind, "--min-distance", d, name]);
        let answer = answers.stdout.lines().nth(1).unwrap();
        let file = std::fs::File::open(folder.path("answers.parquet")).unwrap();
        let reader = parquet::file::reader::SerializedFileReader::new(file).unwrap();
        let row = row_of(&reader.into_iter().next().unwrap().unwrap());
        let toi = row["toi"].as_f64().unwrap();
        assert_eq!(format!("0,1,{},{toi}", row["count"]), answer);
    }
    let run = folder.run(&[
        "convert",
        "--kind",
        "ve",
        "ve.csv",
        "--min-distance",
        "1",
        "-o",
        "out.csv",
    ]);
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("--answers"), "{run:?}");
}

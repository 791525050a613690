//! The output of `exact-ccd convert` for query files and scenes.

use std::fs;

use exact_ccd::{Query, VertexFace};
use exact_ccd_data::{ColumnReader, Record};
use exact_ccd_files::write_ply;
use exact_ccd_mesh::Frame;

use crate::folder::Folder;
use crate::queries::{HEADER, miss, pass, slide};
use crate::query_rows::{file, rows};

/// A query file with this text in the seventh column of each query.
fn canonical(queries: &[Query<VertexFace>], seventh: &[&str]) -> String {
    let text = String::from_utf8(file(queries)).unwrap();
    let ending = |index: usize| {
        seventh
            .get(index / 8)
            .map_or(String::new(), |value| format!(",{value}"))
    };
    let lines = text.lines().enumerate();
    lines
        .map(|(index, line)| format!("{line}{}\n", ending(index)))
        .collect()
}

fn records(folder: &Folder, name: &str) -> Vec<Record<VertexFace>> {
    let reader = ColumnReader::<VertexFace>::open(&folder.path(name)).unwrap();
    reader.map(|record| record.unwrap()).collect()
}

/// Runs the program, which succeeds without output.
#[track_caller]
fn convert(folder: &Folder, arguments: &[&str]) {
    let run = folder.run(&[&["convert", "--kind", "vf"], arguments].concat());
    assert_eq!(
        (run.status, run.stdout.as_str(), run.stderr.as_str()),
        (0, "", "")
    );
}

/// The reader refuses a file that is very small for its queries, so that the writer makes none.
#[test]
fn repeated_queries_come_back() {
    let folder = Folder::new();
    let text = canonical(&[pass()], &[]).repeat(20_000);
    folder.write("vf.csv", &text);
    convert(&folder, &["vf.csv", "-o", "vf.parquet"]);
    convert(&folder, &["vf.parquet", "-o", "again.csv"]);
    assert!(folder.read("again.csv") == text);
}

#[test]
fn rows_come_back_byte_for_byte() {
    let folder = Folder::new();
    let queries = [pass(), miss(), slide()];
    for (seventh, roots) in [
        (&[][..], &[][..]),
        (&["1", "0", "1"], &[]),
        (&["1", "0", "-1"], &["--roots"]),
    ] {
        let text = canonical(&queries, seventh);
        folder.write("vf.csv", &text);
        convert(&folder, &[&["vf.csv", "-o", "vf.parquet"], roots].concat());
        convert(
            &folder,
            &[&["vf.parquet", "--output", "again.csv"], roots].concat(),
        );
        assert_eq!(folder.read("again.csv"), text);
    }
}

#[test]
fn files_are_joined_and_answered() {
    let folder = Folder::new();
    folder.write("a.csv", rows(&pass(), ",1"));
    folder.write("b.csv", rows(&miss(), ""));
    convert(&folder, &["a.csv", "-o", "a.parquet"]);
    convert(&folder, &["a.parquet", "b.csv", "-o", "plain.parquet"]);
    convert(
        &folder,
        &["a.csv", "b.csv", "--answers", "-o", "answered.parquet"],
    );
    let answers = |name| {
        let answer = |record: Record<_>| (record.sample.truth, record.count, record.toi);
        records(&folder, name).into_iter().map(answer).collect::<Vec<_>>()
    };
    assert_eq!(
        answers("plain.parquet"),
        [(Some(true), None, None), (None, None, None)]
    );
    assert_eq!(
        answers("answered.parquet"),
        [(Some(true), Some(1), Some(1.0 / 3.0)), (None, Some(0), None)]
    );
    convert(&folder, &["--roots", "answered.parquet", "-o", "roots.csv"]);
    assert_eq!(
        folder.read("roots.csv"),
        canonical(&[pass(), miss()], &["1", "0"])
    );
}

#[test]
fn parquet_files_are_queries_too() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&pass(), ",1") + &rows(&slide(), ",0"));
    convert(&folder, &["vf.csv", "-o", "vf.PARQUET"]);
    for command in [&["queries", "--kind", "vf"][..], &["round", "--kind", "vf"]] {
        let run = |file| folder.run(&[command, &[file]].concat());
        assert_eq!(run("vf.PARQUET"), run("vf.csv"));
    }
    assert_eq!(
        folder.run(&["queries", "--kind", "vf", "vf.PARQUET"]).stdout,
        HEADER.to_owned() + "0,1,1,0.3333333333333333\n1,1,-1,0.5\n"
    );
    let run = folder.run(&["queries", "--kind", "ee", "vf.PARQUET"]);
    assert_eq!(run.error(), "vf.PARQUET, query 0: expected ee as kind, found vf");
}

/// Two triangles, the second of which falls on the first.
fn scene() -> Folder {
    let folder = Folder::new();
    for name in ["frames", "boxes", "mma_bool", "roots"] {
        fs::create_dir_all(folder.path("fall").join(name)).unwrap();
    }
    for (time, height) in [(0, 1.0), (1, -0.5)] {
        let at = |z| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
        let frame = Frame::new([at(0.0), at(height)].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        let mut ply = Vec::new();
        write_ply(&mut ply, &frame).unwrap();
        folder.write(&format!("fall/frames/{time}.ply"), ply);
    }
    // The mesh has vertices 0 to 5, edges 6 to 11 and faces 12 and 13.
    folder.write("fall/boxes/0vf.json", "[[0, 13], [3, 12]]");
    folder.write("fall/mma_bool/0vf_mma_bool.json", "[true, false]");
    folder.write(
        "fall/roots/vf.csv",
        "query,count,toi,toi_is_exact,times\n0,1,0.6666666666666666,0,0.6666666666666666\n",
    );
    folder
}

#[test]
fn scenes_fill_in_all_columns() {
    let folder = scene();
    convert(&folder, &["fall", "-o", "fall.parquet"]);
    let records = records(&folder, "fall.parquet");
    let rest = records.iter().map(|record| {
        (
            record.sample.truth,
            record.count,
            record.toi,
            record.scene.as_deref(),
            record.ids,
        )
    });
    assert_eq!(
        rest.collect::<Vec<_>>(),
        [
            (
                Some(true),
                Some(1),
                Some(0.6666666666666666),
                Some("fall"),
                Some([0, 13])
            ),
            (Some(false), Some(0), None, Some("fall"), Some([3, 12])),
        ]
    );
    folder.write(
        "fall/roots/vf.csv",
        "query,count,toi,toi_is_exact,times\n2,1,0,1,0\n",
    );
    let run = folder.run(&["convert", "--kind", "vf", "fall", "-o", "fall.parquet"]);
    assert!(run.error().ends_with("there is no query 2 among 2"), "{run:?}");
}

/// After an error, the file is unchanged, and there is no other file.
#[test]
fn errors_leave_the_output_as_it_was() {
    let folder = Folder::new();
    folder.write("a.csv", rows(&pass(), ",1"));
    folder.write("b.csv", rows(&miss(), ""));
    folder.write("text.parquet", "not a Parquet file");
    folder.write("out.csv", "before");
    for (arguments, expected) in [
        (
            &["a.csv", "b.csv"][..],
            "cannot write out.csv: query 1 has no ground truth, but query 0 has",
        ),
        (
            &["b.csv", "a.csv"],
            "cannot write out.csv: query 1 has a ground truth, but query 0 has none",
        ),
        (
            &["b.csv", "--roots"],
            "cannot write out.csv: query 0 has no number of contacts",
        ),
        (
            &["a.csv", "text.parquet"],
            "text.parquet: expected a Parquet file of queries: the file does not end in PAR1",
        ),
    ] {
        let run = folder.run(&[&["convert", "--kind", "vf", "-o", "out.csv"], arguments].concat());
        assert_eq!(run.error(), expected);
        assert_eq!(folder.read("out.csv"), "before");
        assert_eq!(fs::read_dir(folder.path("")).unwrap().count(), 4);
    }
    let run = folder.run(&["convert", "--kind", "vf", "a.csv", "-o", "missing/out.csv"]);
    assert!(
        run.error().starts_with("cannot write missing/out.csv: "),
        "{run:?}"
    );
}

/// The input can be the output.
#[test]
fn a_file_can_be_replaced_by_its_answers() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&slide(), ",1"));
    convert(&folder, &["vf.csv", "--answers", "-o", "vf.parquet"]);
    convert(&folder, &["vf.parquet", "-o", "vf.parquet"]);
    assert_eq!(records(&folder, "vf.parquet")[0].count, Some(-1));
}

#[test]
fn rounded_queries_have_their_number_of_roots_on_request() {
    let folder = Folder::new();
    folder.write(
        "vf.csv",
        rows(&pass(), ",0") + &rows(&miss(), ",1") + &rows(&slide(), ",0"),
    );
    let round = |output| folder.run(&["round", "--kind", "vf", "--roots", "vf.csv", "--output", output]);
    assert_eq!(round("rounded.csv").status, 0);
    let text = folder.read("rounded.csv");
    let seventh: Vec<_> = text
        .lines()
        .map(|line| line.rsplit_once(',').unwrap().1)
        .collect();
    assert_eq!(seventh, [["1"; 8], ["0"; 8], ["-1"; 8]].concat());
    assert_eq!(round("rounded.parquet").status, 0);
    convert(&folder, &["--roots", "rounded.parquet", "-o", "again.csv"]);
    assert_eq!(folder.read("again.csv"), text);
    assert!(
        records(&folder, "rounded.parquet")
            .iter()
            .all(|record| record.sample.truth.is_none())
    );
}

#[test]
fn a_mesh_is_refused_with_the_commands_that_read_it() {
    let folder = Folder::new();
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for kind in [&[][..], &["--kind", "vf"]] {
        let run = folder.run(&[&["convert", "a.obj", "-o", "a.parquet"], kind].concat());
        let error = run.error();
        assert!(
            error.starts_with("a.obj: this is a mesh, and `convert` converts files of queries"),
            "{error}"
        );
        assert!(error.contains("`exact-ccd step`"), "{error}");
    }
}

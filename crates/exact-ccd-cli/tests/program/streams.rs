//! Standard input, and closed output pipes.

use exact_ccd::{Query, VertexFace};

use crate::folder::{Folder, Run};
use crate::meshes::fall;
use crate::query_rows::rows;

/// A query in contact at all times.
fn resting() -> Query<VertexFace> {
    let at = [[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    Query::<VertexFace>::new(at, at).unwrap()
}

#[test]
fn a_dash_is_standard_input() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&resting(), ""));
    let run = folder.run_with_input(
        &["queries", "--kind", "vf", "vf.csv", "-", "vf.csv"],
        &rows(&resting(), "").repeat(2),
    );
    assert_eq!(
        run.stdout,
        "query,contact,count,toi\n0,1,-1,0\n1,1,-1,0\n2,1,-1,0\n3,1,-1,0\n"
    );
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn errors_in_standard_input_say_so() {
    let run = Folder::new().run_with_input(&["queries", "--kind", "vf", "-"], "1,2\n");
    assert_eq!(
        run.error(),
        "standard input, line 1: expected 3 or 6 fields, or one more for the ground truth, found 2"
    );
}

/// A run whose standard output is a closed pipe.
fn run_unread(folder: &Folder, arguments: &[&str]) -> Run {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    folder.program(arguments).stdout(writer).output().unwrap().into()
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&resting(), ",0").repeat(20_000));
    let run = run_unread(&folder, &["queries", "--kind", "vf", "vf.csv"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn a_closed_pipe_for_a_report_is_no_error() {
    let run = run_unread(&fall(1.0, -2.0), &["round", "start.ply"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn the_status_of_a_step_is_the_answer_even_if_the_pipe_is_closed() {
    for (to, status) in [(-2.0, 1), (0.5, 0)] {
        let run = run_unread(&fall(1.0, to), &["step", "start.ply", "end.ply"]);
        assert_eq!((run.status, run.stderr.as_str()), (status, ""));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_answer_that_cannot_be_written_is_an_error() {
    let full = || std::fs::File::options().write(true).open("/dev/full").unwrap();
    let folder = fall(1.0, -2.0);
    folder.write("vf.csv", rows(&resting(), ""));
    for arguments in [
        &["step", "start.ply", "end.ply"][..],
        &["step", "--json", "start.ply", "end.ply"],
        &["queries", "--kind", "vf", "vf.csv"],
        &["round", "start.ply"],
    ] {
        let run: Run = folder.program(arguments).stdout(full()).output().unwrap().into();
        assert!(run.error().starts_with("cannot write the answer: "), "{run:?}");
    }
    folder.write("many.csv", rows(&resting(), "").repeat(5_000));
    for input in ["vf.csv", "many.csv"] {
        let run = folder.run(&["queries", "--kind", "vf", "--output", "/dev/full", input]);
        assert!(run.error().starts_with("cannot write /dev/full: "), "{run:?}");
    }
}

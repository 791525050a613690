//! A small data folder, valid or with an error.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::fs;
use std::path::Path;

use exact_ccd::{EdgeEdge, VertexEdge, VertexFace};
use exact_ccd_data::{
    DataError, DataFolder, DataKind, QueryReader, RecordedStep, Roots, Rounding, Sample, TimesWithin,
    read_roots,
};
use exact_ccd_files::write_ply;
use exact_ccd_mesh::{Frame, Motion};
use tempfile::TempDir;

/// Two triangles; the second falls on the first.
fn frame(height: f64) -> Frame {
    let at = |z| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
    Frame::new([at(0.0), at(height)].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap()
}

/// A folder with one scene, `fall`, and two files of handcrafted queries.
///
/// The mesh has vertices 0 to 5, edges 6 to 11 and faces 12 and 13.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    let write = |name: &str, contents: &[u8]| {
        let file = folder.path().join(name);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, contents).unwrap();
    };
    for (name, height) in [("9", 1.0), ("10", -0.5)] {
        let mut ply = Vec::new();
        write_ply(&mut ply, &frame(height)).unwrap();
        write(&format!("scenes/fall/frames/{name}.ply"), &ply);
    }
    write("scenes/fall/boxes/9vf.json", b"[[0, 13], [3, 12]]");
    write("scenes/fall/boxes/9ee.json", b"[[6, 11]]");
    write("scenes/fall/mma_bool/9vf_mma_bool.json", b"[true, true]");
    write("scenes/fall/mma_bool/9ee_mma_bool.json", b"[false]");
    write(
        "scenes/fall/roots/vf.csv",
        b"query,count,toi,toi_is_exact,times\n0,1,0.6666666666666666,0,0.6666666666666666\n1,2,0.5,1,0.5 1\n",
    );
    write("handcrafted/b/vertex-face/0.csv", b"");
    write("handcrafted/a/vertex-face/1.csv", b"");
    write("handcrafted/a/vertex-face/notes.txt", b"");
    write("handcrafted/a/edge-edge/0.csv", b"");
    write("handcrafted/b/edge-edge/0.csv", b"");
    for name in [
        "ve-fall-d0.5",
        "vf-fall-d0.5",
        "ve-fall-d",
        "ve-d1",
        "ve-fall-d-1",
    ] {
        write(&format!("separation/{name}.csv"), b"");
        write(&format!("separation/{name}.times.csv"), b"");
    }
    folder
}

fn scene(folder: &TempDir) -> RecordedStep {
    RecordedStep::new(folder.path().join("scenes/fall"))
}

fn samples<K: DataKind>(scene: &RecordedStep) -> Result<Vec<Sample<K>>, DataError> {
    let motion = scene.motion()?;
    scene.samples(&motion.step().unwrap())
}

#[test]
fn scenes_and_handcrafted_files_are_listed_by_name() {
    let folder = folder();
    let data = DataFolder::new(folder.path().to_owned());
    assert_eq!(data.scenes().unwrap(), [scene(&folder)]);
    assert_eq!(scene(&folder).name(), "fall");
    let files = ["a/vertex-face/1.csv", "b/vertex-face/0.csv"];
    assert_eq!(
        data.handcrafted::<VertexFace>().unwrap(),
        files.map(|file| folder.path().join("handcrafted").join(file))
    );
}

#[test]
fn frame_9_is_before_frame_10() {
    let folder = folder();
    let motion = scene(&folder).motion().unwrap();
    assert_eq!(motion, Motion::new(frame(1.0), frame(-0.5)).unwrap());
}

#[test]
fn pairs_become_queries_with_their_verdicts() {
    let folder = folder();
    let scene = scene(&folder);
    let motion = scene.motion().unwrap();
    let step = motion.step().unwrap();
    let faces: Vec<Sample<VertexFace>> = scene.samples(&step).unwrap();
    let queries: Vec<_> = faces.iter().map(|sample| sample.query).collect();
    assert_eq!(
        queries,
        [
            step.query::<VertexFace>([0, 1]).unwrap(),
            step.query::<VertexFace>([3, 0]).unwrap()
        ]
    );
    assert!(faces.iter().all(|sample| sample.truth == Some(true)));
    let edges: Vec<Sample<EdgeEdge>> = scene.samples(&step).unwrap();
    assert_eq!(edges[0].query, step.query::<EdgeEdge>([0, 5]).unwrap());
    assert_eq!(edges[0].truth, Some(false));
}

#[test]
fn roots_are_read_row_by_row() {
    let folder = folder();
    let scene = scene(&folder);
    let file = scene.roots::<VertexFace>().unwrap().unwrap();
    let row = |query, times: &[f64], toi_is_exact| Roots {
        query,
        count: times.len(),
        toi: times[0],
        toi_is_exact,
        times: times.to_vec(),
    };
    assert_eq!(
        read_roots(&file).unwrap(),
        [row(0, &[2.0 / 3.0], false), row(1, &[0.5, 1.0], true)]
    );
}

#[test]
fn missing_published_data_are_no_error() {
    let folder = folder();
    let scene = scene(&folder);
    assert_eq!(scene.queries::<VertexFace>().unwrap(), None);
    fs::remove_dir_all(scene.roots::<VertexFace>().unwrap().unwrap().parent().unwrap()).unwrap();
    assert_eq!(scene.roots::<VertexFace>().unwrap(), None);
}

/// Two falls of a vertex on an edge: one ends at the distance 1/2, the other one at 3/4.
#[test]
fn queries_have_their_times_within_a_distance() {
    let folder = folder();
    let data = DataFolder::new(folder.path().to_owned());
    let [file] = data.separation::<VertexEdge>().unwrap().try_into().unwrap();
    assert_eq!(file.queries, folder.path().join("separation/ve-fall-d0.5.csv"));
    assert_eq!(file.d.get(), 0.5);

    let [high, edge] = ["0,1,0,1,1,1", "-1,1,0,1,0,1\n1,1,0,1,0,1"];
    let text = [(1, 2), (3, 4)].map(|(n, d)| format!("{high}\n{edge}\n0,1,0,1,{n},{d}\n{edge}\n"));
    fs::write(&file.queries, text.concat()).unwrap();
    fs::write(
        folder.path().join("separation/ve-fall-d0.5.times.csv"),
        "query,count,toi,toi_is_exact,intervals\n0,1,1.0,1,1.0:1.0\n",
    )
    .unwrap();
    let mut within = Vec::new();
    for (query, record) in QueryReader::<VertexEdge, _>::open(&file.queries, Rounding::Refuse)
        .unwrap()
        .enumerate()
    {
        let intervals = record.unwrap().sample.query.intervals(file.d);
        let Some(first) = intervals.first() else {
            continue;
        };
        within.push(TimesWithin {
            query,
            count: intervals.len(),
            toi: first.start.lower(),
            toi_is_exact: first.start.is_exact(),
            intervals: vec![[first.start.lower(), first.end.lower()]],
        });
    }
    assert_eq!(file.times().unwrap(), within);
    assert_eq!(within.len(), 1);
}

#[test]
fn intervals_that_are_none_are_an_error() {
    let folder = folder();
    let data = DataFolder::new(folder.path().to_owned());
    let file = &data.separation::<VertexEdge>().unwrap()[0];
    let times = folder.path().join("separation/ve-fall-d0.5.times.csv");
    for (row, problem) in [
        (
            "0,1,0.5,1,0.5",
            "expected two times, as from:to as intervals, found \"0.5\"",
        ),
        (
            "0,1,0.5,1,0.5:2",
            "expected a time from 0 to 1 as intervals, found \"2\"",
        ),
        (
            "0,-1,0.5,1,0.5:1",
            "expected a number of intervals as count, found \"-1\"",
        ),
    ] {
        fs::write(&times, format!("query,count,toi,toi_is_exact,intervals\n{row}\n")).unwrap();
        let expected = format!("{}, line 2: {problem}", times.display());
        assert_eq!(file.times().unwrap_err().to_string(), expected);
    }
}

/// The error that a change to the scene leads to, without the path of the scene.
fn error(change: impl FnOnce(&Path), read: impl FnOnce(&RecordedStep) -> Option<DataError>) -> String {
    let folder = folder();
    let scene_folder = folder.path().join("scenes/fall");
    change(&scene_folder);
    let message = read(&scene(&folder)).unwrap().to_string();
    let prefix = scene_folder.join("").display().to_string();
    message.strip_prefix(&prefix).unwrap().to_owned()
}

#[track_caller]
fn assert_error_with(file: &str, contents: &str, expected: &str) {
    let change = |scene: &Path| fs::write(scene.join(file), contents).unwrap();
    let read = |scene: &RecordedStep| {
        let roots = scene.roots::<VertexFace>().ok()??;
        samples::<VertexFace>(scene).err().or(read_roots(&roots).err())
    };
    assert_eq!(error(change, read), expected);
}

#[test]
fn pairs_that_the_mesh_does_not_have_are_an_error() {
    let file = "boxes/9vf.json";
    for (ids, found) in [("0, 14", [0, 14]), ("0, 11", [0, 11]), ("6, 12", [6, 12])] {
        assert_error_with(
            file,
            &format!("[[3, 12], [{ids}]]"),
            &format!("{file}: pair 1, {found:?}, is no vertex-face pair of this mesh"),
        );
    }
}

#[test]
fn malformed_json_is_an_error_that_names_line_and_column() {
    assert_error_with(
        "boxes/9vf.json",
        "[[0, 13],\n[1]]",
        "boxes/9vf.json: expected a list of pairs of ids: invalid length 1, expected an array of length 2 at line 2 \
         column 3",
    );
    assert_error_with(
        "mma_bool/9vf_mma_bool.json",
        "[true, 1]",
        "mma_bool/9vf_mma_bool.json: expected a list of true and false: invalid type: integer `1`, expected a boolean \
         at line 1 column 8",
    );
}

#[test]
fn there_is_one_verdict_for_each_pair() {
    assert_error_with(
        "mma_bool/9vf_mma_bool.json",
        "[true]",
        "mma_bool/9vf_mma_bool.json: expected a verdict on each of 2 pairs, found 1",
    );
}

#[test]
fn a_scene_has_two_frames_and_one_file_of_each_sort() {
    let motion = |scene: &RecordedStep| scene.motion().err();
    assert_eq!(
        error(
            |scene| fs::remove_file(scene.join("frames/9.ply")).unwrap(),
            motion
        ),
        "frames: expected two frames, found 1"
    );
    let faces = |scene: &RecordedStep| samples::<VertexFace>(scene).err();
    assert_eq!(
        error(
            |scene| fs::write(scene.join("boxes/10vf.json"), "[]").unwrap(),
            faces
        ),
        "boxes: expected one file *vf.json, found 2"
    );
    assert_eq!(
        error(
            |scene| fs::remove_file(scene.join("boxes/9vf.json")).unwrap(),
            faces
        ),
        "boxes: expected one file *vf.json, found 0"
    );
}

#[test]
fn roots_that_are_none_are_an_error() {
    let file = "roots/vf.csv";
    for (row, problem) in [
        ("0,1,0.5,1", "expected 5 fields, found 4"),
        ("-1,1,0.5,1,0.5", "expected an index as query, found \"-1\""),
        (
            "0,one,0.5,1,0.5",
            "expected a number of times as count, found \"one\"",
        ),
        (
            "0,1,nan,1,0.5",
            "expected a time from 0 to 1 as toi, found \"nan\"",
        ),
        ("0,1,0.5,2,0.5", "expected 0 or 1 as toi_is_exact, found \"2\""),
        (
            "0,1,0.5,1,0.5 2",
            "expected a time from 0 to 1 as times, found \"2\"",
        ),
    ] {
        assert_error_with(
            file,
            &format!("query,count,toi,toi_is_exact,times\n{row}\n"),
            &format!("{file}, line 2: {problem}"),
        );
    }
}

/// With more than two frames, each file belongs to the step that starts at the frame of its number.
#[test]
fn a_scene_may_have_many_steps() {
    let folder = folder();
    assert_eq!(
        RecordedStep::steps(&folder.path().join("scenes/fall")).unwrap(),
        [scene(&folder)]
    );

    let path = |name: &str| folder.path().join("scenes/fall").join(name);
    fs::copy(path("frames/10.ply"), path("frames/fall109.ply")).unwrap();
    fs::copy(path("frames/9.ply"), path("frames/fall110.ply")).unwrap();
    fs::write(path("boxes/109vf.json"), "[[3, 12]]").unwrap();
    fs::write(path("mma_bool/109vf_mma_bool.json"), "[false]").unwrap();
    let steps = RecordedStep::steps(&folder.path().join("scenes/fall")).unwrap();
    let names: Vec<_> = steps.iter().map(RecordedStep::name).collect();
    assert_eq!(names, ["fall 9", "fall 10", "fall 109"]);
    assert_eq!(samples::<VertexFace>(&steps[0]).unwrap().len(), 2);
    assert_eq!(samples::<VertexFace>(&steps[2]).unwrap().len(), 1);
    assert_eq!(
        steps[2].frames().unwrap(),
        [path("frames/fall109.ply"), path("frames/fall110.ply")]
    );
    let have_pairs: Vec<_> = steps.iter().map(RecordedStep::has_pairs).collect();
    assert_eq!(have_pairs, [true, false, false]);
}

//! Text scenes of IPC: errors name the file, the line and the keyword.

use crate::Folder;

const ONE: &str = "shapes input 1\nbox.msh 0 1 0  0 0 0  1 1 1";

#[test]
fn errors_name_line_and_keyword() {
    let folder = Folder::new("errors");
    let unsupported = [
        ("energy MR", "`energy`: this elastic energy"),
        (
            "timeIntegration NM 0.25 0.5",
            "`timeIntegration`: another time integration than implicit Euler (`BE`)",
        ),
        (
            "constraintSolver SQP",
            "`constraintSolver`: another treatment of contact than by barriers",
        ),
        (
            "selfCollisionOff",
            "`selfCollisionOff`: meshes that pass through each other",
        ),
        ("script dragright", "`script`: the script `dragright`"),
        ("restart status100", "`restart`: a state of IPC"),
        (
            "rotateModel 1 0 0 -90",
            "`rotateModel`: a rotation of all shapes against their rest shape",
        ),
        ("tuning 1\n100", "`tuning`: a fixed stiffness of the barrier"),
        (
            "tuning 3\n0\n1e-3\n1e-4",
            "`tuning`: a continuation from one distance to another",
        ),
        ("tol 2\n1e-3\n1e-4", "`tol`: a tolerance for each time step"),
    ];
    for (index, (keyword, expected)) in unsupported.into_iter().enumerate() {
        let file = format!("{index}.txt");
        let error = folder.import(&file, &format!("{ONE}\n{keyword}\n")).unwrap_err();
        let (keyword, what) = expected.split_once(": ").unwrap();
        let expected = format!("{file}, line 3, {keyword}: exact-ccd has no counterpart of {what}: ");
        assert!(error.starts_with(&expected), "{error}");
    }
    let invalid = [
        ("dhat 1e-3", "`dhat`: the keyword is unknown to IPC"),
        (
            "time 5",
            "`time`: found nothing, expected the duration and the time step in s",
        ),
        (
            "time 5 fast",
            "`time`: found `fast`, expected the duration and the time step in s",
        ),
        (
            "density nan",
            "`density`: found `nan`, expected a density in kg/m³",
        ),
        ("fricIterAmt x", "`fricIterAmt`: found `x`, expected an integer"),
        (
            "tol 2\n1e-3",
            "`tol`: found the end of the file, expected 2 numbers in the lines that follow",
        ),
        (
            "tol 1\n1e-3 1e-3",
            "`tol`: found 2 numbers, expected 1 numbers in the lines that follow",
        ),
        (
            "shapes input 1",
            "`shapes`: found the end of the file, expected 1 lines with a shape each",
        ),
        (
            "shapes input 99999999",
            "`shapes`: found `99999999`, expected at most 10000 shapes",
        ),
        (
            "shapes input",
            "`shapes`: found nothing, expected the number of shapes",
        ),
    ];
    for (index, (keyword, expected)) in invalid.into_iter().enumerate() {
        let file = format!("{index}.txt");
        let error = folder.import(&file, &format!("{ONE}\n{keyword}\n")).unwrap_err();
        assert_eq!(error, format!("{file}, line 3, {expected}"));
    }
}

#[test]
fn errors_of_shapes_name_the_attribute() {
    let folder = Folder::new("shape-errors");
    let hold = "DBC 0 0 0  0 1 1  0 0 0  0 0 0";
    let cases = [
        (
            "box.msh 0 1 0 0 0 0 1 1",
            "",
            "`box.msh`: found nothing, expected three scale factors",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 colour",
            "",
            "`colour`: the keyword is unknown to IPC",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 DBC 0 0",
            "",
            "`DBC`: found nothing, expected the lower and the upper corner",
        ),
        (
            "edge.seg 0 1 0 0 0 0 1 1 1",
            "",
            "`edge.seg`: exact-ccd has no counterpart of an obstacle of edges or of points",
        ),
        (
            "box.node 0 1 0 0 0 0 1 1 1",
            "",
            "`box.node`: found `box.node`, expected a .msh file of tetrahedra",
        ),
        (
            "none.msh 0 1 0 0 0 0 1 1 1",
            "",
            "`none.msh`: there is no file none.msh in the folder",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 meshSeq folder",
            "",
            "`meshSeq`: exact-ccd has no counterpart of a sequence of meshes",
        ),
        (
            "floor.obj 0 1 0 0 0 0 1 1 1",
            "script fall\n",
            "`floor.obj`: exact-ccd has no counterpart of a surface that nothing holds",
        ),
        (
            "floor.obj 0 1 0 0 0 0 1 1 1 initVel 0 0 0 0 0 0",
            "",
            "`initVel`: exact-ccd has no counterpart of an initial velocity of a surface",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 linearVelocity 0 0 0",
            "script twist\n",
            "`linearVelocity`: exact-ccd has no counterpart of an attribute that IPC ignores",
        ),
        (
            &format!("box.msh 0 1 0 0 0 0 1 1 1 linearVelocity 0 0 0 {hold}"),
            "",
            "`DBC`: exact-ccd has no counterpart of the sum of a motion of the shape and of one of its vertices",
        ),
        (
            &format!("box.msh 0 1 0 0 0 0 1 1 1 {hold} DBC 0 0 0 1 1 1  0 0 0 0 0 0"),
            "",
            "`DBC`: exact-ccd has no counterpart of a vertex in two boxes at the same time, of which IPC adds the motions,",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 DBC 0 0 0 0 1 1 0 0 0 0 0 9 1",
            "",
            "`DBC`: exact-ccd has no counterpart of a rotation of vertices that were free, or that moved in other \
             boxes, about their center",
        ),
        (
            "box.msh 0 1 0 0 0 0 1 1 1 DBC 0 0 0 0 1 1 0 0 0 9 0 0 0 1 DBC 0 0 0 1 1 1 0 0 0 0 9 0 1",
            "",
            "`DBC`: exact-ccd has no counterpart of a rotation of vertices that were free, or",
        ),
    ];
    for (index, (shape, before, expected)) in cases.into_iter().enumerate() {
        let file = format!("{index}.txt");
        let error = folder
            .import(&file, &format!("{before}shapes input 1\n{shape}\n"))
            .unwrap_err();
        let line = 2 + before.lines().count();
        assert!(
            error.starts_with(&format!("{file}, line {line}, {expected}")),
            "{error}"
        );
    }
}

/// An error of the scene itself, after the import, is one of the TOML file.
#[test]
fn errors_of_the_scene_name_the_field() {
    let folder = Folder::new("scene-errors");
    let error = folder
        .scene("scene.txt", &format!("{ONE}\ndensity -1\n"))
        .err()
        .unwrap();
    assert!(error.starts_with("scene.txt as TOML, line "), "{error}");
    assert!(
        error.ends_with("body[0].solid.density: `density` is -1, expected a positive number"),
        "{error}"
    );
    let error = folder.scene("scene.txt", "ground 0 0\n").err().unwrap();
    assert!(error.contains("the scene has no body"), "{error}");
}

/// All lines that cannot be imported are in one error.
#[test]
fn all_errors_are_reported_at_once() {
    let folder = Folder::new("all-errors");
    let text = format!("colour 1\n{ONE}\nenergy MR\ndensity 500\nscript dragright\n");
    let error = folder.import("all.txt", &text).unwrap_err();
    let lines: Vec<&str> = error.lines().collect();
    assert_eq!(lines.len(), 3, "{error}");
    assert!(lines[0].starts_with("all.txt, line 1, `colour`: "), "{error}");
    assert!(lines[1].starts_with("all.txt, line 4, `energy`: "), "{error}");
    assert!(lines[2].starts_with("all.txt, line 6, `script`: "), "{error}");
}

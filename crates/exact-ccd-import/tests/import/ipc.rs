//! Text scenes of IPC: keywords and their meaning.

use exact_ccd_scene::Scene;

use crate::imported::{assert_lines, assert_placed, has};
use crate::{Folder, exact};

/// A scene with one body.
const ONE: &str = "shapes input 1\nbox.msh 0 1 0  0 0 0  1 1 1\n";

/// A length in fractions of the diagonal of its box.
fn length(fraction: f64) -> String {
    format!("absolute = {}", fraction * 3.5_f64.sqrt())
}

#[test]
fn a_scene_without_settings_has_the_defaults_of_ipc() {
    let folder = Folder::new("defaults");
    let imported = folder.import("scene.txt", ONE).unwrap();
    let expected = r#"# Imported from scene.txt, a scene of IPC.
duration = 5.0

[settings]
time-step = 0.025
gravity = [0.0, -9.80665, 0.0]
integrator = "implicit-euler"
damping = 0.0
formulation = "sum"
line-search = "common"
max-iterations = 10000
max-substeps = 8
ccd = "exact"

[settings.contact-distance]
THOUSANDTH

[settings.friction]
coefficient = 0.0
lags = 1

[settings.friction.static-velocity]
THOUSANDTH

[settings.tolerance]
HUNDREDTH

[[body]]
mesh = "box.msh"
translate = [0.0, 1.0, 0.0]

[body.solid]
density = 1000.0
young = 100000.0
poisson = 0.4
energy = "neo-hookean"
"#;
    let expected = expected.replace("THOUSANDTH", &length(1e-3));
    assert_eq!(imported.toml, expected.replace("HUNDREDTH", &length(1e-2)));
    assert!(imported.notes.is_empty(), "{:?}", imported.notes);
}

#[test]
fn each_keyword_changes_its_setting() {
    let folder = Folder::new("keywords");
    let cases = [
        ("time 2 0.01", "duration = 2.0\n[settings]\ntime-step = 0.01"),
        ("density 500", "density = 500.0"),
        ("stiffness 2e4 0.3", "young = 20000.0\npoisson = 0.3"),
        ("turnOffGravity", "gravity = [0.0, 0.0, 0.0]"),
        ("energy NH", "energy = \"neo-hookean\""),
        ("energy FCR", "energy = \"fixed-corotated\""),
        ("timeIntegration BE", "integrator = \"implicit-euler\""),
        ("dampingRatio 0", "damping = 0.0"),
        ("dampingStiff 0", "damping = 0.0"),
        // ¾ r h for the time step h, and s / h².
        ("dampingRatio 0.5\ntime 2 0.5", "stiffness-damping = 0.1875"),
        ("dampingRatio 4\ntime 2 0.5", "stiffness-damping = 0.375"),
        ("time 2 0.5\ndampingStiff 0.5", "stiffness-damping = 2.0"),
        ("selfFric 0.3", "[settings.friction]\ncoefficient = 0.3\nlags = 1"),
        ("fricIterAmt 4", "coefficient = 0.0\nlags = 4"),
        ("fricIterAmt -1", "coefficient = 0.0\nlags = 100"),
        (
            "useAbsParameters\ndHat 2e-3",
            "[settings.contact-distance]\nabsolute = 0.002",
        ),
        ("useAbsParameters", "[settings.tolerance]\nabsolute = 0.01"),
        (
            "ground 0 0.25",
            "[[half-space]]\npoint = [0.0, 0.25, 0.0]\nnormal = [0.0, 1.0, 0.0]",
        ),
        (
            "halfSpace 1 2 3  1 2 0  50 0",
            "[[half-space]]\npoint = [1.0, 2.0, 3.0]\nnormal = [1.0, 2.0, 0.0]",
        ),
        ("constraintSolver interiorPoint", "duration = 5.0"),
        ("constraintSolver IP", "duration = 5.0"),
        ("selfCollisionOn # a comment", "duration = 5.0"),
        ("section SQP QP\ntime 1 0.5\nsection end", "duration = 5.0"),
        ("section SQP\ntime 1 0.5", "duration = 5.0"),
        (
            "section SQP interiorPoint\ntime 1 0.5\nsection end",
            "duration = 1.0",
        ),
        ("script null", "duration = 5.0"),
        ("script DCOBallHitWall 1 67", "velocity = [67.0, 0.0, 0.0]"),
        ("script DCOBallHitWall", "velocity = [1000.0, 0.0, 0.0]"),
    ];
    let cases = cases.map(|(keyword, lines)| (format!("{ONE}{keyword}\n"), lines));
    assert_lines(&folder, "txt", cases);
}

/// Relative lengths are fractions of the diagonal of the box of the solids along the axes, which is not the
/// size of exact-ccd.
#[test]
fn relative_lengths_are_those_of_the_box() {
    let folder = Folder::new("relative");
    let cases = [
        ("dHat 1e-4", "contact-distance", 1e-4),
        ("epsv 1e-5", "friction.static-velocity", 1e-5),
        ("tol 2\n1e-3\n1e-3", "tolerance", 1e-3),
        (
            "tuning 6\n0\n2e-3 2e-3\n1e-9\n3e-3\n3e-3",
            "contact-distance",
            2e-3,
        ),
        (
            "tuning 5\n0\n2e-3\n2e-3\n1e-9\n3e-3",
            "friction.static-velocity",
            3e-3,
        ),
        ("# dHat 1", "contact-distance", 1e-3),
    ];
    for (keyword, name, fraction) in cases {
        let lines = format!("[settings.{name}]\n{}", length(fraction));
        assert_lines(&folder, "txt", [(format!("{ONE}{keyword}\n"), lines.as_str())]);
    }
    // The box of a box that turns by 45° about z has the sides 1.5/√2, 1.5/√2 and 1.5.
    let turned = "shapes input 1\nbox.msh 0 1 0  0 0 45  1 1 1\n";
    let imported = folder.import("turned.txt", turned).unwrap();
    let (_, distance) = imported
        .toml
        .split_once("[settings.contact-distance]\nabsolute = ")
        .unwrap();
    let distance: f64 = distance.lines().next().unwrap().parse().unwrap();
    assert!(
        (distance / (1e-3 * 4.5_f64.sqrt()) - 1.0).abs() < 1e-14,
        "{distance}"
    );
}

#[test]
fn what_concerns_viewing_or_methods_is_a_note() {
    let folder = Folder::new("notes");
    let reasons = [
        (
            "view orthographic",
            "`view`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "zoom 0.3",
            "`zoom`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "cameraTracking",
            "`cameraTracking`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "playBackSpeed 2",
            "`playBackSpeed`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "appendStr name",
            "`appendStr`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "disableCout",
            "`disableCout`: ignored: it concerns the viewing and the output of IPC",
        ),
        (
            "warmStart 2",
            "`warmStart`: ignored: it concerns the method by which IPC solves a time step",
        ),
        (
            "CCDMethod TightInclusion",
            "`CCDMethod`: ignored: contact is decided exactly; `settings.ccd` selects another method",
        ),
        (
            "kappaMinMultiplier 1e9",
            "`kappaMinMultiplier`: ignored: the stiffness of the barrier is chosen automatically",
        ),
        (
            "QPSolver OSQP",
            "`QPSolver`: ignored: it concerns other solvers of IPC than the interior point",
        ),
        ("ground 0 0.5 50", "`ground`: `50` is ignored, as by IPC"),
    ];
    for (index, (keyword, expected)) in reasons.into_iter().enumerate() {
        let imported = folder
            .import(&format!("{index}.ipc"), &format!("{ONE}{keyword}\n"))
            .unwrap();
        let [note] = &imported.notes[..] else {
            panic!("{keyword}: {:?}", imported.notes);
        };
        assert!(
            note.to_string().ends_with(&format!(".ipc, line 3, {expected}")),
            "{note}"
        );
    }
}

/// An import followed by the TOML file is the same as the scene itself.
#[test]
fn the_toml_file_is_the_scene() {
    let folder = Folder::new("toml");
    let text = "shapes input 2\n\
                box.msh 0 1 0  10 20 30  1 2 3  material 300 1e6 0.3  initVel 1 2 3 90 0 0\n\
                box.msh 2 0 0  0 0 45  1 1 1  DBC 0 0 0 0.1 1 1  0 0.1 0  0 0 0\n\
                selfFric 0.2\nground 0.2 -5\ntime 1 0.01\n";
    let scene = folder.scene("scene.txt", text).unwrap();
    let imported = folder.import("scene.txt", text).unwrap();
    let again = Scene::parse(&imported.toml, &folder.path.join("scene.toml"), None, &exact).unwrap();
    assert_eq!(
        scene.simulation.system().start(),
        again.simulation.system().start()
    );
    assert_eq!(
        scene.simulation.system().masses(),
        again.simulation.system().masses()
    );
    assert_eq!(scene.simulation.settings(), again.simulation.settings());
    assert_eq!(scene.steps, 100);
    let [mut first, mut second] = [scene, again].map(|scene| scene.simulation);
    first.step().unwrap();
    second.step().unwrap();
    assert_eq!(first.state(), second.state());
}

/// Scaling, then rotation about z, then y, then x, then translation.
#[test]
fn shapes_are_placed_as_in_ipc() {
    let folder = Folder::new("placement");
    let text = "shapes input 1\nbox.msh 1 2 3  90 0 90  2 3 4\n";
    let scene = folder.scene("scene.txt", text).unwrap();
    // (x, y, z) → (2x, 3y, 4z) → about z by 90°: (−3y, 2x, 4z) → about x by 90°: (−3y, −4z, 2x).
    assert_placed(&scene, |[x, y, z]| [1.0 - 3.0 * y, 2.0 - 4.0 * z, 3.0 + 2.0 * x]);
}

/// A half turn about one axis and any turn about another one are a half turn.
#[test]
fn half_turns_are_imported() {
    let folder = Folder::new("half-turns");
    let with = |name: &str, angles: &str| {
        let text = format!("shapes input 1\nbox.msh 0 9 0  {angles}  1 1 1\n");
        folder.scene(name, &text).unwrap()
    };
    assert_placed(&with("straight.txt", "180 180 0"), |[x, y, z]| [-x, 9.0 - y, z]);
    // About y by 90°: (z, y, −x), then about x by 180°.
    assert_placed(&with("oblique.txt", "180 90 0"), |[x, y, z]| [z, 9.0 - y, x]);
}

#[test]
fn all_kinds_of_shapes_are_imported() {
    let folder = Folder::new("shapes");
    let one = folder.import("one.txt", "shape input box.msh\n").unwrap();
    assert!(
        has(&one, "[[body]]\nmesh = \"box.msh\"\n[body.solid]"),
        "{}",
        one.toml
    );
    let text = "shapeMatrix input 2 1 2  1 0 0\nbox.msh 2 5 3  0 0 0  1 1 1  material 10 1e4 0.1\n";
    let matrix = folder.import("matrix.txt", text).unwrap();
    for translate in [
        "[1.0, 0.0, 0.0]",
        "[1.0, 0.0, 3.0]",
        "[3.0, 0.0, 0.0]",
        "[3.0, 0.0, 3.0]",
    ] {
        let lines =
            format!("translate = {translate}\n[body.solid]\ndensity = 10.0\nyoung = 10000.0\npoisson = 0.1");
        assert!(has(&matrix, &lines), "{}", matrix.toml);
    }
    // The square has sides of 4 m and its mean at the origin.
    let text = "shapes input 1\nbox.msh 0 1 0 0 0 0 1 1 1\nmeshCO floor.obj 1 -2 3  8 50 0 rotate 0 90 0\n";
    let obstacle = folder.import("obstacle.txt", text).unwrap();
    let lines = "[[body]]\nmesh = \"floor.obj\"\nscale = 2.0\ntranslate = [1.0, -2.0, 3.0]\n\
                 [body.rotate]\naxis = [0.0, 1.0, 0.0]\ndegrees = 90.0";
    assert!(has(&obstacle, lines), "{}", obstacle.toml);
}

/// Half spaces have friction of their own. Meshes of `meshCO` have none in IPC, whatever their coefficient.
#[test]
fn friction_of_obstacles_is_that_of_pairs() {
    let folder = Folder::new("friction");
    let text = format!(
        "{ONE}meshCO floor.obj 0 -9 0  8 50 0.7\nselfFric 0.3\nground 0.3 -20\nhalfSpace 0 -30 0  0 1 0  50 0.5\n"
    );
    let (scene, notes) = folder.scene_with_notes("scene.txt", &text).unwrap();
    assert_eq!(
        scene.simulation.system().names(),
        ["shapes", "mesh-1", "", "half-space-2"]
    );
    assert_eq!(scene.simulation.settings().friction.coefficient, 0.3);
    let pairs = scene.simulation.settings().friction.pairs.iter();
    let pairs: Vec<(&str, &str, f64)> = pairs
        .map(|pair| (&*pair.between[0], &*pair.between[1], pair.coefficient))
        .collect();
    assert_eq!(
        pairs,
        [("shapes", "mesh-1", 0.0), ("shapes", "half-space-2", 0.5)]
    );
    let notes: Vec<String> = notes.iter().map(ToString::to_string).collect();
    assert!(
        notes.len() == 1 && notes[0].ends_with("scene.txt, line 3, `meshCO`: contact with this mesh is frictionless, as in IPC, which does not use the coefficient"),
        "{notes:?}"
    );
    // No names if all coefficients are the same.
    let scene = folder
        .scene("same.txt", &format!("{ONE}selfFric 0.3\nground 0.3 -20\n"))
        .unwrap();
    assert_eq!(scene.simulation.system().names(), ["", ""]);
    assert!(scene.simulation.settings().friction.pairs.is_empty());
}

/// `size` scales the scene, and moves its lower corner to the origin.
#[test]
fn size_scales_the_whole_scene() {
    let folder = Folder::new("size");
    let text = "shapes input 2\nbox.msh -1 2 0  0 0 0  1 1 1\nbox.msh 2.5 2 0  0 0 0  1 1 1\nsize 2\n";
    let scene = folder.scene("scene.txt", text).unwrap();
    let bounds: exact_ccd_mesh::Aabb = scene.simulation.system().start().iter().copied().collect();
    assert_eq!(bounds.lower, [0.0; 3]);
    // The longest side is along x, of 4 m.
    assert_eq!(bounds.upper, [2.0, 0.5, 0.75]);
}

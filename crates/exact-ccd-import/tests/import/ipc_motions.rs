//! Text scenes of IPC: prescribed motions, forces and scripts.

use exact_ccd_mesh::Point;
use exact_ccd_sim::Simulation;

use crate::Folder;
use crate::imported::has;

/// A body with attributes, weightless.
fn with(attributes: &str) -> String {
    format!("turnOffGravity\ntime 1 0.1\nshapes input 1\nbox.msh 0 1 0  0 0 0  1 1 1 {attributes}\n")
}

/// The state of a scene after some time steps.
fn after(folder: &Folder, attributes: &str, steps: usize) -> Simulation {
    let scene = folder.scene("run.txt", &with(attributes)).unwrap();
    let mut simulation = scene.simulation;
    for _ in 0..steps {
        assert!(simulation.step().unwrap().converged);
    }
    simulation
}

/// The greatest difference of coordinates of two lists of points.
fn difference(points: &[Point], others: &[Point]) -> f64 {
    let pairs = points.iter().flatten().zip(others.iter().flatten());
    pairs.fold(0.0, |greatest, (a, b)| f64::max(greatest, (a - b).abs()))
}

#[test]
fn velocities_of_a_shape_move_all_its_vertices() {
    let folder = Folder::new("velocities");
    let imported = folder
        .import("linear.txt", &with("linearVelocity 1 2 3"))
        .unwrap();
    assert!(
        has(
            &imported,
            "[body.script.motion.moving]\nvelocity = [1.0, 2.0, 3.0]"
        ),
        "{}",
        imported.toml
    );
    // A quarter of a turn in 1 s about the center of the box, while it moves.
    let simulation = after(&folder, "angularVelocity 0 90 0  linearVelocity 1 0 0", 10);
    let turned = |[x, y, z]: Point| [0.25 + (z - 0.75) + 1.0, y + 1.0, 0.75 - (x - 0.25)];
    let expected: Vec<Point> = crate::solid().points.into_iter().map(turned).collect();
    assert!(difference(&simulation.state().positions, &expected) < 1e-9);
}

/// In each time step, IPC turns about z, then about y, then about x.
#[test]
fn rotations_about_several_axes_are_those_of_time_steps() {
    let folder = Folder::new("axes");
    let simulation = after(&folder, "angularVelocity 30 90 -60", 1);
    let [x, y, z] = [30.0_f64, 90.0, -60.0].map(|degrees| (0.1 * degrees).to_radians());
    let turned = |point: Point| {
        let p = [point[0] - 0.25, point[1] - 0.5, point[2] - 0.75];
        let p = [
            z.cos() * p[0] - z.sin() * p[1],
            z.sin() * p[0] + z.cos() * p[1],
            p[2],
        ];
        let p = [
            y.cos() * p[0] + y.sin() * p[2],
            p[1],
            y.cos() * p[2] - y.sin() * p[0],
        ];
        let p = [
            p[0],
            x.cos() * p[1] - x.sin() * p[2],
            x.sin() * p[1] + x.cos() * p[2],
        ];
        [p[0] + 0.25, p[1] + 1.5, p[2] + 0.75]
    };
    let expected: Vec<Point> = crate::solid().points.into_iter().map(turned).collect();
    assert!(difference(&simulation.state().positions, &expected) < 1e-12);
}

/// Boxes are relative to the box of the mesh before its placement, and contain vertices of the surface only.
#[test]
fn boxes_select_vertices_of_the_surface() {
    let folder = Folder::new("boxes");
    let end = folder
        .import("end.txt", &with("DBC 0.9 0 0  1.1 1 1  0 0 0.5  0 0 0"))
        .unwrap();
    let lines = "[[body.script]]\n[body.script.vertices.box]\nlower = [0.5, 1.0, 0.0]\nupper = [0.5, 2.0, 1.5]\n\
                 [body.script.motion.moving]\nvelocity = [0.0, 0.0, 0.5]";
    assert!(has(&end, lines), "{}", end.toml);
    // All vertices but the one in the middle, which is number 13 of 27.
    let hull = folder
        .import("hull.txt", &with("DBC 0 0 0  1 1 1  0 0 0  0 0 0"))
        .unwrap();
    let vertices: Vec<String> = (0..27)
        .filter(|&vertex| vertex != 13)
        .map(|vertex| vertex.to_string())
        .collect();
    let lines = format!(
        "[[body.script]]\nmotion = \"fixed\"\n[body.script.vertices]\nvertices = [{}]",
        vertices.join(", ")
    );
    assert!(has(&hull, &lines), "{}", hull.toml);
    let scene = folder
        .scene("hull.txt", &with("DBC 0 0 0  1 1 1  0 0 0  0 0 0"))
        .unwrap();
    let free: Vec<usize> = (0..27)
        .filter(|&vertex| scene.simulation.system().is_free(vertex))
        .collect();
    assert_eq!(free, [13]);
}

/// The motions of a box that follow each other, with a rotation about the center that it then has, and the
/// time in which it is free.
#[test]
fn boxes_move_one_after_the_other_and_release_their_vertices() {
    let folder = Folder::new("times");
    let held = "DBC 0 0 0  0 1 1  1 0 0  0 0 0  0 0.5 \\\n DBC 0 0 0  0 1 1  0 1 0  0 0 90  0.5";
    // The corner is turned by 45° about the center of the side, which moves by 0.5 m along x, then along y.
    let simulation = after(&folder, held, 10);
    let turn = core::f64::consts::FRAC_PI_4;
    let start: Vec<Point> = after(&folder, held, 0).state().positions.clone();
    let side = start.iter().zip(&simulation.state().positions);
    for (start, end) in side.filter(|(start, _)| start[0] == 0.0) {
        let arm = start[1] - 1.5;
        let expected = [0.5 - turn.sin() * arm, 2.0 + turn.cos() * arm, start[2]];
        assert!(difference(&[expected], &[*end]) < 1e-9, "{end:?} {expected:?}");
    }
    let released = folder
        .import("one.txt", &with("DBC 0 0 0  0 1 1  0 0 0  0 0 0  0 0.5"))
        .unwrap();
    assert!(has(&released, "release = 0.5"), "{}", released.toml);
    let global = format!("DBCTimeRange 0 0.25\n{}", with("DBC 0 0 0  0 1 1  0 0 0  0 0 0"));
    let released = folder.import("global.txt", &global).unwrap();
    assert!(has(&released, "release = 0.25"), "{}", released.toml);
}

/// A box that is free until a time, is held from where it then is, and is free again.
#[test]
fn boxes_are_held_from_a_time_on() {
    let folder = Folder::new("late");
    let late = "DBC 0 0 0  1 1 1  0 0 2  0 0 0  0.3 0.5 \\\n DBC 0 0 0  1 1 1  0 0 0  0 0 0  0.8";
    let imported = folder.import("late.txt", &with(late)).unwrap();
    for lines in [
        "from = 0.3\nrelease = 0.5\n[body.script.vertices]",
        "motion = \"fixed\"\nfrom = 0.8\n[body.script.vertices]",
    ] {
        assert!(has(&imported, lines), "{}", imported.toml);
    }
    // In free motion along x; then along z by 0.4 m in 0.2 s, and at this velocity for 0.3 s.
    let simulation = after(&folder, &format!("initVel 1 0 0 0 0 0 {late}"), 10);
    let center = simulation.state().positions[13];
    assert!((center[2] - 0.75).abs() > 0.3, "{center:?}");
    let start = after(&folder, late, 0).state().positions.clone();
    for (start, end) in start
        .iter()
        .zip(&simulation.state().positions)
        .filter(|(start, _)| start[0] == 0.0)
    {
        let moved = [end[0] - start[0], end[2] - start[2]];
        assert!(moved[0] > 0.2 && moved[1] > 0.4, "{moved:?}");
    }
    // Boxes with common vertices at different times are not in conflict.
    let shared = "DBC 0 0 0  0 1 1  0 0 0  0 0 0  0 0.2 \\\n DBC 0 0 0  1 0 1  0 0 0  0 0 0  0.2 0.4";
    folder.import("shared.txt", &with(shared)).unwrap();
}

#[test]
fn forces_are_accelerations() {
    let folder = Folder::new("forces");
    let imported = folder
        .import("end.txt", &with("NBC 0 0 0  0 1 1  5 0 -5  0.1 0.3"))
        .unwrap();
    let lines = "[[body.load]]\nfrom = 0.1\nuntil = 0.3\n[body.load.vertices.box]\n\
                 lower = [0.0, 1.0, 0.0]\nupper = [0.0, 2.0, 1.5]\n[body.load.force]\nacceleration = [5.0, 0.0, -5.0]";
    assert!(has(&imported, lines), "{}", imported.toml);
    let global = format!("NBCTimeRange 0.2 9\n{}", with("NBC 0 0 0  0 1 1  5 0 -5"));
    let imported = folder.import("global.txt", &global).unwrap();
    assert!(has(&imported, "from = 0.2\nuntil = 9.0"), "{}", imported.toml);
}

/// A box is symmetric: its center of mass is the center of its bounding box.
#[test]
fn initial_velocities_are_linear_and_angular() {
    let folder = Folder::new("initial");
    let imported = folder
        .import("scene.txt", &with("initVel 1 2 3  0 90 0"))
        .unwrap();
    let simulation = after(&folder, "initVel 1 2 3  0 90 0", 0);
    let rate = core::f64::consts::FRAC_PI_2;
    let velocity = |[x, _, z]: Point| [1.0 + rate * (z - 0.75), 2.0, 3.0 - rate * (x - 0.25)];
    let expected: Vec<Point> = crate::solid().points.into_iter().map(velocity).collect();
    assert!(
        difference(&simulation.state().velocities, &expected) < 1e-9,
        "{}",
        imported.toml
    );
}

#[test]
fn scripts_twist_the_ends_and_let_shapes_fall() {
    let folder = Folder::new("scripts");
    let one = "shapes input 1\nbox.msh 0 1 0  0 0 0  1 1 1\n";
    let twist = folder
        .import("twist.txt", &format!("{one}script twist\n"))
        .unwrap();
    let rate = 0.4 * core::f64::consts::PI;
    for (x, rate) in [("0.0", -rate), ("0.5", rate)] {
        let lines = format!(
            "[body.script.vertices.box]\nlower = [{x}, 1.0, 0.0]\nupper = [{x}, 2.0, 1.5]\n\
             [body.script.motion.twisting]\ncenter = [0.25, 1.5, 0.75]\naxis = [1.0, 0.0, 0.0]\nrate = {rate}"
        );
        assert!(has(&twist, &lines), "{}", twist.toml);
    }
    let wide = folder
        .import("wide.txt", &format!("{one}script twist\nhandleRatio 0.6\n"))
        .unwrap();
    assert!(
        has(&wide, "lower = [0.0, 1.0, 0.0]\nupper = [0.25, 2.0, 1.5]"),
        "{}",
        wide.toml
    );
    let fall = folder.import("fall.txt", &format!("{one}script fall\n")).unwrap();
    let height = 1.0 + 0.5 * (0.25_f64 + 1.0 + 2.25).sqrt();
    assert!(
        has(&fall, &format!("translate = [0.0, {height}, 0.0]")),
        "{}",
        fall.toml
    );
    let still = folder
        .import("still.txt", &format!("{one}script fallNoShift\n"))
        .unwrap();
    assert!(has(&still, "translate = [0.0, 1.0, 0.0]"), "{}", still.toml);
}

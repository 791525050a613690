//! Errors of scene files: each names the file, the line and the field.

use crate::{SCENE, parse};

/// The error of the scene after a replacement in its text.
fn error_with(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "{from}");
    parse(&SCENE.replace(from, to)).err().unwrap()
}

#[test]
fn errors_name_file_line_and_field() {
    let cases = [
        (
            "duration = 0.1",
            "",
            "line 1, the file: the key `duration` is missing, expected a number of seconds",
        ),
        (
            "duration = 0.1",
            "duration = 0.009",
            "line 2, duration: the duration is 0.009 s, less than half of the time step of 0.02 s, expected at least \
             one time step: ",
        ),
        (
            "time-step = 0.02",
            "time-step = -1.0",
            "line 5, settings.time-step: `time-step` is -1, expected a positive number",
        ),
        (
            "max-iterations = 50",
            "max-iterations = \"many\"",
            "line 10, settings.max-iterations: invalid type: string \"many\", \
             expected an integer not below 0",
        ),
        (
            "coefficient = 0.2",
            "coefficient = -0.2",
            "line 14, settings.friction.coefficient: `friction.coefficient` is -0.2, \
             expected a number not below 0",
        ),
        (
            "young = 1e6, poisson = 0.4",
            "young = 1e6, poisson = 0.5",
            "line 20, body[0].solid.poisson: `poisson` is 0.5, expected a number in [0, 0.5)",
        ),
        (
            "density = 300.0",
            "density = 0.0",
            "line 28, body[1].shell.density: `density` is 0, expected a positive number",
        ),
        (
            "duration = 0.1",
            "duration = 0.1\n[[half-space]]\nname = \"a\\tb\"\npoint = [0.0, -9.0, 0.0]\nnormal = [0.0, 1.0, 0.0]",
            "line 4, half-space `a?b`, name: the name \"a\\tb\" has a control character, expected none",
        ),
        (
            "scale = 0.5",
            "scale = 8.0\nangular-velocity = [0.0, 0.0, 1e308]",
            "line 22, body[0].angular-velocity: ",
        ),
        (
            "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
            "shape = { line = { edges = 2, length = 1.0 } }",
            "line 39, body[2].shape: the mesh has no faces, expected some: edges alone need a `rod`",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "points = { counts = [2, 2, 2], size = [1.0, -1.0, 1.0] }",
            "line 39, body[2].shape: the shape has a length of -1 m, expected a finite number not below 0",
        ),
        (
            "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
            "mesh = \"missing.obj\"",
            "line 39, body[2].mesh: the file missing.obj does not exist",
        ),
        (
            "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
            "shape = { sphere = { subdivisions = 7, radius = 1.0 } }",
            "line 39, body[2].shape: the sphere has 7 subdivisions, expected at most 6",
        ),
        (
            "lower = [1.9,",
            "lower = [2.05,",
            "line 35, body[1].script[1].vertices: the box contains no vertex of the body, \
             expected a box that meets the placed body, which extends from [0.0, 0.0, 0.0] to [2.0, 0.0, 1.0]",
        ),
    ];
    assert_errors(&cases);
}

#[test]
fn numbers_out_of_range_are_reported_at_their_field() {
    let cases = [
        (
            "time-step = 0.02",
            "time-step = 0.0",
            "line 5, settings.time-step: `time-step` is 0, expected a positive number",
        ),
        (
            "time-step = 0.02",
            "time-step = nan",
            "line 5, settings.time-step: `time-step` is NaN, expected a positive number",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1e160 }",
            "line 8, settings.contact-distance: `contact-distance` is 1000",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1e-160 }",
            "line 8, settings.contact-distance: `contact-distance` is 0.000",
        ),
        (
            "max-iterations = 50",
            "max-iterations = 0",
            "line 10, settings.max-iterations: `max-iterations` is 0, expected at least 1",
        ),
        // For this mass, the stiffness of the barrier is infinite.
        (
            "density = 1000.0",
            "density = 1e308",
            "line 8, settings.contact-distance: `contact-distance` is 0.001, expected a length for which",
        ),
        (
            "density = 300.0",
            "density = 1e-320",
            "line 28, body[1].shell.density: element 0 has a mass of 0",
        ),
        (
            "axis = [1.0, 0.0, 0.0], degrees",
            "axis = [0.0, 0.0, 0.0], degrees",
            "line 22, body[0].rotate: the axis is [0.0, 0.0, 0.0], expected three finite numbers, \
             not all 0, of a length from about 1e-153 to 1e154, such as 1",
        ),
        (
            "velocity = [0.0, 1.0, 0.0]",
            "velocity = [0.0, nan, 0.0]",
            "line 24, body[0].velocity: `velocity` is [0.0, NaN, 0.0], expected finite numbers",
        ),
        (
            "velocity = [0.0, 1.0, 0.0]",
            "angular-velocity = [0.0, inf, 0.0]",
            "line 24, body[0].angular-velocity: `angular-velocity` is [0.0, inf, 0.0], expected finite numbers",
        ),
        (
            "translate = [0.0, -1.0, 0.0]",
            "translate = [0.0, -1.0, 0.0]\nvelocity = [1.0, 0.0, 0.0]",
            "line 41, body[2].velocity: `velocity` is [1.0, 0.0, 0.0], expected zero",
        ),
        (
            "axis = [1.0, 0.0, 0.0], rate",
            "axis = [0.0, 0.0, 0.0], rate",
            "line 32, body[1].script[0].motion.twisting.axis: ",
        ),
        (
            "rate = 2.0",
            "rate = inf",
            "line 32, body[1].script[0].motion.twisting.rate: ",
        ),
        (
            "rate = 2.0",
            "rate = 2.0, until = -1.0",
            "line 32, body[1].script[0].motion.twisting.until: ",
        ),
        (
            "motion = \"fixed\"",
            "motion = \"fixed\"\naxes = []",
            "line 37, body[1].script[1].axes: `axes` is empty, expected at least one axis",
        ),
        (
            "motion = \"fixed\"",
            "motion = \"fixed\"\nrelease = -1.0",
            "line 37, body[1].script[1].release: `release` is -1, expected a number not below 0",
        ),
        (
            "motion = \"fixed\"",
            "motion = \"fixed\"\nfrom = nan",
            "line 37, body[1].script[1].from: `from` is NaN, expected a number not below 0",
        ),
        (
            "motion = \"fixed\"",
            "motion = \"fixed\"\nrelease = 1.0\nfrom = 2.0",
            "line 37, body[1].script[1].release: `release` is 1, expected a number not below 0 and \
             not below `from`",
        ),
        (
            "rate = 2.0 } }",
            "rate = 2.0, until = 1.0 } }\nfrom = 2.0",
            "line 33, body[1].script[0].from: `from` is 2, expected a number not above the `until`",
        ),
        (
            "motion = \"fixed\"",
            "motion = { moving = { velocity = [nan, 0.0, 0.0] } }",
            "line 36, body[1].script[1].motion.moving.velocity: ",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "grid = { cells = [2000, 2000], size = [9.0, 9.0] }",
            "line 39, body[2].shape: the shape has 4000000 cells, expected 1 to 1048576",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "grid = { cells = [0, 4], size = [9.0, 9.0] }",
            "line 39, body[2].shape: the shape has 0 cells, expected 1 to 1048576",
        ),
        // A box without volume has no surface.
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "box = { cells = [1, 1, 1], size = [9.0, 0.0, 9.0] }",
            "line 39, body[2].shape: the shape has a length of 0 m, expected a finite positive number",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "sphere = { subdivisions = 1, radius = -2.0 }",
            "line 39, body[2].shape: the shape has a length of -2 m, expected a finite positive number",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1000.0 }",
            "line 8, settings.contact-distance: `contact-distance` is 1000, expected a length not above",
        ),
        (
            "lower = [1.9,",
            "lower = [2.9,",
            "line 35, body[1].script[1].vertices: the box from [2.9, -0.1, -0.1] to \
             [2.1, 0.1, 2.0] is empty",
        ),
        (
            "duration = 0.1",
            "duration = -1.0",
            "line 2, duration: the duration is -1 s, expected a number not below 0",
        ),
        (
            "lags = 2",
            "lags = 0",
            "line 16, settings.friction.lags: `friction.lags` is 0, expected at least 1",
        ),
        (
            "lags = 2",
            "lags = 2\n[[settings.friction.pair]]\nbetween = [\"a\", \"b\"]\ncoefficient = -1.0",
            "line 19, settings.friction.pair[0].coefficient: `coefficient` is -1, expected a number not below 0",
        ),
        (
            "lags = 2",
            "lags = 2\n[[settings.friction.pair]]\nbetween = [\"a\", \"b\"]\ncoefficient = 1.0",
            "line 18, settings.friction.pair[0].between: `between` is `a`, expected names of bodies and half spaces",
        ),
        (
            "scale = 0.5",
            "scale = [1.0, 0.0, 1.0]",
            "line 21, body[0].scale: the scale factors are [1.0, 0.0, 1.0], expected finite numbers",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = 1e-3",
            "line 8, settings.contact-distance: expected a length, `{ absolute = METERS }`",
        ),
        // The placement is invalid, not the mesh.
        (
            "translate = [0.0, 0.0, 3.0]",
            "translate = [0.0, nan, 3.0]",
            "line 23, body[0].translate: the translation is [0.0, NaN, 3.0], expected finite numbers",
        ),
        (
            "degrees = 90.0",
            "degrees = inf",
            "line 22, body[0].rotate: the angle is inf degrees, expected a finite number",
        ),
        ("scale = 0.5", "scale = 1e308", "line 18, body[0]: vertex "),
        // The box intersects the cloth, which is body 1.
        (
            "translate = [0.0, 0.0, 3.0]",
            "translate = [0.2, 0.1, 0.6]",
            "line 26, body[1]: ",
        ),
    ];
    assert_errors(&cases);
    let meeting = error_with("translate = [0.0, 0.0, 3.0]", "translate = [0.2, 0.1, 0.6]");
    assert!(
        meeting.contains("of body[0] and ")
            && meeting.contains("of body[1] intersect or touch at the start, near [")
            && meeting.ends_with("or repair its mesh by `exact-ccd repair MESH --with OTHER -o FREE.obj`"),
        "{meeting}"
    );
    let empty = parse("duration = 1.0").err().unwrap();
    assert_eq!(
        empty,
        "scene.toml, line 1, body: the scene has no body, expected at least one `[[body]]`"
    );
}

/// The error belongs to the file, even if its first line is the header of a body.
#[test]
fn a_missing_duration_is_an_error_of_the_file() {
    let error = parse("[[body]]\nshape = { sphere = { subdivisions = 1, radius = 1.0 } }");
    assert_eq!(
        error.err().unwrap(),
        "scene.toml, line 1, the file: the key `duration` is missing, expected a number of seconds"
    );
}

#[test]
fn single_brackets_are_reported_as_the_mistake() {
    let single = parse("duration = 1.0\n[body]\nshape = { sphere = { subdivisions = 1, radius = 1.0 } }");
    assert_eq!(
        single.err().unwrap(),
        "scene.toml, line 2, body: found the table `[body]`, expected an array of tables: write `[[body]]`"
    );
    for (table, name) in [
        ("[spring]\nbetween = [\"a\"]", "spring"),
        ("[half-space]\nnormal = [0.0, 1.0, 0.0]", "half-space"),
        (
            "[settings.friction.pair]\ncoefficient = 0.0",
            "settings.friction.pair",
        ),
    ] {
        assert_eq!(
            parse(&format!("duration = 1.0\n{table}")).err().unwrap(),
            format!(
                "scene.toml, line 2, {name}: found the table `[{name}]`, expected an array of tables: \
                 write `[[{name}]]`"
            )
        );
    }
    let script = parse("duration = 1.0\n[[body]]\nmesh = \"a.obj\"\n[body.script]\nmotion = \"fixed\"");
    assert_eq!(
        script.err().unwrap(),
        "scene.toml, line 4, body[0].script: found the table `[body.script]`, expected an array of tables: \
         write `[[body.script]]`"
    );
}

#[test]
fn numbers_of_other_types_are_reported_in_words() {
    let cases = [
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "grid = { cells = [1, 65536], size = [9.0, 9.0] }",
            "an integer from 0 to 65535",
        ),
        (
            "box = { cells = [1, 2, 1]",
            "box = { cells = [1, 2, -1]",
            "an integer from 0 to 255",
        ),
        ("density = 300.0", "density = \"300\"", "a number"),
        (
            "vertices = { box = { lower = [1.9, -0.1, -0.1], upper = [2.1, 0.1, 2.0] } }",
            "vertices = { vertices = [0, -1] }",
            "an integer from 0 to 4294967295",
        ),
        ("translate = [0.0, -1.0, 0.0]", "rotate = 30.0", "a table"),
    ];
    for (from, to, expected) in cases {
        let error = error_with(from, to);
        assert!(error.ends_with(&format!("expected {expected}")), "{error}");
    }
}

#[track_caller]
fn assert_errors(cases: &[(&str, &str, &str)]) {
    for (from, to, expected) in cases {
        let error = error_with(from, to);
        let expected = format!("scene.toml, {expected}");
        assert!(error.starts_with(&expected), "{error}\nexpected {expected}");
    }
}

#[test]
fn unknown_fields_and_methods_are_errors() {
    let error = error_with("velocity = [0.0, 1.0, 0.0]", "speed = [0.0, 1.0, 0.0]");
    assert!(
        error.starts_with("scene.toml, line 24, body[0].speed: unknown field `speed`"),
        "{error}"
    );
    let error = error_with("ccd = \"parity\"", "ccd = \"luck\"");
    assert!(
        error.starts_with("scene.toml, line 11, settings.ccd: there is no method `luck`"),
        "{error}"
    );
    let error = error_with("\"fixed\"", "\"dancing\"");
    assert!(
        error.starts_with("scene.toml, line 36, body[1].script[1].motion: unknown variant `dancing`"),
        "{error}"
    );
    let error = parse("duration = 1.0\nbody = 3 4").err().unwrap();
    assert!(error.starts_with("scene.toml, line 2, "), "{error}");
}

#[test]
fn settings_of_pictures_are_checked() {
    let scene = |table: &str| format!("{SCENE}\n[render]\n{table}\n");
    let rendering = parse(&scene("up = [0.0, 0.0, 2.0]")).unwrap().rendering;
    assert_eq!(
        (rendering.up, rendering.size),
        (Some([0.0, 0.0, 2.0]), [800, 600])
    );
    for (table, field) in [
        ("size = [8, 600]", "size"),
        ("size = [600, 5000]", "size"),
        ("up = [0.0, 0.0, 0.0]", "up"),
        ("camera = [inf, 0.0, 0.0]", "camera"),
        (
            "subject = { box = { lower = [1.0, 0.0, 0.0], upper = [0.0, 1.0, 1.0] } }",
            "subject",
        ),
        ("speed = 0.0", "speed"),
        ("speed = nan", "speed"),
        ("camera = 3.0", "camera"),
        ("sise = [1, 2]", "sise"),
    ] {
        let error = parse(&scene(table)).err().unwrap();
        assert!(error.contains(&format!("render.{field}: ")), "{error}");
    }
}

/// A body with a name is named in the path of a field and in messages about two bodies; others have their
/// number.
#[test]
fn errors_have_the_names_of_bodies() {
    let named = SCENE.replace("[[body]]\n", "[[body]]\nname = \"part\"\n");
    let error = |from: &str, to: &str| {
        assert!(named.contains(from), "{from}");
        parse(&named.replacen(from, to, 1)).err().unwrap()
    };
    for (from, to, expected) in [
        (
            "density = 300.0",
            "density = 0.0",
            "body `part`, shell.density: `density` is 0",
        ),
        (
            "young = 1e6",
            "young = \"stiff\"",
            "body `part`, solid.young: invalid type",
        ),
        ("velocity = [", "speed = [", "body `part`, speed: unknown field"),
        (
            "motion = \"fixed\"",
            "motion = \"fixed\"\naxes = []",
            "body `part`, script[1].axes: ",
        ),
        (
            "translate = [0.0, 0.0, 3.0]",
            "translate = [0.0, nan, 3.0]",
            "body `part`, translate: the translation is",
        ),
    ] {
        let error = error(from, to);
        assert!(error.contains(expected), "{error}\nexpected {expected}");
    }
    let meeting = error("translate = [0.0, 0.0, 3.0]", "translate = [0.2, 0.1, 0.6]");
    assert!(
        meeting.contains(" of body `part` and ") && meeting.contains(" of body `part` intersect or touch"),
        "{meeting}"
    );
    let ground = "\n[[half-space]]\nname = \"ground\"\nnormal = [0.0, 1.0, 0.0]\npoint = [0.0, 9.0, 0.0]\n";
    let grounded = parse(&format!("{named}{ground}")).err().unwrap();
    assert!(
        grounded.contains("body `part`: vertex ")
            && grounded.contains(" of body `part` touches half-space `ground` "),
        "{grounded}"
    );
    let vertical = ground.replace("[0.0, 1.0, 0.0]", "[0.0, 0.0, 0.0]");
    let vertical = parse(&format!("{named}{vertical}")).err().unwrap();
    assert!(
        vertical.contains("half-space `ground`, normal: the normal is [0.0, 0.0, 0.0], expected"),
        "{vertical}"
    );
    // An empty name is none.
    let unnamed = named
        .replace("name = \"part\"", "name = \"\"")
        .replace("density = 300.0", "density = 0.0");
    let unnamed = parse(&unnamed).err().unwrap();
    assert!(unnamed.contains("body[1].shell.density: "), "{unnamed}");
}

#[test]
fn a_folder_in_place_of_a_mesh_is_named() {
    let folder = env!("CARGO_MANIFEST_DIR");
    let error = error_with(
        "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
        &format!("mesh = {folder:?}"),
    );
    assert!(
        error.ends_with(&format!("{folder} is a folder, expected a mesh file")),
        "{error}"
    );
}

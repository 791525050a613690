//! Properties of an imported scene.

use exact_ccd_import::Imported;
use exact_ccd_mesh::Point;
use exact_ccd_scene::Scene;

/// True if the TOML file has these lines, one after the other.
pub(crate) fn has(imported: &Imported, lines: &str) -> bool {
    let lines: Vec<&str> = lines
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect();
    let all: Vec<&str> = imported.toml.lines().filter(|line| !line.is_empty()).collect();
    all.windows(lines.len()).any(|window| window == lines)
}

/// Checks that each text becomes these lines, without a note. The name of each file is a number with this
/// extension.
pub(crate) fn assert_lines<'a>(
    folder: &crate::Folder,
    extension: &str,
    cases: impl IntoIterator<Item = (String, &'a str)>,
) {
    for (index, (text, lines)) in cases.into_iter().enumerate() {
        let imported = folder.import(&format!("{index}.{extension}"), &text).unwrap();
        assert!(has(&imported, lines), "{lines} of {text}: {}", imported.toml);
        assert!(imported.notes.is_empty(), "{text}: {:?}", imported.notes);
    }
}

/// Checks the position of each vertex of `box.msh` in a scene of this body.
pub(crate) fn assert_placed(scene: &Scene, expected: impl Fn(Point) -> Point) {
    for (rest, placed) in crate::solid()
        .points
        .into_iter()
        .zip(scene.simulation.system().start())
    {
        let expected = expected(rest);
        assert!(
            (0..3).all(|axis| (placed[axis] - expected[axis]).abs() < 1e-12),
            "{placed:?} {expected:?}"
        );
    }
}

//! Groups of mesh files in scenes.

use std::fs;
use std::path::PathBuf;

use exact_ccd_mesh::TetMesh;
use exact_ccd_scene::Scene;
use exact_ccd_sim::{BodyKind, shapes};

use crate::filter;

/// A folder of this name with two files. `column.msh` is a column of 1 m × 1 m² along y: its upper half is
/// the group `upper` with the tag 7, and its ends are groups of triangles. `grid.obj` has two triangles in
/// two groups.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    let column = shapes::solid_box([2, 4, 2], [1.0; 3]);
    let BodyKind::Solid { tetrahedra, .. } = column.kind else {
        panic!("expected a solid");
    };
    let mesh = TetMesh::new(column.points.clone(), tetrahedra.clone()).unwrap();
    let height = |vertex: &u32| column.points[*vertex as usize][1];
    let line = |tag: u32, kind: u32, corners: &[u32]| {
        let nodes: String = corners.iter().map(|corner| format!(" {}", corner + 1)).collect();
        format!(" {kind} 2 {tag} 1{nodes}\n")
    };
    let ends = mesh.surface().iter().filter_map(|face| {
        let is_at = |end: f64| face.iter().all(|corner| height(corner) == end);
        let tag = if is_at(0.0) {
            Some(1)
        } else {
            is_at(1.0).then_some(2)
        };
        Some(line(tag?, 2, face))
    });
    let cells = tetrahedra.iter().map(|corners| {
        let is_upper = corners.iter().map(height).sum::<f64>() > 2.0;
        line(if is_upper { 7 } else { 6 }, 4, corners)
    });
    let elements: Vec<String> = ends.chain(cells).collect();
    let numbered = |lines: &[String]| -> String {
        let numbers = (1..).zip(lines);
        numbers
            .map(|(number, line): (u32, &String)| format!("{number}{line}"))
            .collect()
    };
    let points = column.points.iter();
    let nodes: Vec<String> = points.map(|[x, y, z]| format!(" {x} {y} {z}\n")).collect();
    let file = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"bottom\"\n2 2 \"top\"\n\
         3 7 \"upper\"\n$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
        nodes.len(),
        numbered(&nodes),
        elements.len(),
        numbered(&elements),
    );
    fs::write(folder.join("column.msh"), file).unwrap();
    let grid = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\ng left\nf 1 2 3\ng right\nf 3 2 4\n";
    fs::write(folder.join("grid.obj"), grid).unwrap();
    folder
}

const SCENE: &str = r#"
duration = 4.0

[settings]
time-step = 1.0
gravity = [0.0, 0.0, 0.0]
integrator = "quasi-static"
tolerance = { absolute = 1e-10 }

[[body]]
mesh = "column.msh"
solid = { density = 1000.0, young = 1e6, poisson = 0.0 }

[[body.region]]
group = "upper"
solid = { density = 3000.0, young = 4e6, poisson = 0.0 }

[[body.script]]
vertices = { group = "bottom" }
motion = "fixed"
axes = ["x", "y", "z"]

[[body.load]]
vertices = { group = 2 }
force = { traction = [0.0, 100.0, 0.0] }
"#;

fn parse(text: &str, name: &str) -> Result<Scene, String> {
    let file = folder(name).join("scene.toml");
    Scene::parse(text, &file, None, &filter).map_err(|error| error.to_string())
}

/// The end of a column of two materials under traction moves by t (l₁ / E₁ + l₂ / E₂).
#[test]
fn a_column_of_two_materials_stretches_as_two_springs() {
    let scene = parse(SCENE, "groups-column").unwrap();
    let mass: f64 = scene.simulation.system().masses().iter().sum();
    assert!((mass - 2000.0).abs() < 1e-9, "{mass}");
    let mut simulation = scene.simulation;
    for _ in 0..scene.steps {
        assert!(simulation.step().unwrap().converged);
    }
    let expected = 100.0 * (0.5 / 1e6 + 0.5 / 4e6);
    let pairs = simulation
        .system()
        .start()
        .iter()
        .zip(&simulation.state().positions);
    let mut ends = 0;
    for (start, now) in pairs.filter(|(start, _)| start[1] == 1.0) {
        let stretch = now[1] - start[1];
        assert!(
            (stretch / expected - 1.0).abs() < 1e-3,
            "{stretch}, expected {expected}"
        );
        ends += 1;
    }
    assert_eq!(ends, 9);
}

/// Of several regions of a tetrahedron, the last one counts.
#[test]
fn later_regions_replace_earlier_ones() {
    let light = "\n[[body.region]]\ngroup = 7\nsolid = { density = 100.0, young = 1e6, poisson = 0.0 }\n";
    let scene = parse(
        &SCENE.replacen("\n[[body.script]]", &format!("{light}\n[[body.script]]"), 1),
        "groups-last",
    );
    let mass: f64 = scene.unwrap().simulation.system().masses().iter().sum();
    assert!((mass - 550.0).abs() < 1e-9, "{mass}");
}

#[test]
fn groups_of_obj_select_vertices() {
    let scene = |group: &str| {
        let text = format!(
            "duration = 0.1\n[[body]]\nmesh = \"grid.obj\"\n\
             shell = {{ density = 300.0, young = 1e5, poisson = 0.3, thickness = 1e-3 }}\n\
             [[body.script]]\nvertices = {{ group = {group} }}\nmotion = \"fixed\"\n"
        );
        parse(&text, "groups-obj")
    };
    let left = scene("\"left\"").unwrap();
    let system = left.simulation.system();
    let free: Vec<usize> = (0..4).filter(|&vertex| system.is_free(vertex)).collect();
    assert_eq!(free, [3]);
    for unknown in ["\"middle\"", "1"] {
        let error = scene(unknown).err().unwrap();
        let expected =
            "body[0].script[0].vertices: the mesh has no such group, expected one of `left`, `right`";
        assert!(error.ends_with(expected), "{error}");
    }
}

#[test]
fn unknown_groups_are_errors_that_list_the_known_ones() {
    let known = "the mesh has no such group, expected one of 1 `bottom`, 2 `top`, 6, 7 `upper`";
    for (from, to, field) in [
        ("\"bottom\"", "\"base\"", "line 19, body[0].script[0].vertices: "),
        ("group = 2", "group = 5", "line 24, body[0].load[0].vertices: "),
        ("\"upper\"", "9", "line 15, body[0].region[0].group: "),
        ("\"upper\"", "\"Upper\"", "line 15, body[0].region[0].group: "),
    ] {
        let error = parse(&SCENE.replace(from, to), "groups-unknown").err().unwrap();
        assert!(error.ends_with(&format!("{field}{known}")), "{error}");
    }
}

#[test]
fn errors_of_regions_name_their_field() {
    let shape = "shape = { box = { cells = [1, 1, 1], size = [1.0, 1.0, 1.0] } }";
    for (from, to, expected) in [
        (
            "\"upper\"",
            "\"top\"",
            "line 15, body[0].region[0].group: the group has no tetrahedra, expected a physical group of a volume",
        ),
        (
            "mesh = \"column.msh\"",
            shape,
            "line 15, body[0].region[0].group: the mesh has no groups, expected a Gmsh file with physical groups",
        ),
        (
            "solid = { density = 1000.0, young = 1e6, poisson = 0.0 }",
            "",
            "line 15, body[0].region[0].group: only a solid has regions, expected `solid`",
        ),
        (
            "density = 3000.0",
            "density = -3.0",
            "line 16, body[0].region[0].solid.density: `density` is -3, expected a positive number",
        ),
        (
            "young = 4e6, poisson = 0.0",
            "young = 4e6, poisson = 0.5",
            "line 16, body[0].region[0].solid.poisson: `poisson` is 0.5",
        ),
        (
            "group = \"upper\"",
            "group = -7",
            "line 15, body[0].region[0].group: expected the name of a group, or the tag of a physical group",
        ),
        (
            "group = \"upper\"\n",
            "",
            "line 14, body[0].region[0]: missing field `group`",
        ),
        (
            "[[body.region]]",
            "[body.region]",
            "line 14, body[0].region: found the table `[body.region]`, expected an array of tables",
        ),
    ] {
        assert!(SCENE.contains(from), "{from}");
        let error = parse(&SCENE.replacen(from, to, 1), "groups-errors")
            .err()
            .unwrap();
        assert!(error.contains(expected), "{error}\n{expected}");
    }
}

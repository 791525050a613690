//! PolyFEM's JSON: materials of the physical groups of a mesh.

use serde_json::{Value, json};

use crate::imported::has;
use crate::polyfem::scene;
use crate::{Folder, msh_with_tags, solid};

/// A folder with `tagged.msh`: the box. Its tetrahedra below and above have these tags.
fn folder(name: &str, [lower, upper]: [i32; 2]) -> Folder {
    let folder = Folder::new(name);
    let body = solid();
    let height = |corners: &[u32; 4]| {
        corners
            .map(|corner| body.points[corner as usize][1])
            .iter()
            .sum::<f64>()
    };
    let text = msh_with_tags(&body, |corners| if height(corners) < 2.0 { lower } else { upper });
    folder.write("tagged.msh", &text);
    folder
}

/// A scene with the mesh and these materials.
fn of(selection: &Value, materials: &Value) -> String {
    scene(&json!({
        "geometry": { "mesh": "tagged.msh", "volume_selection": selection },
        "materials": materials,
    }))
}

fn material(id: &Value, young: f64, density: f64) -> Value {
    json!({ "type": "NeoHookean", "id": id, "E": young, "nu": 0.4, "rho": density })
}

const FIRST: &str =
    "[body.solid]\ndensity = 1000.0\nyoung = 100000.0\npoisson = 0.4\nenergy = \"neo-hookean\"";

#[test]
fn physical_tags_are_ids_of_materials() {
    let folder = folder("polyfem-regions", [3, 7]);
    let region = "[[body.region]]\ngroup = 7\n[body.region.solid]\ndensity = 3000.0\nyoung = 400000.0";
    let two = json!([
        material(&json!(7), 4e5, 3000.0),
        material(&json!([1, 3]), 1e5, 1000.0)
    ]);
    let imported = folder.import("scene.json", &of(&json!(null), &two)).unwrap();
    assert!(
        has(&imported, FIRST) && has(&imported, region),
        "{}",
        imported.toml
    );
    // The boxes below and above have the same volume, of 0.375 m³.
    let scene = folder.scene("scene.json", &of(&json!(null), &two)).unwrap();
    let mass: f64 = scene.simulation.system().masses().iter().sum();
    assert!((mass - 0.375 * 4000.0).abs() < 1e-9, "{mass}");

    // Of two materials with an id, the last one counts.
    let three = json!([material(&json!(7), 9e9, 9e9), two[0], two[1]]);
    let same = folder.import("scene.json", &of(&json!(null), &three)).unwrap();
    assert_eq!(same.toml, imported.toml);

    let offset = json!([
        material(&json!(17), 4e5, 3000.0),
        material(&json!([1, 13]), 1e5, 1000.0)
    ]);
    let same = folder
        .import("scene.json", &of(&json!({ "id_offset": 10 }), &offset))
        .unwrap();
    assert_eq!(same.toml, imported.toml);

    // One number counts more than the tags, and a material that is not in a list applies to all ids.
    for (selection, materials) in [
        (json!(1), two.clone()),
        (json!({ "id": 1 }), two.clone()),
        (json!(null), json!([material(&json!([3, 7]), 1e5, 1000.0)])),
        (json!(null), material(&json!(9), 1e5, 1000.0)),
    ] {
        let imported = folder.import("scene.json", &of(&selection, &materials)).unwrap();
        assert!(
            has(&imported, FIRST) && !imported.toml.contains("region"),
            "{}",
            imported.toml
        );
    }
}

#[test]
fn tetrahedra_without_a_tag_have_the_id_0() {
    let folder = folder("polyfem-untagged", [0, 7]);
    let two = json!([
        material(&json!(7), 4e5, 3000.0),
        material(&json!(null), 1e5, 1000.0)
    ]);
    let imported = folder.import("scene.json", &of(&json!(null), &two)).unwrap();
    assert!(has(&imported, FIRST), "{}", imported.toml);
    assert!(has(&imported, "[[body.region]]\ngroup = 7"), "{}", imported.toml);
    let one = json!([material(&json!(7), 4e5, 3000.0)]);
    let error = folder.import("scene.json", &of(&json!(null), &one)).unwrap_err();
    assert_eq!(
        error,
        "scene.json, /geometry: found tetrahedra with the id 0, which no material has, expected one of the \
         ids of materials (7): set it by `volume_selection`, or by physical groups of the mesh"
    );
}

#[test]
fn velocities_are_those_of_all_ids() {
    let folder = folder("polyfem-region-velocities", [3, 7]);
    let with = |velocities: Value| {
        scene(&json!({
            "geometry": { "mesh": "tagged.msh", "volume_selection": null },
            "materials": [material(&json!([3, 7]), 1e5, 1000.0)],
            "initial_conditions": { "velocity": velocities },
        }))
    };
    let velocity = json!([1, 2, 3]);
    let both = json!([{ "id": 7, "value": velocity }, { "id": 3, "value": velocity }]);
    let imported = folder.import("scene.json", &with(both)).unwrap();
    assert!(has(&imported, "velocity = [1.0, 2.0, 3.0]"), "{}", imported.toml);
    let one = json!([{ "id": 7, "value": velocity }]);
    let error = folder.import("scene.json", &with(one)).unwrap_err();
    assert!(
        error.starts_with(
            "scene.json, /geometry: exact-ccd has no counterpart of a body of several initial velocities"
        ),
        "{error}"
    );
}

/// Gmsh 4.1: an entity of the geometry may be in several groups.
#[test]
fn a_tetrahedron_of_several_groups_is_an_error() {
    let folder = Folder::new("polyfem-two-groups");
    let file = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 2 3 7 0\n$EndEntities\n\
                $Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n\
                $Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
    folder.write("tagged.msh", file);
    let materials = json!([material(&json!([3, 7]), 1e5, 1000.0)]);
    let error = folder
        .import("scene.json", &of(&json!(null), &materials))
        .unwrap_err();
    assert!(
        error.starts_with("scene.json, /geometry: exact-ccd has no counterpart of a tetrahedron of several"),
        "{error}"
    );
    folder.import("scene.json", &of(&json!(3), &materials)).unwrap();
}

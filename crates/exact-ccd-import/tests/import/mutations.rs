//! Mutated scenes of other programs: the result is an error, or a scene that is a valid TOML file. Nothing
//! panics.

use exact_ccd_scene::Scene;
use fastrand::Rng;
use serde_json::{Value, json};

use crate::{Folder, exact, msh_with_tags, solid};

const TEXT: &str = "energy NH\ntimeIntegration BE\ntime 0.1 0.01\ndensity 1000\nstiffness 1e5 0.4\n\
    shapes input 2\nbox.msh 0 1 0  0 0 45  1 1 1 material 10 1e4 0.1 \\\n\
    DBC 0 0 0  0.1 1 1  0 0 1  0 0 9  0 0.05 \\\n DBC 0 0 0  0.1 1 1  0 0 1  0 0 9  0.05\n\
    box.msh 3 1 0  0 0 0  1 1 1 NBC 0 0 0  0.1 1 1  0 0 1 initVel 1 0 0  0 0 90\n\
    shapeMatrix input 1 1 2\nfloor.obj 1 -1 9  0 0 0  1 1 1\nmeshCO floor.obj 0 -9 0  8 50 0 rotate 0 0 0\n\
    size 2\nground 0 -20\nhalfSpace 0 -30 0  0 1 0  50 0\nselfFric 0\ntuning 3\n0\n1e-3\n1e-3\ntol 1\n1e-2\n\
    script null\nsection SQP\nwarmStart 1\nsection end\nview perspective\nDBCTimeRange 0 1\n";

/// Replaces, removes, or repeats parts of a text, cut at separators.
fn mutated(text: &str, separators: &[char], words: &[&str], random: &mut Rng) -> String {
    let mut parts: Vec<&str> = text.split_inclusive(separators).collect();
    for _ in 0..random.usize(1..4) {
        if parts.is_empty() {
            break;
        }
        let place = random.usize(..parts.len());
        match random.u8(..4) {
            0 => parts[place] = words[random.usize(..words.len())],
            1 => drop(parts.remove(place)),
            2 => parts.insert(place, words[random.usize(..words.len())]),
            _ => {
                let other = random.usize(..parts.len());
                parts.swap(place, other);
            }
        }
    }
    parts.concat()
}

/// The numbers of scenes that are imported, and of scenes that are not.
fn outcomes(folder: &Folder, name: &str, scenes: impl Iterator<Item = String>) -> [usize; 2] {
    let mut outcomes = [0; 2];
    for text in scenes {
        match folder.import(name, &text) {
            Ok(imported) => {
                outcomes[0] += 1;
                // The scene may be out of range, which is an error of a field.
                let _ = Scene::parse(&imported.toml, &folder.path.join("scene.toml"), None, &exact)
                    .map_err(|error| assert!(error.to_string().contains(", line "), "{error}"));
            }
            Err(error) => {
                outcomes[1] += 1;
                assert!(error.starts_with(name), "{error}");
            }
        }
    }
    outcomes
}

#[test]
fn mutated_text_scenes_do_not_panic() {
    let folder = Folder::new("mutated");
    let mut random = Rng::with_seed(1);
    let words = [
        "0 ",
        "-1 ",
        "1e300 ",
        "-1e-300 ",
        "nan ",
        "inf ",
        "99999999999 ",
        "\n",
        "\\ ",
        "# ",
        "box.msh ",
        "floor.obj ",
        "none ",
        "shapes ",
        "input ",
        "DBC ",
        "linearVelocity ",
        "angularVelocity ",
        "script twist\n",
        "script fall\n",
        "size 1e-320\n",
        "\nsize 0\n",
        "\u{0} ",
        "é ",
        "tuning 4\n",
        "section x\n",
    ];
    let scenes = (0..2000).map(|_| mutated(TEXT, &[' ', '\n'], &words, &mut random));
    let [imported, refused] = outcomes(&folder, "scene.txt", scenes);
    assert!(
        imported > 100 && refused > 100,
        "{imported} imported, {refused} refused"
    );
}

#[test]
fn mutated_json_scenes_do_not_panic() {
    let folder = Folder::new("mutated-json");
    let below = |corners: &[u32; 4]| corners.iter().sum::<u32>() < 60;
    let tagged = msh_with_tags(&solid(), |corners| if below(corners) { 1 } else { 2 });
    folder.write("tagged.msh", &tagged);
    let scene = json!({
        "geometry": [
            { "mesh": "box.msh", "volume_selection": 1, "surface_selection": [{ "id": 5, "axis": "-x", "position": 0.01 }] },
            { "type": "mesh_array", "mesh": "box.msh", "volume_selection": 1, "surface_selection": 6, "array": { "offset": 3, "size": [1, 2, 1] },
              "transformation": { "translation": [5, 0, 0], "rotation": [1, 2, 3], "scale": [1, 1, 2] } },
            { "mesh": "floor.obj", "is_obstacle": true, "surface_selection": 7, "transformation": { "translation": [0, -9, 0] } },
            { "type": "plane", "is_obstacle": true, "point": [0, -20, 0], "normal": [0, 1, 0] },
            { "mesh": "tagged.msh", "volume_selection": { "id_offset": 0 }, "transformation": { "translation": [0, 9, 0] } },
        ],
        "materials": [
            { "type": "NeoHookean", "id": [0, 2], "E": 2e5, "nu": 0.3, "rho": 500 },
            { "type": "NeoHookean", "id": 1, "E": 1e5, "nu": 0.4, "rho": 1000 },
        ],
        "contact": { "enabled": true, "friction_coefficient": 0.1 },
        "time": { "tend": 0.1, "dt": 0.01 },
        "boundary_conditions": {
            "rhs": [0, 9.81, 0],
            "dirichlet_boundary": [{ "id": 5, "value": [0, "max(-t, -0.05)", 0], "dimension": [true, true, false] }],
            "obstacle_displacements": [{ "id": 7, "value": [0, "t*(1-t)", 0] }],
            "pressure_boundary": [{ "id": 6, "value": 3 }],
        },
    });
    let values = [
        json!(0),
        json!(-1),
        json!(3),
        json!(1e300),
        json!(1e-300),
        json!(99_999_999_999_i64),
        json!(null),
        json!(true),
        json!(false),
        json!([]),
        json!({}),
        json!([0, 1, 2]),
        json!([0, 1]),
        json!("x"),
        json!("t"),
        json!("t/0"),
        json!("((((t"),
        json!("scene.json"),
        json!({ "id": 5 }),
        json!({ "common": "scene.json" }),
    ];
    let imported = folder.import("scene.json", &scene.to_string()).unwrap();
    assert!(imported.toml.contains("[[body.region]]"), "{}", imported.toml);
    let mut random = Rng::with_seed(2);
    let scenes = (0..800).map(|_| {
        let mut scene = scene.clone();
        for _ in 0..random.usize(1..3) {
            replace(&mut scene, &values, &mut random);
        }
        scene.to_string()
    });
    let [imported, refused] = outcomes(&folder, "scene.json", scenes);
    assert!(
        imported > 20 && refused > 100,
        "{imported} imported, {refused} refused"
    );
}

/// Replaces a value, or one inside of it.
fn replace(value: &mut Value, values: &[Value], random: &mut Rng) {
    let count = match value {
        Value::Object(entries) => entries.len(),
        Value::Array(elements) => elements.len(),
        _ => 0,
    };
    if count == 0 || random.u8(..6) == 0 {
        *value = values[random.usize(..values.len())].clone();
        return;
    }
    let index = random.usize(..count);
    let inner = match value {
        Value::Object(entries) => entries.values_mut().nth(index),
        Value::Array(elements) => elements.get_mut(index),
        _ => None,
    };
    if let Some(inner) = inner {
        replace(inner, values, random);
    }
}

#[test]
fn mutated_json_texts_do_not_panic() {
    let folder = Folder::new("mutated-json-text");
    let text = crate::polyfem::scene(&json!({}));
    let mut random = Rng::with_seed(3);
    let words = [
        "0,", "null,", "[],", "{},", "\"x\",", "true,", "\"id\":", "}", "]", "\"é\",", "\u{0}",
    ];
    let scenes = (0..500).map(|_| mutated(&text, &[',', ':', '[', '{'], &words, &mut random));
    let [_, refused] = outcomes(&folder, "scene.json", scenes);
    assert!(refused > 100, "{refused} refused");
}

//! Scenes of IPC and PolyFEM: no bytes make the import panic, and its result is a TOML file of a scene.

#![no_main]

use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

use arbitrary::{Result, Unstructured};
use exact_ccd_fuzz::file;
use exact_ccd_import::import;
use exact_ccd_scene::{Scene, SceneError};
use exact_ccd_sim::{Settings, StepFilter, System};
use libfuzzer_sys::fuzz_target;

const TEXT: &[&str] = &[
    "\n",
    " ",
    "# ",
    " \\\n",
    "shapes input 1\na.msh 0 0 0  0 0 0  1 1 1 ",
    "shapes input 2\na.obj 9 0 0  0 0 9  1 1 1\na.msh 0 0 0  0 0 0  1 1 1 ",
    "shapeMatrix input 1 2 1\na.msh 2 2 2  0 0 0  1 1 1\n",
    "shape input a.msh\n",
    "meshCO a.obj 9 9 9  1 50 0 rotate 1 2 3\n",
    " material 1 2 0.3 ",
    " DBC 0 0 0  1 1 1  0 0 1  0 0 9 ",
    " DBC 0 0 0  0.5 1 1  0 0 0  0 0 0  0 1 ",
    " NBC 0 0 0  1 1 1  0 0 1 ",
    " initVel 1 2 3 4 5 6 ",
    " linearVelocity 1 2 3 ",
    " angularVelocity 1 2 3 ",
    "\nscript twist\n",
    "\nscript fall\n",
    "\nsize 1\n",
    "\nground 0 -1\n",
    "\ntuning 2\n0\n",
    "\ntol 1\n",
    "\nsection SQP\n",
    "\ntime 1 0.1\n",
    "\nhandleRatio ",
    "\nDBCTimeRange 0 ",
];

const JSON: &[&str] = &[
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "{\"contact\":{\"enabled\":true},\"time\":{\"tend\":1,\"dt\":0.5},\"materials\":{\"type\":\"NeoHookean\",\"E\":1,\"nu\":0},",
    "\"geometry\":[{\"mesh\":\"a.msh\",\"volume_selection\":1,\"surface_selection\":[",
    "\"geometry\":{\"mesh\":\"a.msh\",\"surface_selection\":5}",
    "{\"mesh\":\"a.obj\",\"is_obstacle\":true,\"surface_selection\":5}",
    "\"transformation\":{\"rotation\":[1,2,3],\"scale\":2}",
    "{\"id\":5,\"box\":[[0,0,0],[1,1,1]],\"relative\":true}",
    "{\"id\":5,\"axis\":\"-x\",\"position\":0.5}",
    "{\"threshold\":1}",
    "\"boundary_conditions\":{\"rhs\":[0,1,0],\"dirichlet_boundary\":[",
    "{\"id\":5,\"value\":[0,\"",
    "t*",
    "sin(t)",
    "min(t,",
    "-(",
    ")",
    "pi",
    "\",0]}",
    "\"common\":\"scene.json\"",
];

/// A folder with a tetrahedron and a triangle.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("exact-ccd-scenes-{}", std::process::id()));
    let mesh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
                $Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n";
    fs::create_dir_all(&folder).expect("a temporary folder");
    fs::write(folder.join("a.msh"), mesh).expect("a mesh");
    fs::write(folder.join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n").expect("a mesh");
    folder
});

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes do not make a file.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let (name, words) = if bytes.arbitrary()? {
        ("scene.txt", TEXT)
    } else {
        ("scene.json", JSON)
    };
    let path = FOLDER.join(name);
    fs::write(&path, file(bytes, words)?).expect("a scene");
    let exact = |_: &mut Settings, _: &System| Ok(StepFilter::default());
    if let Ok(Some(imported)) = import(&path, None) {
        let scene = Scene::parse(&imported.toml, &path, Some(&imported.meshes), &exact);
        if let Err(SceneError::Field { message, .. }) = scene {
            let is_toml = !message.contains("unknown field") && !message.contains("invalid type");
            assert!(is_toml, "{message}\n{}", imported.toml);
        }
    }
    Ok(())
}

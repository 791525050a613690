//! Scenes of other programs. All scenes and meshes here are written by the tests.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod imported;
mod ipc;
mod ipc_errors;
mod ipc_motions;
mod mutations;
mod polyfem;
mod polyfem_errors;
mod polyfem_regions;
mod run;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd_import::{Imported, Note, import, read};
use exact_ccd_scene::Scene;
use exact_ccd_sim::{Body, BodyKind, Settings, StepFilter, System, shapes};

/// A folder with `box.msh`, a box of 0.5 m × 1 m × 1.5 m and 2 × 2 × 2 cells with a corner at the origin, and
/// `floor.obj`, a square of 4 m about the origin in the plane y = 0.
struct Folder {
    path: PathBuf,
}

impl Folder {
    /// A folder of this name, which no other test has.
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("import").join(name);
        fs::create_dir_all(&path).unwrap();
        fs::write(path.join("box.msh"), msh(&solid())).unwrap();
        let floor = "v -2 0 -2\nv -2 0 2\nv 2 0 2\nv 2 0 -2\nf 1 2 3\nf 1 3 4\n";
        fs::write(path.join("floor.obj"), floor).unwrap();
        Self { path }
    }

    /// Writes a scene file.
    fn write(&self, name: &str, text: &str) -> PathBuf {
        let file = self.path.join(name);
        fs::write(&file, text).unwrap();
        file
    }

    /// The import of a scene, or its error without the folder.
    fn import(&self, name: &str, text: &str) -> Result<Imported, String> {
        let file = self.write(name, text);
        let imported = import(&file, None).map_err(|error| error.to_string());
        let folder = format!("{}/", self.path.display());
        imported
            .map(Option::unwrap)
            .map_err(|error| error.replace(&folder, ""))
    }

    /// The scene, or its error without the folder.
    fn scene(&self, name: &str, text: &str) -> Result<Scene, String> {
        self.scene_with_notes(name, text).map(|(scene, _)| scene)
    }

    /// The scene with its notes, or its error without the folder.
    fn scene_with_notes(&self, name: &str, text: &str) -> Result<(Scene, Vec<Note>), String> {
        let file = self.write(name, text);
        let folder = format!("{}/", self.path.display());
        read(file, None, &exact).map_err(|error| error.to_string().replace(&folder, ""))
    }
}

fn exact(_: &mut Settings, _: &System) -> Result<StepFilter, String> {
    Ok(StepFilter::default())
}

/// The body of `box.msh`.
fn solid() -> Body {
    shapes::solid_box([2, 2, 2], [0.5, 1.0, 1.5])
}

/// A solid as a Gmsh file of version 2.2, without physical groups.
fn msh(body: &Body) -> String {
    msh_with_tags(body, |_| 0)
}

/// A solid as a Gmsh file of version 2.2, with the physical tag of each tetrahedron.
fn msh_with_tags(body: &Body, tag: impl Fn(&[u32; 4]) -> i32) -> String {
    let BodyKind::Solid { tetrahedra, .. } = &body.kind else {
        panic!("expected a solid");
    };
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        body.points.len()
    );
    for (index, [x, y, z]) in body.points.iter().enumerate() {
        writeln!(text, "{} {x} {y} {z}", index + 1).unwrap();
    }
    writeln!(text, "$EndNodes\n$Elements\n{}", tetrahedra.len()).unwrap();
    for (index, corners) in tetrahedra.iter().enumerate() {
        let [a, b, c, d] = corners.map(|corner| corner + 1);
        let tag = tag(corners);
        writeln!(text, "{} 4 2 {tag} 1 {a} {b} {c} {d}", index + 1).unwrap();
    }
    text + "$EndElements\n"
}

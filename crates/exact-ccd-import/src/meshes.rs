//! The mesh files of an imported scene.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use exact_ccd_scene::Mesh;

use super::fault::Problem;

/// The number of folders above the scene's folder in which mesh files are looked for.
const ABOVE: usize = 8;

/// The mesh files that a scene refers to. Each is read once.
pub(super) struct Meshes {
    folder: PathBuf,
    /// True if the folder is given: it may then contain the files without their folders.
    is_given: bool,
    read: HashMap<PathBuf, Rc<Mesh>>,
}

impl Meshes {
    /// Mesh files in `folder`, or in the scene's folder and the folders above.
    pub(super) fn new(scene: &Path, folder: Option<&Path>) -> Self {
        let own = || scene.parent().unwrap_or(Path::new(""));
        Self {
            folder: folder.unwrap_or_else(own).to_owned(),
            is_given: folder.is_some(),
            read: HashMap::new(),
        }
    }

    /// The folder to which the paths of [`Meshes::find`] are relative.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The path of a mesh file, relative to the folder, and its mesh.
    pub(super) fn find(&mut self, path: &str) -> Result<(PathBuf, Rc<Mesh>), Problem> {
        let path = Path::new(path);
        let mut candidates = vec![path.to_owned()];
        if self.is_given {
            candidates.extend(path.file_name().map(PathBuf::from));
        } else {
            let above = |count| PathBuf::from_iter(std::iter::repeat_n("..", count));
            candidates.extend((1..=ABOVE).map(|count| above(count).join(path)));
        }
        let found = candidates
            .into_iter()
            .find(|path| self.folder.join(path).is_file());
        let Some(found) = found else {
            let (file, folder) = (path.display(), self.folder.display());
            let (places, hint) = if self.is_given {
                ("", "")
            } else {
                (" and the folders above", ", or name their folder with `--meshes`")
            };
            return Err(Problem::File(format!(
                "there is no file {file} in the folder {folder:?}{places}: copy the mesh there{hint}"
            )));
        };
        if let Some(mesh) = self.read.get(&found) {
            return Ok((found, Rc::clone(mesh)));
        }
        let mesh = Rc::new(Mesh::read(&self.folder.join(&found)).map_err(Problem::File)?);
        self.read.insert(found.clone(), Rc::clone(&mesh));
        Ok((found, mesh))
    }
}

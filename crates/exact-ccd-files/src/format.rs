//! Formats of mesh files.

use std::ffi::OsStr;
use std::path::Path;

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// The Stanford polygon format: text, or binary of either byte order.
    Ply,
    /// Wavefront OBJ.
    Obj,
    /// Stereolithography: text or binary.
    Stl,
    /// The Object File Format of Geomview, as text.
    Off,
    /// Gmsh's MSH, version 1 to 2.2, 4 or 4.1: text, or binary of either byte order. Cells with volume
    /// read as their surface.
    Msh,
    /// VTK's XML format of unstructured grids: data inline or appended, as text, in base64 or raw,
    /// also compressed by zlib or LZ4. Cells with volume read as their surface, and other faces
    /// beside them as they are.
    Vtu,
    /// VTK's XML format of surfaces, encoded as [`Format::Vtu`].
    Vtp,
    /// VTK's legacy format, up to version 5.1: unstructured grids and surfaces, text or binary.
    Vtk,
    /// glTF 2.0, as JSON or binary (GLB).
    Gltf,
    /// An array of numpy: the positions of vertices.
    Npy,
    /// Arrays of numpy in a zip archive: the positions of vertices, and faces.
    Npz,
}

impl Format {
    /// The format that belongs to the extension of a path, in upper or lower case. A last extension
    /// `.gz` does not count.
    ///
    /// ```
    /// use exact_ccd_files::Format;
    ///
    /// assert_eq!(Format::of_path("mesh.OBJ".as_ref()), Some(Format::Obj));
    /// assert_eq!(Format::of_path("mesh.ply.gz".as_ref()), Some(Format::Ply));
    /// ```
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = extension(path)?;
        let mut formats = Self::ALL.iter().copied();
        formats.find(|format| format.names().1.contains(&extension.as_str()))
    }

    /// The name of the format, such as `Wavefront OBJ`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.names().0
    }

    /// The extension of a file that is renamed to this format.
    pub(crate) fn extension(self) -> &'static str {
        self.names().1[0]
    }

    /// All extensions of [`Format::of_path`] as a list in words, such as `.ply, .obj or .npz`.
    #[must_use]
    pub fn extensions() -> String {
        let all: Vec<_> = Self::ALL.iter().flat_map(|format| format.names().1).collect();
        let (last, others) = all.split_last().unwrap_or((&&"", &[]));
        let others: Vec<_> = others.iter().map(|extension| format!(".{extension}")).collect();
        format!("{} or .{last}", others.join(", "))
    }

    const ALL: &[Self] = {
        use Format::{Gltf, Msh, Npy, Npz, Obj, Off, Ply, Stl, Vtk, Vtp, Vtu};
        &[Ply, Obj, Stl, Off, Msh, Vtu, Vtp, Vtk, Gltf, Npy, Npz]
    };

    /// The name and the extensions.
    fn names(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Ply => ("PLY", &["ply"]),
            Self::Obj => ("Wavefront OBJ", &["obj"]),
            Self::Stl => ("STL", &["stl"]),
            Self::Off => ("OFF", &["off"]),
            Self::Msh => ("Gmsh MSH", &["msh"]),
            Self::Vtu => ("VTK UnstructuredGrid", &["vtu"]),
            Self::Vtp => ("VTK PolyData", &["vtp"]),
            Self::Vtk => ("legacy VTK", &["vtk"]),
            Self::Gltf => ("glTF", &["glb", "gltf"]),
            Self::Npy => ("numpy .npy", &["npy"]),
            Self::Npz => ("numpy .npz", &["npz"]),
        }
    }
}

/// The extension of a path in lower case, without a last `.gz`.
pub(crate) fn extension(path: &Path) -> Option<String> {
    let path = if is_gzip(path) {
        Path::new(path.file_stem()?)
    } else {
        path
    };
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

/// Returns true if the last extension of a path is `.gz`.
pub(crate) fn is_gzip(path: &Path) -> bool {
    path.extension()
        .is_some_and(|last: &OsStr| last.eq_ignore_ascii_case("gz"))
}

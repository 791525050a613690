//! Known formats without a reader, and the export to use instead.

use std::fmt;
use std::path::Path;

use crate::format::extension;

/// A known format without a reader. Its text names the format and the export to use instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unsupported {
    name: &'static str,
    instead: &'static str,
}

const FRAMES: &str = "export each frame as OBJ or PLY with the same vertices (in Blender: File > Export > \
                      Wavefront (.obj) with Animation), or write positions and faces with numpy.savez";
const MESH: &str = "export the mesh as OBJ, PLY or GLB";
const EXTRACT: &str =
    "save its surface as .vtp (in ParaView: Extract Surface; in pyvista: extract_surface())";
const PIECES: &str = "save it as one .vtu or .vtp file (in ParaView: Merge Blocks; in pyvista: combine())";
const CACHE: &str = "a cache has the positions without the faces: give its mesh before it, as in `exact-ccd audit \
                     MESH.obj CACHE.pc2`";
const MAYA: &str = "export it as .pc2 or .mdd, or apply it to its mesh and export each frame as OBJ or PLY";
const ARRAYS: &str = "read its arrays in Python, and write positions and faces with numpy.savez";
const HOUDINI: &str = "save each frame as .obj or .ply (in Houdini: the nodes File Cache or ROP Geometry)";
const POINTS: &str = "a cloud of points has no faces: reconstruct the surface, and save it as .ply or .obj";
const BONES: &str = "a motion of bones has no mesh: apply it to its mesh and export each frame as OBJ or PLY with the \
                     same vertices";
const CAD: &str = "mesh its surface, for example with Gmsh, and save it as .msh";
const MESHIO: &str = "convert it with meshio: meshio convert IN OUT.vtu";

/// Extensions, with the name of the format and the advice.
const FORMATS: &[(&[&str], Unsupported)] = &[
    (&["abc"], Unsupported::new("Alembic", FRAMES)),
    (&["usd", "usda", "usdc", "usdz"], Unsupported::new("USD", FRAMES)),
    (&["fbx"], Unsupported::new("FBX", FRAMES)),
    (&["blend"], Unsupported::new("Blender's own format", FRAMES)),
    (&["dae"], Unsupported::new("COLLADA", MESH)),
    (
        &["3ds", "3mf", "x3d", "wrl", "lwo", "max", "ma", "mb", "c4d"],
        Unsupported::new("this format", MESH),
    ),
    (
        &["vti", "vtr", "vts"],
        Unsupported::new("a structured grid of VTK", EXTRACT),
    ),
    (
        &["vtm", "pvtu", "pvtp"],
        Unsupported::new("a VTK file of several blocks", PIECES),
    ),
    (
        &["vtkhdf", "xdmf", "xmf", "med", "cgns", "e", "exo"],
        Unsupported::new("a mesh in HDF5 or NetCDF", MESHIO),
    ),
    (&["h5", "hdf5", "hdf", "he5"], Unsupported::new("HDF5", ARRAYS)),
    (
        &["pkl", "pickle", "joblib"],
        Unsupported::new("a pickle of Python, which may run code when it is loaded", ARRAYS),
    ),
    (
        &["pt", "pth", "safetensors"],
        Unsupported::new("tensors of PyTorch", ARRAYS),
    ),
    (&["mat"], Unsupported::new("data of MATLAB", ARRAYS)),
    (
        &["pc2", "mdd"],
        Unsupported::new("a cache of positions alone", CACHE),
    ),
    (
        &["mcx", "mcc"],
        Unsupported::new("a cache of positions of Maya", MAYA),
    ),
    (
        &["bgeo", "sc", "bhclassic"],
        Unsupported::new("Houdini's own format", HOUDINI),
    ),
    (
        &["pcd", "las", "laz", "e57", "xyz", "pts"],
        Unsupported::new("a cloud of points", POINTS),
    ),
    (
        &["bvh", "c3d", "asf", "amc"],
        Unsupported::new("a motion of bones", BONES),
    ),
    (
        &["inp", "bdf", "nas", "mesh", "ele", "node"],
        Unsupported::new("this format", MESHIO),
    ),
    (
        &["step", "stp", "iges", "igs", "brep", "geo"],
        Unsupported::new("a CAD model", CAD),
    ),
];

impl Unsupported {
    const fn new(name: &'static str, instead: &'static str) -> Self {
        Self { name, instead }
    }

    /// The unsupported format that belongs to the extension of a path.
    pub(crate) fn of_path(path: &Path) -> Option<Self> {
        Self::of_extension(&extension(path)?)
    }

    pub(crate) fn of_extension(extension: &str) -> Option<Self> {
        let mut formats = FORMATS.iter();
        let (_, format) = formats.find(|(extensions, _)| extensions.contains(&extension))?;
        Some(*format)
    }

    /// The export to use instead.
    pub(crate) fn instead(self) -> &'static str {
        self.instead
    }
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, instead } = self;
        write!(f, "there is no reader for {name}; {instead}")
    }
}

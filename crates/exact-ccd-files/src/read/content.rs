//! Recognition of contents by their first bytes, for files that are not what their names say.

use crate::error::{Fault, ParseError, Place};
use crate::format::Format;
use crate::unsupported::Unsupported;

/// Contents with a known beginning.
enum Known {
    /// The contents of a format with a reader.
    Mesh(&'static str, Format),
    /// The contents of a format without one, by its extension.
    Other(&'static str, &'static str),
    /// Anything else, and the remedy.
    Advice(&'static str, &'static str),
}

/// Beginnings of files. Letters match in upper and lower case.
const BEGINNINGS: &[(&[u8], Known)] = {
    use Known::{Advice, Mesh, Other};
    const DOWNLOAD: &str = "download the file itself: the page is about it, or has an error message";
    const GZIP: &str = "add .gz to the name of the file, or decompress it";
    const FETCH: &str = "fetch the file itself with `git lfs pull`";
    const GMSH: &str = "write the format of Gmsh, in meshio with `file_format=\"gmsh\"`";
    const MESH: &str = "choose a file with a mesh";
    &[
        (b"\x1f\x8b", Advice("compressed by gzip", GZIP)),
        (b"<!doctype html", Advice("an HTML page", DOWNLOAD)),
        (b"<html", Advice("an HTML page", DOWNLOAD)),
        (b"version https://git-lfs", Advice("a pointer of Git LFS", FETCH)),
        (b"\x89PNG", Advice("a PNG picture", MESH)),
        (b"\xff\xd8\xff", Advice("a JPEG picture", MESH)),
        (b"%PDF-", Advice("a PDF document", MESH)),
        (b"\x7fELF", Advice("a program", MESH)),
        (b"Kaydara FBX Binary", Other("FBX", "fbx")),
        (b"Ogawa", Other("Alembic", "abc")),
        (b"PXR-USDC", Other("USD", "usd")),
        (b"#usda", Other("USD", "usd")),
        (b"BLENDER", Other("a file of Blender", "blend")),
        (b"\x89HDF", Other("HDF5", "h5")),
        (b"(0 \"", Advice("a mesh of ANSYS Fluent", GMSH)),
        (b"(1 \"", Advice("a mesh of ANSYS Fluent", GMSH)),
        (b"ISO-10303-21", Other("a STEP model", "step")),
        (b"ply\n", Mesh("PLY", Format::Ply)),
        (b"ply\r", Mesh("PLY", Format::Ply)),
        (b"# vtk DataFile", Mesh("legacy VTK", Format::Vtk)),
        (b"$MeshFormat", Mesh("Gmsh MSH", Format::Msh)),
        (b"glTF\x01", Mesh("binary glTF", Format::Gltf)),
        (b"glTF\x02", Mesh("binary glTF", Format::Gltf)),
        (b"\x93NUMPY", Mesh("a numpy array", Format::Npy)),
        (b"PK\x03\x04", Mesh("a zip archive", Format::Npz)),
    ]
};

/// The extension that belongs to a format.
fn extension(format: Format) -> &'static str {
    match format {
        Format::Ply => "ply",
        Format::Obj => "obj",
        Format::Stl => "stl",
        Format::Off => "off",
        Format::Msh => "msh",
        Format::Vtu => "vtu",
        Format::Vtp => "vtp",
        Format::Vtk => "vtk",
        Format::Gltf => "glb",
        Format::Npy => "npy",
        Format::Npz => "npz",
    }
}

/// Checks that the contents are not recognisably something else.
pub(super) fn check(bytes: &[u8], format: Format) -> Result<(), ParseError> {
    let (found, advice) = match recognise(bytes) {
        Some(Known::Mesh(found, own)) if *own != format => {
            (*found, format!("rename the file to end in .{}", extension(*own)))
        }
        Some(Known::Other(found, own)) => {
            let instead = Unsupported::of_extension(own).map_or("", |format| format.instead());
            (*found, instead.to_owned())
        }
        Some(Known::Advice(found, advice)) => (*found, (*advice).to_owned()),
        None if matches!(format, Format::Obj | Format::Off) && is_binary(bytes) => {
            ("binary data", "export the mesh again".to_owned())
        }
        _ => return Ok(()),
    };
    let expected = format.name();
    Err(Fault::Contents {
        found,
        expected,
        advice,
    }
    .at(Place::File))
}

fn recognise(bytes: &[u8]) -> Option<&'static Known> {
    let text = bytes
        .strip_prefix(b"\xef\xbb\xbf")
        .unwrap_or(bytes)
        .trim_ascii_start();
    let begins = |with: &[u8]| {
        let beginning = text.get(..with.len());
        beginning.is_some_and(|beginning| beginning.eq_ignore_ascii_case(with))
    };
    let mut known = BEGINNINGS.iter();
    known.find(|(with, _)| begins(with)).map(|(_, known)| known)
}

/// Returns true if there are zero bytes near the beginning, which text does not have.
fn is_binary(bytes: &[u8]) -> bool {
    bytes.iter().take(1024).any(|&byte| byte == 0)
}

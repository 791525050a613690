//! Recognition of contents by their first bytes, for files whose names say another format.

use crate::error::{Fault, ParseError, Place};
use crate::format::Format;
use crate::unsupported::Unsupported;

/// Contents with a known beginning.
#[derive(Clone, Copy)]
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
        (b"OFF\n", Mesh("OFF", Format::Off)),
        (b"OFF\r", Mesh("OFF", Format::Off)),
        (b"OFF ", Mesh("OFF", Format::Off)),
        (b"# vtk DataFile", Mesh("legacy VTK", Format::Vtk)),
        (b"$MeshFormat", Mesh("Gmsh MSH", Format::Msh)),
        (b"$NOD\n", Mesh("Gmsh MSH", Format::Msh)),
        (b"$NOD\r", Mesh("Gmsh MSH", Format::Msh)),
        (b"glTF\x01", Mesh("binary glTF", Format::Gltf)),
        (b"glTF\x02", Mesh("binary glTF", Format::Gltf)),
        (b"\x93NUMPY", Mesh("a numpy array", Format::Npy)),
        (b"PK\x03\x04", Mesh("a zip archive", Format::Npz)),
    ]
};

/// STL as text. Binary STL may begin with the same word.
const SOLID: Known = Known::Mesh("STL as text", Format::Stl);
const OBJ: Known = Known::Mesh("Wavefront OBJ", Format::Obj);
const VTU: Known = Known::Mesh("VTK UnstructuredGrid", Format::Vtu);
const VTP: Known = Known::Mesh("VTK PolyData", Format::Vtp);
const COLLECTION: Known = Known::Advice("a list of files of ParaView", "rename the file to end in .pvd");
const OTHER_VTK: Known = Known::Advice(
    "VTK data of another kind",
    "save the surface as .vtp (in ParaView: Extract Surface; in pyvista: extract_surface())",
);
const XML: Known = Known::Advice(
    "XML",
    "choose a file with a mesh, or export the mesh as OBJ or PLY",
);
const EMPTY: Known = Known::Advice("empty", "export the mesh again");

/// Checks that the contents are not recognisably something else.
pub(super) fn check(bytes: &[u8], format: Format) -> Result<(), ParseError> {
    let (found, advice) = match recognise(bytes) {
        Some(Known::Mesh(found, own)) if own != format => {
            (found, format!("rename the file to end in .{}", own.extension()))
        }
        Some(Known::Other(found, own)) => {
            let instead = Unsupported::of_extension(own).map_or("", |format| format.instead());
            (found, instead.to_owned())
        }
        Some(Known::Advice(found, advice)) => (found, advice.to_owned()),
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

fn recognise(bytes: &[u8]) -> Option<Known> {
    let text = bytes
        .strip_prefix(b"\xef\xbb\xbf")
        .unwrap_or(bytes)
        .trim_ascii_start();
    if text.is_empty() {
        return Some(EMPTY);
    }
    let is_xml = begins(text, b"<?xml");
    let text = if is_xml { without_prologue(text) } else { text };
    let mut known = BEGINNINGS.iter();
    if let Some((_, known)) = known.find(|(with, _)| begins(text, with)) {
        return Some(*known);
    }
    if begins(text, b"<VTKFile") {
        return kind_of_vtk(text);
    }
    match is_xml {
        true => Some(XML),
        false if is_binary(bytes) => None,
        false if begins(text, b"solid") => Some(SOLID),
        false => begins_obj(text).then_some(OBJ),
    }
}

/// Letters match in upper and lower case.
fn begins(text: &[u8], with: &[u8]) -> bool {
    let beginning = text.get(..with.len());
    beginning.is_some_and(|beginning| beginning.eq_ignore_ascii_case(with))
}

/// XML from its first element on: without declarations and comments.
fn without_prologue(text: &[u8]) -> &[u8] {
    let mut rest = text;
    while let Some(end) = [(&b"<?"[..], &b"?>"[..]), (b"<!--", b"-->")]
        .into_iter()
        .find_map(|(begin, end)| rest.starts_with(begin).then_some(end))
    {
        let at = rest.windows(end.len()).position(|window| window == end);
        let at = at.map_or(rest.len(), |at| at + end.len());
        rest = rest[at..].trim_ascii_start();
    }
    rest
}

/// The kind of data that the root element of VTK's XML names, if it names one.
fn kind_of_vtk(text: &[u8]) -> Option<Known> {
    let end = text.iter().position(|&byte| byte == b'>').unwrap_or(text.len());
    let has = |word: &[u8]| text[..end].windows(word.len()).any(|window| window == word);
    let is = |kind: &str| {
        ["\"", "'"]
            .iter()
            .any(|quote| has(format!("{quote}{kind}{quote}").as_bytes()))
    };
    if is("UnstructuredGrid") {
        Some(VTU)
    } else if is("PolyData") {
        Some(VTP)
    } else if is("Collection") {
        Some(COLLECTION)
    } else {
        has(b" type=").then_some(OTHER_VTK)
    }
}

/// Returns true if the first line that is no comment begins with a statement of OBJ.
fn begins_obj(text: &[u8]) -> bool {
    const STATEMENTS: [&[u8]; 7] = [b"v", b"vn", b"vt", b"o", b"g", b"mtllib", b"usemtl"];
    let mut lines = text.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let line = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"));
    let word = line.and_then(|line| line.split(u8::is_ascii_whitespace).next());
    word.is_some_and(|word| STATEMENTS.contains(&word))
}

/// Returns true if there are zero bytes near the beginning, which text does not have.
fn is_binary(bytes: &[u8]) -> bool {
    bytes.iter().take(1024).any(|&byte| byte == 0)
}

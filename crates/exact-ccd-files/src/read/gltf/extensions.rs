//! Extensions by their effect on geometry.

use crate::error::{Fault, Place, quoted};
use crate::note::{Fact, Note};

/// Beginnings of the names of extensions that do not concern geometry: materials, textures, lights and data.
const WITHOUT_GEOMETRY: [&str; 12] = [
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "MSFT_texture_",
    "MSFT_packing_",
    "ADOBE_materials_",
    "FB_material_",
    "KHR_lights_",
    "EXT_lights_",
    "KHR_techniques_",
    "KHR_xmp",
    "EXT_mesh_features",
];

/// Extensions that are read.
const READ: [&str; 2] = ["KHR_mesh_quantization", "EXT_mesh_gpu_instancing"];

/// Extensions that change geometry and are not read, and the remedy.
const NOT_READ: [(&str, &str); 10] = {
    const UNCOMPRESSED: &str =
        "export it without compression of meshes (in Blender: without Data > Compression)";
    const UNPACKED: &str = "decompress it with gltf-transform copy IN OUT";
    const MESHES: &str = "export the shapes as meshes";
    [
        ("KHR_draco_mesh_compression", UNCOMPRESSED),
        ("EXT_meshopt_compression", UNPACKED),
        ("KHR_meshopt_compression", UNPACKED),
        ("KHR_implicit_shapes", MESHES),
        ("KHR_physics_rigid_bodies", MESHES),
        ("OMI_physics_shape", MESHES),
        (
            "KHR_node_visibility",
            "remove the nodes that are hidden: they are read",
        ),
        (
            "MSFT_lod",
            "export each level of detail as a file: the first one is read",
        ),
        (
            "KHR_animation_pointer",
            "bake the animation to translations of nodes",
        ),
        ("KHR_gaussian_splatting", "reconstruct the surface"),
    ]
};

fn remedy(name: &str) -> Option<&'static str> {
    let (_, remedy) = NOT_READ.iter().find(|(known, _)| *known == name)?;
    Some(remedy)
}

/// Refuses required extensions that are not read and may concern geometry.
pub(super) fn check_required(required: &[String]) -> Result<(), Fault> {
    let is_read = |name: &&String| {
        let prefixes = &WITHOUT_GEOMETRY;
        READ.contains(&name.as_str()) || prefixes.iter().any(|prefix| name.starts_with(prefix))
    };
    match required.iter().find(|name| !is_read(name)) {
        None => Ok(()),
        Some(name) => {
            let remedy = remedy(name).unwrap_or("it may concern geometry: export the file without it");
            let expected = format!("a glTF file that does not require this extension ({remedy})");
            Err(Fault::expected(expected, quoted(name.as_bytes())))
        }
    }
}

/// Notes about extensions that change geometry, among those that a file uses and does not require. A mesh
/// that is compressed has another form, then, which is read.
pub(super) fn notes(used: &[String]) -> impl Iterator<Item = Note> {
    used.iter().filter_map(|name| {
        let remedy = remedy(name).filter(|_| !name.ends_with("_compression"))?;
        let part = format!("the extension {}", quoted(name.as_bytes()));
        Some(Fact::not_read(part, remedy).at(Place::File))
    })
}

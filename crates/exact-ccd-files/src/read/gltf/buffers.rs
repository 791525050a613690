//! The buffers of a file: its own binary part, text in base64, or other files.

use std::path::{Component, Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::Document;
use gltf::buffer::Source;
use percent_encoding::percent_decode_str;

use crate::error::{Fault, quoted};

/// The contents of each buffer. Other files are in `folder`.
pub(super) fn read(
    document: &Document,
    blob: Option<Vec<u8>>,
    folder: Option<&Path>,
) -> Result<Vec<Vec<u8>>, Fault> {
    let mut blob = blob;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let index = buffer.index();
        let data = match buffer.source() {
            Source::Bin => blob
                .take()
                .ok_or_else(|| Fault::ends("the binary part of a GLB file"))?,
            Source::Uri(uri) => match uri.strip_prefix("data:") {
                Some(data) => decode(data).ok_or_else(|| {
                    let expected = format!("base64 in the URI of buffer {index}");
                    Fault::expected(expected, quoted(uri.as_bytes()))
                })?,
                None => read_file(uri, folder)?,
            },
        };
        if data.len() < buffer.length() {
            let expected = format!("{} bytes of buffer {index}", buffer.length());
            return Err(Fault::expected(expected, data.len().to_string()));
        }
        buffers.push(data);
    }
    Ok(buffers)
}

/// The data of a URI `data:TYPE;base64,TEXT`, without its first five characters.
fn decode(uri: &str) -> Option<Vec<u8>> {
    let (_, text) = uri.split_once(";base64,")?;
    STANDARD.decode(text).ok()
}

/// Reads a file that a relative path in a URI names: below the folder, and not elsewhere.
fn read_file(uri: &str, folder: Option<&Path>) -> Result<Vec<u8>, Fault> {
    let found = || quoted(uri.as_bytes());
    let Some(folder) = folder else {
        return Err(Fault::expected(
            "data within the file, as in a .glb file",
            found(),
        ));
    };
    let name = percent_decode_str(uri).decode_utf8();
    let name = name.ok().map(|name| PathBuf::from(&*name)).filter(|name| {
        name.components()
            .all(|component| matches!(component, Component::Normal(_) | Component::CurDir))
    });
    let name = name.ok_or_else(|| Fault::expected("a file in the same folder", found()))?;
    let path = folder.join(name);
    std::fs::read(&path).map_err(|error| {
        let expected = "the file of a buffer beside the .gltf file";
        Fault::expected(expected, format!("{}: {error}", found()))
    })
}

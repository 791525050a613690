//! The buffers of a file: its own binary part, text in base64, or other files.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::{Component, Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use percent_encoding::percent_decode_str;

use super::super::budget::Budget;
use super::super::file::read_within;
use super::document::{Document, at};
use crate::error::{Fault, quoted};

/// The contents of the buffers. Buffers of one file share its contents.
pub(super) struct Buffers {
    contents: Vec<Vec<u8>>,
    /// The index of the contents of each buffer.
    contents_of: Vec<usize>,
}

impl Buffers {
    /// Reads the contents of each buffer. Other files are in `folder`.
    pub(super) fn read(
        document: &Document,
        blob: Option<&[u8]>,
        folder: Option<&Path>,
        budget: &Budget,
    ) -> Result<Self, Fault> {
        let mut blob = blob;
        let mut files = HashMap::new();
        let (mut contents, mut contents_of) = (Vec::new(), Vec::new());
        for (index, buffer) in document.buffers.iter().enumerate() {
            let place = match &buffer.uri {
                None => {
                    let blob = blob.take();
                    let blob = blob.ok_or_else(|| Fault::ends("the binary part of a GLB file"))?;
                    contents.push(blob.to_vec());
                    contents.len() - 1
                }
                Some(uri) => match uri.strip_prefix("data:") {
                    Some(data) => {
                        contents.push(decode(data).ok_or_else(|| {
                            let expected = format!("base64 in the URI of buffer {index}");
                            Fault::expected(expected, quoted(uri.as_bytes()))
                        })?);
                        contents.len() - 1
                    }
                    None => match files.entry(file(uri, folder)?) {
                        Entry::Occupied(place) => *place.get(),
                        Entry::Vacant(place) => {
                            contents.push(read_file(place.key(), uri, budget)?);
                            *place.insert(contents.len() - 1)
                        }
                    },
                },
            };
            let length = contents[place].len();
            if (length as u64) < buffer.byte_length {
                let expected = format!("{} bytes of buffer {index}", buffer.byte_length);
                return Err(Fault::expected(expected, length.to_string()));
            }
            contents_of.push(place);
        }
        let size: usize = contents.iter().map(Vec::len).sum();
        budget.step(size as u64);
        budget.hold::<u8>(size);
        Ok(Self {
            contents,
            contents_of,
        })
    }

    /// The contents of the buffer with this index.
    pub(super) fn get(&self, buffer: u32) -> Result<&[u8], Fault> {
        Ok(&self.contents[*at(&self.contents_of, buffer, "buffer")?])
    }
}

/// The data of a URI `data:TYPE;base64,TEXT`, without its first five characters.
fn decode(uri: &str) -> Option<Vec<u8>> {
    let (_, text) = uri.split_once(";base64,")?;
    STANDARD.decode(text).ok()
}

/// The file that a relative path in a URI names: below the folder, and not elsewhere.
fn file(uri: &str, folder: Option<&Path>) -> Result<PathBuf, Fault> {
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
    // Every path of a file is the same one: without the parts `.`.
    let parts = name
        .components()
        .filter(|part| matches!(part, Component::Normal(_)));
    Ok(folder.join(parts.collect::<PathBuf>()))
}

fn read_file(path: &Path, uri: &str, budget: &Budget) -> Result<Vec<u8>, Fault> {
    let contents = read_within(path, budget).map_err(|error| {
        let expected = "the file of a buffer beside the .gltf file";
        Fault::expected(expected, format!("{}: {error}", quoted(uri.as_bytes())))
    })?;
    budget.add_file(contents.len() as u64)?;
    Ok(contents)
}

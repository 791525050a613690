//! `common`: a file whose entries apply where the scene has none.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::fault::{Fault, Place, Problem};

/// The most files that refer to each other.
const DEPTH: usize = 16;

/// The contents of a scene, merged (RFC 7396) with the contents of the file that its key `common` names,
/// relative to `folder`.
pub(super) fn resolved(mut scene: Value, folder: &Path) -> Result<Value, Fault> {
    let mut folder = folder.to_owned();
    for _ in 0..DEPTH {
        let Some(common) = scene.as_object_mut().and_then(|scene| scene.remove("common")) else {
            return Ok(scene);
        };
        let place = Place::Pointer("/common".to_owned());
        let name = match &common {
            Value::String(name) if name.is_empty() => return Ok(scene),
            Value::String(name) => name,
            other => return Err(Problem::invalid(other, "the name of a file").at(&place)),
        };
        let file = folder.join(name);
        let mut base = read(&file).map_err(|problem| problem.at(&place))?;
        merge(&mut base, scene);
        scene = base;
        folder = file.parent().map_or_else(PathBuf::new, Path::to_owned);
    }
    let expected = format!("at most {DEPTH} files that name each other");
    Err(Problem::invalid("more files", expected).at(&Place::Pointer("/common".to_owned())))
}

fn read(file: &Path) -> Result<Value, Problem> {
    let at_file = |message: String| Problem::File(format!("{}: {message}", file.display()));
    let text = std::fs::read_to_string(file).map_err(|error| at_file(error.to_string()))?;
    serde_json::from_str(&text).map_err(|error| at_file(error.to_string()))
}

/// Applies a merge patch.
fn merge(target: &mut Value, patch: Value) {
    let Value::Object(patch) = patch else {
        *target = patch;
        return;
    };
    if !target.is_object() {
        *target = Value::Object(serde_json::Map::new());
    }
    let Value::Object(target) = target else {
        return;
    };
    for (key, value) in patch {
        if value.is_null() {
            target.remove(&key);
        } else {
            merge(target.entry(key).or_insert(Value::Null), value);
        }
    }
}

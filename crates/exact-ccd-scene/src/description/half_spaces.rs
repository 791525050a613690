//! Half spaces as tables of a scene file, `[[half-space]]`.

use exact_ccd_mesh::{HalfSpace, Point};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The keys of a half space.
#[derive(Serialize, Deserialize)]
#[serde(remote = "HalfSpace", deny_unknown_fields, rename_all = "kebab-case")]
struct Keys {
    #[serde(default, skip_serializing_if = "String::is_empty")]
    name: String,
    #[serde(default)]
    point: Point,
    normal: Point,
}

/// A half space as a table.
#[derive(Serialize, Deserialize)]
struct Table(#[serde(with = "Keys")] HalfSpace);

pub(crate) fn serialize<S: Serializer>(half_spaces: &[HalfSpace], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(half_spaces.iter().cloned().map(Table))
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<HalfSpace>, D::Error> {
    let tables = Vec::<Table>::deserialize(deserializer)?;
    Ok(tables.into_iter().map(|Table(half_space)| half_space).collect())
}

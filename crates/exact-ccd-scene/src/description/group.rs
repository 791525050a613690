//! Groups of a mesh file, by their names or their tags.

use std::collections::BTreeSet;

use exact_ccd_files::Group;
use serde::{Deserialize, Serialize};

/// The most groups that a message lists.
const MOST: usize = 20;

/// The tag of a physical group, or the name of a group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "expected the name of a group, or the tag of a physical group, an integer not below 0"
)]
pub enum GroupKey {
    /// The tag of a physical group.
    Tag(u32),
    /// The name of a group.
    Name(String),
}

impl GroupKey {
    /// The groups of this tag or name, of any dimension; or a message with the groups that there are.
    pub(crate) fn find<'a>(&self, groups: &'a [Group]) -> Result<Vec<&'a Group>, String> {
        let is_it = |group: &&Group| match self {
            Self::Tag(tag) => group.physical.is_some_and(|physical| physical.tag == *tag),
            Self::Name(name) => group.name == *name,
        };
        let found: Vec<&Group> = groups.iter().filter(is_it).collect();
        match groups {
            _ if !found.is_empty() => Ok(found),
            [] => Err(
                "the mesh has no groups, expected a Gmsh file with physical groups, an OBJ file with objects or \
                 groups, or a PLY file with named parts"
                    .to_owned(),
            ),
            groups => {
                let known: BTreeSet<(Option<u32>, &str)> = groups.iter().map(key).collect();
                let more = if known.len() > MOST { ", …" } else { "" };
                let known: Vec<String> = known.into_iter().take(MOST).map(label).collect();
                let known = known.join(", ");
                Err(format!("the mesh has no such group, expected one of {known}{more}"))
            }
        }
    }
}

/// The tag and the name of a group.
fn key(group: &Group) -> (Option<u32>, &str) {
    (group.physical.map(|physical| physical.tag), &group.name)
}

fn label(key: (Option<u32>, &str)) -> String {
    match key {
        (Some(tag), "") => tag.to_string(),
        (Some(tag), name) => format!("{tag} `{name}`"),
        (None, name) => format!("`{name}`"),
    }
}

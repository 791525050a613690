//! Groups of elements of a mesh file.

use std::collections::HashMap;

/// A group of elements: an object or a group of OBJ, the named parts of PLY, or a physical group of Gmsh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// The name. Only a physical group may have none: it is empty then.
    pub name: String,
    /// The dimension and the tag of a physical group of Gmsh, which identify it.
    pub physical: Option<PhysicalTag>,
    /// The vertices of its elements, increasing. Groups may have vertices in common.
    pub vertices: Vec<u32>,
    /// Its cells with volume, by their numbers among the cells with volume of the file, increasing.
    pub cells: Vec<u32>,
}

/// The tag of a physical group of Gmsh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PhysicalTag {
    /// The dimension of its elements: 0 for points, 1 for lines, 2 for faces, 3 for cells with volume.
    pub dimension: u8,
    /// The tag, positive. Groups of different dimensions may have the same one.
    pub tag: u32,
}

impl Group {
    /// A group that has a name and vertices only.
    pub(super) fn named(name: String, vertices: Vec<u32>) -> Self {
        Self {
            name,
            vertices,
            ..Self::default()
        }
    }
}

/// The names of these groups with all their vertices, in the order of their first groups that have vertices.
pub(super) fn by_name(groups: impl IntoIterator<Item = Group>) -> Vec<Group> {
    let mut named: Vec<Group> = Vec::new();
    let mut numbers: HashMap<String, usize> = HashMap::new();
    for Group { name, vertices, .. } in groups {
        if name.is_empty() || vertices.is_empty() {
            continue;
        }
        match numbers.get(&name) {
            Some(&number) => named[number].vertices.extend(vertices),
            None => {
                numbers.insert(name.clone(), named.len());
                named.push(Group::named(name, vertices));
            }
        }
    }
    for group in &mut named {
        group.vertices.sort_unstable();
        group.vertices.dedup();
    }
    named
}

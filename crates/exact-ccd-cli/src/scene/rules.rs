//! The pairs of parts that can collide.

use std::fmt;
use std::str::FromStr;

use exact_ccd_mesh::CanCollide;

use super::options::SceneOptions;
use super::part::Part;
use crate::failure::Failure;

/// Two parts by their names, `A:B` on the command line.
#[derive(Clone, Debug)]
pub(crate) struct PartPair([String; 2]);

impl FromStr for PartPair {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            Some((a, b)) if !a.is_empty() && !b.is_empty() && !b.contains(':') => {
                Ok(Self([a.to_owned(), b.to_owned()]))
            }
            _ => Err("expected two names of parts, A:B".to_owned()),
        }
    }
}

impl fmt::Display for PartPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self([a, b]) = self;
        write!(f, "{a}:{b}")
    }
}

/// The pairs of a scene that can collide: those of the rules, without those of two obstacles.
pub(super) fn can_collide(parts: &[Part], options: &SceneOptions) -> Result<CanCollide, Failure> {
    let count = parts.len();
    let indices = |pair: &PartPair| -> Result<[usize; 2], Failure> {
        let mut found = [0; 2];
        for (index, name) in found.iter_mut().zip(&pair.0) {
            let part = parts.iter().position(|part| part.name == *name);
            *index = part.ok_or_else(|| Failure::UnknownPart {
                name: name.clone(),
                known: parts.iter().map(|part| part.name.clone()).collect(),
            })?;
        }
        Ok(found)
    };
    let mut allowed = vec![options.only.is_empty(); count * count];
    for (pairs, value) in [(&options.only, true), (&options.ignore, false)] {
        for pair in pairs {
            let [a, b] = indices(pair)?;
            allowed[a * count + b] = value;
            allowed[b * count + a] = value;
        }
    }
    for (a, first) in parts.iter().enumerate() {
        for (b, second) in parts.iter().enumerate() {
            allowed[a * count + b] &= !(first.is_obstacle && second.is_obstacle);
        }
    }
    if allowed.iter().all(|&allowed| allowed) {
        return Ok(CanCollide::all());
    }
    // Parts have no vertices in common, so that a primitive is in the part of its first vertex.
    let ends: Vec<u32> = parts.iter().map(|part| part.vertices.end).collect();
    let part_of = move |primitive: &[u32]| ends.partition_point(|&end| end <= primitive[0]);
    Ok(CanCollide::new(move |a, b| {
        allowed[part_of(a) * count + part_of(b)]
    }))
}

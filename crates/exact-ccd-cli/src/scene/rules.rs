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

/// Vertices of the scene with a name.
struct Named<'a> {
    name: &'a str,
    /// The name of the part to which they belong.
    part: &'a str,
    /// The vertex after the last one. The first one follows those before.
    end: u32,
    is_obstacle: bool,
}

/// The pairs of a scene that can collide: those of the rules, without those of two obstacles. A name stands
/// for all vertices that have it, and for all parts that have it.
pub(super) fn can_collide(parts: &[Part], options: &SceneOptions) -> Result<CanCollide, Failure> {
    let named: Vec<Named<'_>> = parts
        .iter()
        .flat_map(|part| {
            let is_obstacle = part.is_obstacle;
            part.names().into_iter().map(move |(name, end)| Named {
                name,
                part: &part.name,
                end,
                is_obstacle,
            })
        })
        .collect();
    let count = named.len();
    let places = |name: &String| -> Result<Vec<usize>, Failure> {
        let places: Vec<usize> = (0..count)
            .filter(|&place| [named[place].name, named[place].part].contains(&name.as_str()))
            .collect();
        if places.is_empty() {
            return Err(Failure::UnknownPart {
                name: name.clone(),
                known: named.iter().map(|named| named.name.to_owned()).collect(),
            });
        }
        Ok(places)
    };
    let mut allowed = vec![options.only.is_empty(); count * count];
    for (pairs, value) in [(&options.only, true), (&options.ignore, false)] {
        for PartPair([first, second]) in pairs {
            let second = places(second)?;
            for a in places(first)? {
                for &b in &second {
                    allowed[a * count + b] = value;
                    allowed[b * count + a] = value;
                }
            }
        }
    }
    for (a, first) in named.iter().enumerate() {
        for (b, second) in named.iter().enumerate() {
            allowed[a * count + b] &= !(first.is_obstacle && second.is_obstacle);
        }
    }
    if allowed.iter().all(|&allowed| allowed) {
        return Ok(CanCollide::all());
    }
    // Bodies have no vertices in common, so that a primitive is in the body of its first vertex.
    let ends: Vec<u32> = named.iter().map(|named| named.end).collect();
    let place_of = move |primitive: &[u32]| ends.partition_point(|&end| end <= primitive[0]);
    Ok(CanCollide::new(move |a, b| {
        allowed[place_of(a) * count + place_of(b)]
    }))
}

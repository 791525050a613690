//! The violations by pairs of bodies.

use std::collections::HashMap;
use std::fmt;

use serde::Serialize;

use crate::contacts::{ContactList, ContactRecord};
use crate::text::numbers::shortest;

/// The pairs of bodies that have violations, in the order of their first ones; none, if all is one body.
#[derive(Serialize)]
#[serde(transparent)]
pub(super) struct BodyPairs(Vec<BodyPair>);

/// The violations of two bodies, or of one with itself.
#[derive(Serialize)]
struct BodyPair {
    /// The names, sorted; none of a half space.
    bodies: [Option<String>; 2],
    count: usize,
    /// The frame of the first one, or the frame at which its step begins.
    first_frame: usize,
    /// Its time in the step; none of an intersection at rest.
    first_time: Option<f64>,
}

/// The most lines of text.
const LINES: usize = 20;

impl BodyPairs {
    pub(super) fn of(ContactList(records): &ContactList) -> Self {
        let mut pairs: Vec<BodyPair> = Vec::new();
        let mut places = HashMap::new();
        for record in records {
            let Some(owners) = &record.owners else {
                continue;
            };
            let mut bodies = owners.parts.clone();
            bodies.sort();
            let place = *places.entry(bodies).or_insert_with_key(|bodies| {
                pairs.push(BodyPair::new(bodies.clone(), record));
                pairs.len() - 1
            });
            pairs[place].count += 1;
        }
        Self(pairs)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl BodyPair {
    fn new(bodies: [Option<String>; 2], first: &ContactRecord) -> Self {
        Self {
            bodies,
            count: 0,
            first_frame: first.frame,
            first_time: (!first.is_intersection()).then(|| first.toi()),
        }
    }
}

/// A line of text for each of the first pairs.
impl fmt::Display for BodyPairs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(pairs) = self;
        for pair in pairs.iter().take(LINES) {
            let names = pair
                .bodies
                .each_ref()
                .map(|name| name.as_deref().unwrap_or("a half space"));
            let [a, b] = names;
            write!(f, "  {a} and {b}: {}, the first ", pair.count)?;
            match pair.first_time {
                Some(time) => writeln!(f, "after frame {} at t = {}", pair.first_frame, shortest(time))?,
                None => writeln!(f, "in frame {}", pair.first_frame)?,
            }
        }
        match pairs.len().checked_sub(LINES) {
            Some(more @ 1..) => writeln!(f, "  and {more} more pairs of bodies, which --json lists"),
            _ => Ok(()),
        }
    }
}

//! The friction coefficients of pairs of bodies.

use std::collections::HashMap;

use crate::range::{OutOfRange, check_not_negative};
use crate::settings::Friction;
use crate::system::System;

/// The friction coefficient of each pair of bodies and half spaces.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coefficients {
    default: f64,
    /// The number of the name of each body, and of each half space after them. Equal names have one number.
    numbers: Vec<usize>,
    /// The coefficients of pairs of names, by the numbers of these, the lesser one first.
    pairs: HashMap<[usize; 2], f64>,
}

impl Coefficients {
    /// The coefficients of settings, for the bodies and half spaces of a system. A pair of names applies to
    /// all bodies with these names, and the last pair of two bodies counts.
    ///
    /// # Errors
    /// The place of the first pair that has a negative coefficient or a name that no body has.
    pub(crate) fn new(friction: &Friction, system: &System) -> Result<Self, (usize, OutOfRange)> {
        let mut first = HashMap::new();
        let names = system.names();
        let numbered = names.iter().enumerate();
        let numbers = numbered
            .map(|(place, name)| *first.entry(*name).or_insert(place))
            .collect();
        let number = |name: &String| {
            let number = first.get(name.as_str()).filter(|_| !name.is_empty());
            number.copied().ok_or_else(|| OutOfRange {
                field: "between",
                found: format!("`{name}`"),
                expected: format!("names of bodies and half spaces: {}", system.known_names()),
            })
        };
        let mut pairs = HashMap::new();
        for (place, pair) in friction.pairs.iter().enumerate() {
            let wrong = |source| (place, source);
            check_not_negative("coefficient", pair.coefficient).map_err(wrong)?;
            let a = number(&pair.between[0]).map_err(wrong)?;
            let b = number(&pair.between[1]).map_err(wrong)?;
            pairs.insert([a.min(b), a.max(b)], pair.coefficient);
        }
        let default = friction.coefficient;
        Ok(Self {
            default,
            numbers,
            pairs,
        })
    }

    /// The coefficient of two bodies or half spaces, by their places in the list of all bodies, followed by
    /// the half spaces.
    pub(crate) fn of(&self, bodies: [usize; 2]) -> f64 {
        let [a, b] = bodies.map(|place| self.numbers[place]);
        let pair = self.pairs.get(&[a.min(b), a.max(b)]);
        pair.copied().unwrap_or(self.default)
    }
}

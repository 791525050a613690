//! The friction coefficients of pairs of bodies.

use std::collections::HashMap;

use crate::settings::Friction;

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
    /// The coefficients of settings, for bodies and half spaces with these names. A pair of names applies to
    /// all bodies with these names, and the last pair of two bodies counts.
    ///
    /// # Errors
    /// The first name that no body has.
    pub(crate) fn new(friction: &Friction, names: &[&str]) -> Result<Self, String> {
        let mut first = HashMap::new();
        let numbered = names.iter().enumerate();
        let numbers = numbered
            .map(|(place, name)| *first.entry(*name).or_insert(place))
            .collect();
        let number = |name: &String| {
            let number = first.get(name.as_str()).filter(|_| !name.is_empty());
            number.copied().ok_or_else(|| name.clone())
        };
        let mut pairs = HashMap::new();
        for pair in &friction.pairs {
            let [a, b] = [number(&pair.between[0])?, number(&pair.between[1])?];
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

//! The friction coefficients of pairs of bodies.

use std::collections::HashMap;

use crate::settings::Friction;

/// The friction coefficient of each pair of bodies and half spaces, by their places in the list of all
/// bodies, followed by the half spaces.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coefficients {
    default: f64,
    pairs: HashMap<[usize; 2], f64>,
}

impl Coefficients {
    /// The coefficients of settings, for bodies and half spaces with these names. A pair of names applies to
    /// all bodies with these names, and the last pair of two bodies counts.
    ///
    /// # Errors
    /// The first name that no body has.
    pub(crate) fn new(friction: &Friction, names: &[&str]) -> Result<Self, String> {
        let places = |name: &String| {
            let named = |(place, of): (usize, &&str)| (*of == name).then_some(place);
            let places: Vec<usize> = names.iter().enumerate().filter_map(named).collect();
            if places.is_empty() || name.is_empty() {
                Err(name.clone())
            } else {
                Ok(places)
            }
        };
        let mut pairs = HashMap::new();
        for pair in &friction.pairs {
            let [first, second] = [places(&pair.between[0])?, places(&pair.between[1])?];
            for a in first {
                pairs.extend(second.iter().map(|&b| ([a.min(b), a.max(b)], pair.coefficient)));
            }
        }
        let default = friction.coefficient;
        Ok(Self { default, pairs })
    }

    /// The coefficient of two bodies.
    pub(crate) fn of(&self, [a, b]: [usize; 2]) -> f64 {
        let pair = self.pairs.get(&[a.min(b), a.max(b)]);
        pair.copied().unwrap_or(self.default)
    }
}

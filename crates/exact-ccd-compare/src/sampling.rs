//! A random sample of queries, half of them in contact.

use exact_ccd::{CONTACT, Kind, Query};

/// A query and its ground truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject<K: Kind> {
    /// The query.
    pub query: Query<K>,
    /// True if its primitives touch.
    pub collides: bool,
    /// The earliest contact time, rounded down, if it is known.
    pub first: Option<f64>,
}

impl<K: Kind> Subject<K> {
    /// A query and its ground truth, if there is one: true for contact. The exact method computes
    /// what is missing.
    #[must_use]
    pub fn new(query: Query<K>, truth: Option<bool>) -> Self {
        let first = match truth {
            Some(false) => None,
            _ => query.time_of_impact(CONTACT),
        };
        Self {
            query,
            collides: truth.unwrap_or(first.is_some()),
            first,
        }
    }
}

/// A sample of the queries of a data set.
///
/// Queries that collide and queries that do not are two classes. As many are drawn from each class, so
/// that rare contacts are timed as well as frequent ones. Means weight each class by its share of the data
/// set.
#[derive(Clone, Debug)]
pub struct Subjects<K: Kind> {
    free: Reservoir<Subject<K>>,
    colliding: Reservoir<Subject<K>>,
    random: fastrand::Rng,
}

/// A sample of a stream of unknown length, each of whose items is in it with the same probability
/// (Vitter 1985, algorithm R).
#[derive(Clone, Debug)]
struct Reservoir<T> {
    kept: Vec<T>,
    most: usize,
    seen: usize,
}

impl<T> Reservoir<T> {
    fn new(most: usize) -> Self {
        Self {
            kept: Vec::new(),
            most,
            seen: 0,
        }
    }

    fn add(&mut self, item: T, random: &mut fastrand::Rng) {
        self.seen += 1;
        if self.kept.len() < self.most {
            self.kept.push(item);
        } else if let Some(place) = self.kept.get_mut(random.usize(..self.seen)) {
            *place = item;
        }
    }
}

impl<K: Kind> Subjects<K> {
    /// Keeps up to `most` queries that collide and as many that do not.
    #[must_use]
    pub fn new(most: usize) -> Self {
        Self {
            free: Reservoir::new(most),
            colliding: Reservoir::new(most),
            // The seed is fixed: the sample is the same every time.
            random: fastrand::Rng::with_seed(0),
        }
    }

    /// Adds a query of the data set, which the sample may drop.
    pub fn add(&mut self, subject: Subject<K>) {
        let reservoir = if subject.collides {
            &mut self.colliding
        } else {
            &mut self.free
        };
        reservoir.add(subject, &mut self.random);
    }

    /// The numbers of queries of the data set that do not collide, and that do.
    #[must_use]
    pub fn population(&self) -> [usize; 2] {
        [self.free.seen, self.colliding.seen]
    }

    /// The sample in random order. The two classes alternate until one is exhausted, so that a
    /// method that answers only the first few has answered both.
    #[must_use]
    pub fn sample(&self) -> Vec<Subject<K>> {
        let mut random = self.random.clone();
        let [mut free, mut colliding] = [&self.free, &self.colliding].map(|reservoir| reservoir.kept.clone());
        random.shuffle(&mut free);
        random.shuffle(&mut colliding);
        let turns = free.len().max(colliding.len());
        (0..turns)
            .flat_map(|turn| [colliding.get(turn), free.get(turn)])
            .flatten()
            .copied()
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_of_a_stream_is_as_likely() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut kept = [0usize; 20];
        for _ in 0..10_000 {
            let mut reservoir = Reservoir::new(5);
            (0..20).for_each(|item| reservoir.add(item, &mut random));
            reservoir.kept.iter().for_each(|&item: &usize| kept[item] += 1);
        }
        // 2,500 each; the standard deviation is 43.
        assert!(kept.iter().all(|count| (2300..2700).contains(count)), "{kept:?}");
    }
}

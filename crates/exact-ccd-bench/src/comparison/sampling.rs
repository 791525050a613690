//! A random sample of queries, half of them in contact.

use exact_ccd::{ContactTime, Kind, Query};

/// A query, and what is true of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject<K> {
    /// The query.
    pub query: Query<K>,
    /// Whether its primitives touch.
    pub collides: bool,
    /// When first, rounded down, if it is known.
    pub first: Option<f64>,
}

impl<K: Kind> Subject<K> {
    /// A query, of which it may be known whether its primitives touch. What is not known is computed by the exact method.
    #[must_use]
    pub fn new(query: Query<K>, truth: Option<bool>) -> Self {
        let first = match truth {
            Some(false) => None,
            _ => query.contact_times().first(),
        };
        Self {
            query,
            collides: truth.unwrap_or(first.is_some()),
            first: first.map(ContactTime::lower),
        }
    }
}

/// A sample of the queries of a data set: those that collide and those that do not are drawn apart, and each share is
/// weighed by how many the data set has, so that rare contacts are timed as well as frequent ones.
#[derive(Clone, Debug)]
pub struct Subjects<K> {
    free: Reservoir<Subject<K>>,
    colliding: Reservoir<Subject<K>>,
    random: fastrand::Rng,
}

/// A sample of a stream of unknown length, each of whose items is in it with the same probability (Vitter 1985,
/// algorithm R).
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

impl<K: Copy> Subjects<K> {
    /// Keeps up to `most` queries that collide and as many that do not.
    #[must_use]
    pub fn new(most: usize) -> Self {
        Self {
            free: Reservoir::new(most),
            colliding: Reservoir::new(most),
            // The same sample every time.
            random: fastrand::Rng::with_seed(0),
        }
    }

    /// One more query of the data set.
    pub fn add(&mut self, subject: Subject<K>) {
        let reservoir = if subject.collides {
            &mut self.colliding
        } else {
            &mut self.free
        };
        reservoir.add(subject, &mut self.random);
    }

    /// How many queries the data set has that do not collide, and that do.
    #[must_use]
    pub fn population(&self) -> [usize; 2] {
        [self.free.seen, self.colliding.seen]
    }

    /// The sample in random order, both classes taking turns while there are some of either: who answers only the first
    /// few has seen both.
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

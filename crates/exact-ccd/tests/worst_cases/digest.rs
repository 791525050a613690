//! The exact path's answers to many queries in one number, down to the last bit.

use exact_ccd::{CONTACT, ContactTime, Intervals, Query, exact};

use crate::families::{Family, Points, Primitives, Random};

/// A hash after Fowler, Noll and Vo.
struct Digest(u64);

impl Digest {
    fn add(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn add_number(&mut self, x: f64) {
        self.add(x.to_bits());
    }

    fn add_time(&mut self, time: ContactTime) {
        self.add_number(time.lower());
        self.add(time.is_exact().into());
    }

    /// The number of times and each of them, or the first of infinitely many.
    fn add_times(&mut self, times: &Intervals) {
        let count = times.count();
        self.add(count.map_or(u64::MAX, |count| count as u64));
        let listed = times.iter().take(count.unwrap_or(1));
        listed.for_each(|interval| self.add_time(interval.start));
    }
}

/// The queries of a family; those with a coordinate that is not finite are left out.
pub(crate) fn queries<K: Primitives>(family: Family, count: usize) -> impl Iterator<Item = Query<K>> {
    let mut random = Random(1);
    let mut points = move || -> Points { family(&mut random) };
    (0..count).filter_map(move |_| {
        let [start, end] = points();
        Query::new(start, end).ok()
    })
}

/// The digest of the verdicts, contact times and impacts of a family.
pub(crate) fn digest<K: Primitives>(family: Family, count: usize) -> u64 {
    let mut digest = Digest(0xcbf2_9ce4_8422_2325);
    for query in queries::<K>(family, count) {
        digest.add(exact::collides(&query, CONTACT).into());
        digest.add_times(&exact::intervals(&query, CONTACT));
        let impact = exact::impact(&query, CONTACT);
        digest.add(impact.is_some().into());
        if let Some(impact) = impact {
            digest.add_time(impact.time);
            impact.parameters.into_iter().for_each(|x| digest.add_number(x));
            digest.add(impact.normal.is_some().into());
            impact.normal.iter().flatten().for_each(|&x| digest.add_number(x));
        }
    }
    digest.0
}

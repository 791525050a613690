//! Answers in one number, down to the last bit.

use exact_ccd::{ContactTime, Impact, Intervals, Kind, Query, Separation};

/// A hash after Fowler, Noll and Vo.
pub struct Digest(pub u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// Adds eight bytes.
    pub fn add(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// Adds the bits of a number.
    pub fn add_number(&mut self, x: f64) {
        self.add(x.to_bits());
    }

    /// Adds the f64 below a time, and whether it is the time.
    pub fn add_time(&mut self, time: ContactTime) {
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

    /// Adds the number of intervals and both ends of each.
    pub fn add_intervals(&mut self, intervals: &Intervals) {
        self.add(intervals.len() as u64);
        for interval in intervals.iter() {
            self.add_time(interval.start);
            self.add_time(interval.end);
            self.add(interval.is_moment.into());
        }
    }

    /// Adds the time, the parameters and the normal of an impact, if there is one.
    pub fn add_impact(&mut self, impact: Option<Impact>) {
        self.add(impact.is_some().into());
        if let Some(impact) = impact {
            self.add_time(impact.time);
            impact.parameters.into_iter().for_each(|x| self.add_number(x));
            self.add(impact.normal.is_some().into());
            impact.normal.iter().flatten().for_each(|&x| self.add_number(x));
        }
    }

    /// The verdict, contact times and impact of the exact path.
    pub fn add_exact_answers<K: Kind>(&mut self, query: &Query<K>, d: Separation) {
        self.add(query.exactly().collides(d).into());
        self.add_times(&query.exactly().intervals(d));
        self.add_impact(query.exactly().impact(d));
    }
}

//! The answer of a search.

/// Two times of a step: before the first, two curved primitives are certainly more than d apart; by the
/// second, they certainly come within d, or near to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The distance is certainly above d at all times before this one. If [`end`](Self::end) is
    /// [`End::Free`], it is above d until the last time that counts, that time included.
    pub free_until: f64,
    /// The earliest time by which a small distance has been proved, if there is one.
    pub within: Option<Within>,
    /// The reason why the search ended.
    pub end: End,
    /// The number of chords that were examined.
    pub chords: usize,
}

/// A time by which two curved primitives have certainly been near each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    /// The distance is small at some time that is not after this one. It may exceed the last time that
    /// counts, by at most the tolerance of times.
    pub by: f64,
    /// The meaning of small.
    pub proximity: Proximity,
}

/// A distance that was proved to be small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Proximity {
    /// At most d.
    Contact,
    /// At most d + ε, where ε is the tolerance of distances.
    Near,
}

/// The reason why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum End {
    /// All is free until the last time that counts.
    Free,
    /// The gap between the free times and the proved proximity is within the tolerance of times.
    Tolerance,
    /// The number of chords reached its limit. The free times are certain.
    ChordLimit,
    /// The chord at the end of the free times lasts 2⁻⁵³, and a shorter one would not be more precise: the
    /// tolerances are too small for the errors of the positions. The free times are certain.
    Precision,
}

impl Answer {
    /// The answer before the first chord.
    pub(crate) fn initial(free_until: f64) -> Self {
        Self {
            free_until,
            within: None,
            end: End::Free,
            chords: 0,
        }
    }

    /// Returns true if the distance is certainly above d until the last time that counts.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.end == End::Free
    }
}

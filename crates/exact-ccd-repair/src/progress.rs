//! The state of a repair between two rounds.

/// The phase of a repair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// Vertices move until nothing intersects.
    Loosen,
    /// Vertices move apart until no pair is within the minimum distance.
    Separate,
    /// Vertices return towards the given positions and the given shape, by certified steps.
    Return,
    /// In a recording, vertices follow the given frames. A round is a frame.
    Follow,
}

/// The state of a repair between two rounds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// The phase.
    pub phase: Phase,
    /// The number of rounds of this phase so far.
    pub round: usize,
    /// The pairs of an edge and a face that intersect, or the pairs within the minimum distance; 0 in the
    /// return, and from frame to frame of a recording.
    pub pairs: usize,
}

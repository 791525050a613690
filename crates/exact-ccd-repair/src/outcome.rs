//! The outcome of a repair.

use std::fmt;

use exact_ccd_mesh::{Intersection, Pair, Point};

use crate::change::Change;
use crate::progress::Phase;

/// The outcome of a repair.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The mesh is free of intersections and of contact at rest.
    Repaired(Repaired),
    /// It is not.
    Unrepaired(Unrepaired),
}

/// Positions in which a mesh is free.
///
/// No two faces, edges or vertices have more in common than the vertices and edges that they share, see
/// [`Meeting`](exact_ccd_mesh::Meeting), and no pair is within the minimum distance. This was decided
/// exactly, for the positions as they are.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Repaired {
    /// The positions. They have the bits of the given ones if the mesh was free before.
    pub positions: Vec<Point>,
    /// The number of pairs of an edge and a face that crossed before.
    pub crossings: usize,
    /// The number of pairs within the minimum distance before.
    pub contacts: usize,
    /// The change.
    pub change: Change,
}

/// The state at the end of a repair that has not succeeded.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Unrepaired {
    /// The positions with the fewest edges that pass through faces, of all rounds of the phase. They may
    /// intersect.
    pub positions: Vec<Point>,
    /// The edges that pass through faces in these positions; with [`Reason::Pinned`], between pinned vertices
    /// only.
    pub crossings: Vec<Intersection>,
    /// The pairs within the minimum distance in these positions; with [`Reason::Pinned`], between pinned
    /// vertices only.
    pub contacts: Vec<Pair>,
    /// The reason.
    pub reason: Reason,
}

/// The reason why a repair has not succeeded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Reason {
    /// Pinned vertices alone intersect, or are within the minimum distance: the crossings and contacts are
    /// theirs.
    Pinned,
    /// A closed surface has only one side, as a Klein bottle: no positions of it are free. This is proved by
    /// its faces alone, and nothing is moved.
    OneSided {
        /// The first face of the surface.
        face: u32,
    },
    /// A loop of pinned edges passes an odd number of times through a surface whose border is pinned: no
    /// positions of the vertices that can move are free. This is proved, and nothing is moved.
    Linked {
        /// An edge of the loop.
        edge: u32,
        /// A face of the surface through which the loop passes.
        face: u32,
    },
    /// The number of crossings has not become less in 400 rounds. The mesh may have free positions far away,
    /// or none at all; its faces alone do not exclude them.
    Stalled,
    /// A phase has had as many rounds as the options allow. The mesh may have no free positions near, or none
    /// at all.
    Rounds(Phase),
    /// Rounding to `f32` brings pairs within the minimum distance, however wide the distance before was.
    Rounding,
    /// The caller has stopped it.
    Stopped(Phase),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let phase = match self {
            Self::Pinned => return write!(f, "vertices that do not move intersect or touch each other"),
            Self::OneSided { face } => {
                return write!(
                    f,
                    "the surface with face {face} is closed and has only one side, as a Klein bottle: it has no \
                     positions without intersections"
                );
            }
            Self::Linked { edge, face } => {
                return write!(
                    f,
                    "a loop of edges that do not move, with edge {edge}, passes through the surface with face \
                     {face}, whose border does not move: no positions of the other vertices are free"
                );
            }
            Self::Stalled => {
                return write!(
                    f,
                    "the number of crossings has stopped falling: free positions are far away, or there are \
                     none; the faces alone do not exclude them"
                );
            }
            Self::Rounding => return write!(f, "rounding to f32 makes pairs touch again"),
            Self::Rounds(phase) => {
                write!(f, "the limit of rounds was reached")?;
                phase
            }
            Self::Stopped(phase) => {
                write!(f, "it was stopped")?;
                phase
            }
        };
        write!(
            f,
            " while {}",
            match phase {
                Phase::Loosen => "pairs still intersected",
                Phase::Separate => "pairs were still within the minimum distance",
                Phase::Return => "vertices returned to their places",
                Phase::Follow => "vertices followed the frames",
            }
        )
    }
}

//! Root parity as a method of continuous collision detection.

use exact_ccd::{Decide, Kind, Point, Query};

use super::{Displacement, Rounded};

/// Root parity on rounded input: the decision of Algorithm 1 of the paper.
///
/// A query is first shifted by the displacement of a scene, if there is one, so that a point that two
/// queries share stays the same point. Then it is shifted by its own displacement, which is zero on the
/// axes on which its corner differences are exact.
///
/// # False negatives and false positives
/// An even number of contacts is not distinguished from none. The answer is right for the rounded query:
/// the query itself may be in contact where the rounded one is not, and vice versa. A query that is too
/// large to be rounded counts as a collision.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RootParity {
    displacement: Displacement,
}

impl RootParity {
    /// Root parity for the queries of a scene, with the displacement of its box: see
    /// [`Displacement::of_box`].
    #[must_use]
    pub fn in_scene(displacement: Displacement) -> Self {
        Self { displacement }
    }
}

impl<K: Kind<Points = [Point; 4]>> Decide<K> for RootParity {
    fn collides(&self, query: &Query<K>) -> bool {
        let shifted = self.displacement.shift(query);
        let rounded = shifted.and_then(|query| Rounded::shift(&query));
        rounded.map_or(true, |rounded| rounded.parity().is_collision())
    }
}

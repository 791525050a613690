//! The intersection of an edge and a face at rest.

use core::cmp::Ordering::{self, Equal};

use super::orient3d::sign_of_volume;
use crate::query::{NonFinite, Query};
use crate::tables::{EdgeEdge, Point, VertexFace};
use crate::values::CONTACT;

/// An edge a b and a face v₁ v₂ v₃, at rest. Both are closed: their ends and sides belong to them.
///
/// Any finite coordinates are allowed. An edge without length is a point, and a face without area
/// is the union of its sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeFace {
    edge: [Point; 2],
    face: [Point; 3],
}

impl EdgeFace {
    /// An edge by its ends and a face by its corners.
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is infinite or not a number; the corners of
    /// the face are points 2 to 4.
    pub fn new(edge: [Point; 2], face: [Point; 3]) -> Result<Self, NonFinite> {
        let ([a, b], [v1, v2, v3]) = (edge, face);
        NonFinite::check(&[&[a, b, v1, v2, v3]])?;
        Ok(Self { edge, face })
    }

    /// Returns true if the edge and the face have a common point.
    ///
    /// If the ends are on different sides of the face's plane, or one of them is in it, the edge meets
    /// the plane in one point, whose barycentric coordinates are proportional to the volumes that the
    /// edge spans with the sides: it lies in the face unless two of them have opposite signs. If both
    /// are in the plane, an edge that touches no side lies inside of the face as a whole, or outside.
    /// If the face has no area, it is the union of its sides. These cases are queries that do not move.
    ///
    /// ```
    /// use exact_ccd::predicates::EdgeFace;
    ///
    /// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let through = |x: f64| EdgeFace::new([[x, 0.5, -1.0], [x, 0.5, 1.0]], face);
    /// assert!(through(0.25)?.intersects());
    /// assert!(through(0.5)?.intersects()); // through the rim
    /// assert!(!through(0.5_f64.next_up())?.intersects());
    /// # Ok::<(), exact_ccd::NonFinite>(())
    /// ```
    #[must_use]
    pub fn intersects(&self) -> bool {
        let ([a, b], [v1, v2, v3]) = (self.edge, self.face);
        let height = |p| sign_of_volume(&[v1, v2, v3, p]);
        match (height(a), height(b)) {
            (Equal, Equal) => self.contains(a) || self.touches_a_side(),
            (above, below) if above == below => false,
            _ => {
                let side = |x, y| sign_of_volume(&[a, b, x, y]);
                agree([side(v1, v2), side(v2, v3), side(v3, v1)])
            }
        }
    }

    /// Returns true if a point lies in the face.
    fn contains(&self, point: Point) -> bool {
        let [v1, v2, v3] = self.face;
        Query::<VertexFace>::from_finite([[point, v1, v2, v3]; 2]).collides(CONTACT)
    }

    /// Returns true if a side of the face touches the edge.
    fn touches_a_side(&self) -> bool {
        let ([a, b], [v1, v2, v3]) = (self.edge, self.face);
        let touches =
            |[x, y]: [Point; 2]| Query::<EdgeEdge>::from_finite([[a, b, x, y]; 2]).collides(CONTACT);
        [[v1, v2], [v2, v3], [v3, v1]].into_iter().any(touches)
    }
}

/// Returns true if no two signs are opposite.
fn agree(signs: [Ordering; 3]) -> bool {
    !(signs.contains(&Ordering::Less) && signs.contains(&Ordering::Greater))
}

//! Faces of a file, each with three or more corners, as triangles.

use crate::error::{Fault, ParseError, Place};

/// The faces of a file as triangles, in the order of the file.
///
/// A triangle keeps the order of its corners. A face with more corners becomes a fan from its
/// lowest vertex. The fan does not depend on the corner at which the file begins the face, so that
/// frames in which programs begin faces at different corners still are frames of one mesh.
#[derive(Clone, Debug, Default)]
pub(super) struct Faces {
    /// The number of the first face in errors: 0 or, where the format counts from there, 1.
    pub(super) first: usize,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The number of faces in the file.
    pub(super) count: usize,
    /// The number of faces with more than three corners.
    pub(super) polygons: usize,
    /// The first face with more than three corners, as the error where only triangles are allowed.
    pub(super) first_polygon: Option<ParseError>,
    /// The face of each triangle, from the first polygon on. Until then, every triangle is a face.
    ids: Vec<u32>,
}

impl Faces {
    /// Triangles only.
    pub(super) fn of(triangles: Vec<[u32; 3]>) -> Self {
        let count = triangles.len();
        Self {
            triangles,
            count,
            ..Self::default()
        }
    }

    /// No triangles, and the number of faces in the file.
    pub(super) fn without_triangles(self) -> Self {
        Self {
            count: self.count,
            ..Self::default()
        }
    }

    /// The number in the file of the face to which a triangle belongs.
    pub(super) fn id(&self, triangle: usize) -> u32 {
        self.ids.get(triangle).copied().unwrap_or(triangle as u32)
    }

    /// The number of polygons of which these are the ids of triangles, at least one of each, in order.
    pub(super) fn polygons_among(&self, ids: &[Option<u32>]) -> usize {
        let mut kept = ids.iter().flatten().peekable();
        let mut polygons = 0;
        for triangles in self.ids.chunk_by(|a, b| a == b) {
            let is_kept =
                std::iter::from_fn(|| kept.next_if(|&&id| id <= triangles[0])).last() == Some(&triangles[0]);
            polygons += usize::from(is_kept && triangles.len() > 1);
        }
        polygons
    }

    /// Adds the next face.
    ///
    /// # Errors
    /// For fewer than three corners.
    pub(super) fn add(&mut self, corners: &[u32], place: impl FnOnce() -> Place) -> Result<(), ParseError> {
        let (index, count) = (self.count, corners.len());
        let face = self.first + index;
        self.count += 1;
        match *corners {
            [a, b, c] => {
                self.triangles.push([a, b, c]);
                if self.polygons > 0 {
                    self.ids.push(index as u32);
                }
            }
            [_, _, _, ..] => {
                if self.polygons == 0 {
                    self.ids = (0..index as u32).collect();
                }
                self.polygons += 1;
                self.ids.extend(std::iter::repeat_n(index as u32, count - 2));
                self.first_polygon
                    .get_or_insert_with(|| Fault::Polygon { face, corners: count }.at(place()));
                self.triangles.extend(fan(corners));
            }
            _ => {
                let corners = count as i64;
                return Err(Fault::Corners { face, corners }.at(place()));
            }
        }
        Ok(())
    }
}

/// The triangles from the first corner of the rotation of a polygon that begins at its lowest
/// vertex.
///
/// If that vertex occurs more than once, it is the rotation that is first in lexicographic order.
pub(super) fn fan(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    let start = least_rotation(corners);
    let corner = move |k: usize| corners[(start + k) % corners.len()];
    (1..corners.len().saturating_sub(1)).map(move |k| [corner(0), corner(k), corner(k + 1)])
}

/// The triangles of a strip: every three consecutive corners, every other triangle the other way round.
///
/// A triangle with a corner twice is left out: such ones join strips, and an edge of theirs may be no edge of
/// the surface.
pub(super) fn strip(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    let triangles = corners.windows(3).enumerate();
    let triangles = triangles.map(|(k, corners)| [corners[0], corners[1 + k % 2], corners[2 - k % 2]]);
    triangles.filter(|[a, b, c]| a != b && b != c && c != a)
}

/// The start of the rotation of a sequence that is first in lexicographic order, in linear time.
///
/// Two candidates are compared element by element. At the first difference, every start that the
/// greater one has passed is no better than the same distance from the other one.
fn least_rotation(corners: &[u32]) -> usize {
    let count = corners.len();
    let at = |k: usize| corners[k % count];
    let (mut best, mut other, mut equal) = (0, 1, 0);
    while best < count && other < count && equal < count {
        match at(best + equal).cmp(&at(other + equal)) {
            std::cmp::Ordering::Equal => equal += 1,
            std::cmp::Ordering::Less => {
                other += equal + 1;
                equal = 0;
            }
            std::cmp::Ordering::Greater => {
                best += equal + 1;
                equal = 0;
            }
        }
        other += usize::from(other == best);
    }
    best.min(other)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_pentagon_is_a_fan_from_its_lowest_vertex() {
        let triangles: Vec<_> = fan(&[7, 4, 9, 2, 5]).collect();
        assert_eq!(triangles, [[2, 5, 7], [2, 7, 4], [2, 4, 9]]);
    }

    #[test]
    fn triangles_that_join_strips_are_left_out() {
        let triangles: Vec<_> = strip(&[0, 1, 2, 2, 5, 5, 6, 7]).collect();
        assert_eq!(triangles, [[0, 1, 2], [5, 7, 6]]);
    }

    proptest! {
        #[test]
        fn a_fan_is_the_same_for_every_rotation(
            corners in prop::collection::vec(0..4_u32, 3..12),
            by in any::<prop::sample::Index>(),
        ) {
            let mut rotated = corners.clone();
            rotated.rotate_left(by.index(corners.len()));
            prop_assert!(fan(&corners).eq(fan(&rotated)));
            prop_assert_eq!(fan(&corners).count(), corners.len() - 2);
            let least = (0..corners.len()).map(|k| [&corners[k..], &corners[..k]].concat()).min();
            let start = least_rotation(&corners);
            prop_assert_eq!(Some([&corners[start..], &corners[..start]].concat()), least);
        }
    }
}

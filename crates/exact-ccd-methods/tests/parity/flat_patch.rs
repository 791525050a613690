//! An edge that moves in a plane sweeps a patch with coplanar corners: a quadrilateral that may cross itself
//! or fold back. For any shape, the number of times the edge passes a point equals, mod 2, the number of
//! triangles of a pair that contain the point. The independent count is the number of roots of a quadratic
//! equation.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexFace};
use exact_ccd_methods::parity::{Parity, Rounded};

use crate::plane::{Flat, area, is_in_triangle, is_on_segment, passages};
use exact_ccd_testing::families::small_integers;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::laws::assert_defined;
use exact_ccd_testing::runner::for_all;

/// The signs of (−1)ⁱ Vᵢ, where Vᵢ is the determinant of the corners but the i-th.
type Signs = [i64; 4];

struct Row {
    signs: Signs,
    shape: &'static str,
    /// The triangles of q₀ q₁ q₂ and q₀ q₂ q₃ that can contain a point.
    triangles: &'static [[bool; 2]],
}

const FIRST: [bool; 2] = [true, false];
const SECOND: [bool; 2] = [false, true];
const BOTH: [bool; 2] = [true, true];

#[rustfmt::skip]
const TABLE: [Row; 12] = [
    Row { signs: [1, -1, 1, -1], shape: "convex", triangles: &[FIRST, SECOND] },
    Row { signs: [-1, 1, 1, 1], shape: "reflex at q0", triangles: &[FIRST, SECOND] },
    Row { signs: [1, -1, 1, 1], shape: "reflex at q1", triangles: &[SECOND, BOTH] },
    Row { signs: [1, 1, -1, -1], shape: "q0 q1 crosses q2 q3", triangles: &[FIRST, SECOND, BOTH] },
    Row { signs: [-1, 1, 0, 1], shape: "q0 between q3 and q1", triangles: &[FIRST, SECOND] },
    Row { signs: [1, -1, 1, 0], shape: "q1 between q0 and q2", triangles: &[SECOND] },
    Row { signs: [-1, 1, 1, 0], shape: "q0 between q1 and q2", triangles: &[SECOND] },
    Row { signs: [0, -1, 1, 1], shape: "q1 between q2 and q3", triangles: &[SECOND, BOTH] },
    Row { signs: [1, -1, 0, 0], shape: "q0 = q1", triangles: &[SECOND] },
    Row { signs: [1, 0, -1, 0], shape: "q0 = q2", triangles: &[] },
    Row { signs: [0, 1, 0, -1], shape: "q1 = q3", triangles: &[BOTH] },
    Row { signs: [0, 0, 0, 0], shape: "on one line", triangles: &[] },
];

impl Row {
    /// The signs and the triangles when q₀ and q₂ are swapped, or q₁ and q₃, and with the other
    /// orientation.
    fn images(&self) -> [(Signs, BTreeSet<[bool; 2]>); 8] {
        let [a, b, c, d] = self.signs;
        let same = BTreeSet::from_iter(self.triangles.iter().copied());
        let swapped = same.iter().map(|&[first, second]| [second, first]).collect();
        let images = [
            ([a, b, c, d], &same),
            ([c, b, a, d], &same),
            ([a, d, c, b], &swapped),
            ([c, d, a, b], &swapped),
        ];
        let image = |i: usize| {
            let (signs, triangles) = images[i % 4];
            (
                if i < 4 { signs } else { signs.map(|sign| -sign) },
                triangles.clone(),
            )
        };
        [0, 1, 2, 3, 4, 5, 6, 7].map(image)
    }
}

fn signs([q0, q1, q2, q3]: [Flat; 4]) -> Signs {
    let areas = [[q1, q2, q3], [q0, q3, q2], [q0, q1, q3], [q0, q2, q1]].map(area);
    areas.map(i64::signum)
}

/// All patches with corners at small integers.
fn patches() -> impl Iterator<Item = [Flat; 4]> {
    (0..5i64.pow(8)).map(|index| {
        let coordinate = |digit: u32| index / 5i64.pow(digit) % 5 - 2;
        [0, 2, 4, 6].map(|digit| [coordinate(digit), coordinate(digit + 1)])
    })
}

fn has_origin_on_side(patch: [Flat; 4]) -> bool {
    (0..4).any(|i| is_on_segment(patch[i], patch[(i + 1) % 4]))
}

/// True for each of the two triangles along a diagonal that contains the origin; `None` if it is on
/// the diagonal.
fn along_diagonal([q0, q1, q2, q3]: [Flat; 4]) -> Option<[bool; 2]> {
    (!is_on_segment(q0, q2)).then(|| [[q0, q1, q2], [q0, q2, q3]].map(is_in_triangle))
}

#[test]
fn has_a_row_in_the_table() {
    let mut table = BTreeMap::new();
    for (row, (signs, triangles)) in TABLE
        .iter()
        .flat_map(|row| row.images().map(|image| (row, image)))
    {
        let earlier = table.insert(signs, (row.shape, triangles.clone()));
        assert!(
            earlier.is_none_or(|earlier| earlier == (row.shape, triangles)),
            "{signs:?}"
        );
    }
    // The patch is flat: the sum of the numbers is zero.
    for index in 0..3i64.pow(4) {
        let signs = [0, 1, 2, 3].map(|digit| index / 3i64.pow(digit) % 3 - 1);
        let may_sum_to_zero = signs.contains(&1) == signs.contains(&-1);
        assert_eq!(table.contains_key(&signs), may_sum_to_zero, "{signs:?}");
    }

    let mut found: BTreeMap<Signs, BTreeSet<[bool; 2]>> = BTreeMap::new();
    for patch in patches().filter(|patch| !has_origin_on_side(*patch)) {
        let triangles = found.entry(signs(patch)).or_default();
        triangles.extend(along_diagonal(patch).filter(|inside| *inside != [false; 2]));
    }
    assert_eq!(found.len(), table.len());
    for (signs, (shape, triangles)) in table {
        assert_eq!(found[&signs], triangles, "{shape}: {signs:?}");
    }
}

#[test]
fn is_passed_as_often_as_the_triangles_of_either_diagonal() {
    for patch in patches().filter(|patch| !has_origin_on_side(*patch)) {
        let [q0, q1, q2, q3] = patch;
        for diagonal in [[q0, q1, q2, q3], [q1, q2, q3, q0]] {
            if let Some([first, second]) = along_diagonal(diagonal) {
                assert_eq!(first ^ second, passages(patch) % 2 == 1, "{patch:?}");
            }
        }
    }
}

/// Queries in which an edge moves from q₀ q₃ to q₁ q₂, with contact when it passes the origin of
/// the plane. The plane is tilted, so that bounding boxes do not separate.
fn are_passed<K: Kind<Points = [Point; 4]>>(query: impl Fn([Point; 4]) -> Query<K>) {
    for patch in patches() {
        let corners = patch.map(|[y, z]| [3 * y - 4 * z, y, z].map(|x| x as f64));
        let rounded = Rounded::check(query(corners)).unwrap();
        let expected = match passages(patch) % 2 {
            _ if has_origin_on_side(patch) => Parity::Boundary,
            0 => Parity::Even,
            _ => Parity::Odd,
        };
        assert_eq!(rounded.parity(), expected, "{patch:?}");
    }
}

const FRONT: Point = [1.0, 0.0, 0.0];
const BACK: Point = [-1.0, 0.0, 0.0];

/// The vertex is behind the plane, and the third corner of the face further behind.
#[test]
fn is_passed_by_the_edge_of_a_face() {
    are_passed(|[q0, q1, q2, q3]| {
        let apex = [-2.0, 0.0, 0.0];
        Query::<VertexFace>::new([BACK, q0, q3, apex], [BACK, q1, q2, apex]).unwrap()
    });
}

#[test]
fn is_passed_by_an_edge() {
    are_passed(|[q0, q1, q2, q3]| {
        Query::<EdgeEdge>::new([FRONT, BACK, q0, q3], [FRONT, BACK, q1, q2]).unwrap()
    });
}

/// The parity agrees with the definition for edges among small integers. The side of the domain
/// along which the first ends of both edges move is a patch with every combination of signs, flat
/// or not.
#[test]
fn has_all_signs() {
    let found = RefCell::new(BTreeMap::<Signs, u32>::new());
    for_all(60_000, small_integers(1), |points| {
        let rounded = Rounded::check(query::<EdgeEdge>(&points)).unwrap();
        assert_defined(&rounded);
        let corner = |time: usize, b: usize| {
            [0, 1, 2].map(|axis| (points[time][0][axis] - points[time][b][axis]) as i64)
        };
        let corners = [corner(0, 2), corner(0, 3), corner(1, 3), corner(1, 2)];
        *found.borrow_mut().entry(signs_in_space(corners)).or_default() += 1;
    });
    let found = found.into_inner();
    assert_eq!(found.len(), 81);
    assert!(found.values().all(|&count| count >= 10), "{found:?}");
}

/// The signs of V₀, −V₁, V₂ and −V₃.
fn signs_in_space([q0, q1, q2, q3]: [[i64; 3]; 4]) -> Signs {
    let determinant = |[a, b, c]: [[i64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    [[q1, q2, q3], [q0, q3, q2], [q0, q1, q3], [q0, q2, q1]].map(|corners| determinant(corners).signum())
}

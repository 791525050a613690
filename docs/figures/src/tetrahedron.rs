//! A bilinear patch in its tetrahedron, four positions of the origin, and the two triangles that
//! replace the patch.

use exact_ccd::Point;

use crate::drawing::Drawing;
use crate::patch::Patch;
use crate::space::View;
use crate::vectors::minus;

/// The corners of the patch.
const CORNERS: [Point; 4] = [
    [-3.0, -1.0, 1.5],
    [1.0, -4.0, -1.5],
    [3.0, 1.0, 1.5],
    [-1.0, 4.0, -1.5],
];

pub(crate) type Pair = [[usize; 3]; 2];

/// The faces of the tetrahedron at the diagonal q₀ q₂, and the faces at q₁ q₃.
pub(crate) const AROUND_02: Pair = [[0, 2, 3], [0, 1, 2]];
pub(crate) const AROUND_13: Pair = [[1, 2, 3], [0, 1, 3]];

/// Positions of the origin, each with a pair of triangles that replaces the patch.
const PANELS: [(&str, Point, Pair, &str); 4] = [
    ("outside, even", [-5.0, 0.0, 0.5], AROUND_02, "either pair"),
    ("outside, odd", [-5.0, -1.0, 0.5], AROUND_13, "either pair"),
    (
        "inside, above the patch",
        [0.5, -0.5, 0.5],
        AROUND_13,
        "the pair on which φ ≤ 0",
    ),
    (
        "inside, below the patch",
        [0.0, 0.0, -0.5],
        AROUND_02,
        "the pair on which φ ≥ 0",
    ),
];

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new("The origin and a bilinear patch in its tetrahedron", [960, 460]);
    for (column, panel) in (0u8..).zip(PANELS) {
        draw_panel(&mut drawing, 240.0 * f64::from(column), panel);
    }
    drawing.finish()
}

fn draw_panel(drawing: &mut Drawing, left: f64, (name, origin, pair, which): (&str, Point, Pair, &str)) {
    let corners = CORNERS.map(|corner| minus(corner, origin));
    let patch = Patch(corners);
    let [v0, v1, v2, v3] = patch.volumes();
    let signs = format!("signs of V₀, −V₁, V₂, −V₃: {}", patch.signs());
    let phi = format!("V₀V₂ − V₁V₃ = {}", v0 * v2 - v1 * v3);
    drawing.text("bold", [left + 12.0, 24.0], name);
    drawing.text("small", [left + 12.0, 44.0], &signs);
    drawing.text("small", [left + 12.0, 62.0], &phi);

    let triangles = triangles(corners, pair).map(|triangle| ("pair", triangle));
    let rows = [
        (140.0, 8, vec![("side", patch)], "the patch"),
        (330.0, 1, triangles.to_vec(), which),
    ];
    for (top, cuts, patches, name) in rows {
        // All panels have the same tetrahedron and different origins.
        let fixed = View {
            center: [left + 128.0, top],
            scale: 22.0,
            away: [0.2, 0.45],
        };
        let view = View {
            center: fixed.see(origin),
            ..fixed
        };
        view.draw_patches(drawing, cuts, &patches);
        draw_edges(drawing, &view, corners);
        let crossings: Vec<_> = patches.iter().flat_map(|(_, patch)| patch.crossings()).collect();
        let text = format!("{name}: crossings {}", crossings.len());
        view.draw_ray(drawing, "green", 4.5 - origin[0], crossings);
        drawing.text("small", [left + 12.0, top + 110.0], &text);
    }
}

/// A triangle is a patch with one corner twice.
fn triangles(corners: [Point; 4], pair: Pair) -> [Patch; 2] {
    pair.map(|[i, j, k]| Patch([corners[i], corners[j], corners[k], corners[k]]))
}

/// The edges of the tetrahedron and the names of its corners.
fn draw_edges(drawing: &mut Drawing, view: &View, corners: [Point; 4]) {
    let [q0, q1, q2, q3] = view.see_all(corners);
    drawing.line("thin dashed", &[q0, q2]);
    drawing.line("thin dashed", &[q1, q3]);
    drawing.line("thin", &[q0, q1, q2, q3, q0]);
    let names = [
        ("q₀", q0, [0.0, -6.0]),
        ("q₁", q1, [0.0, 14.0]),
        ("q₂", q2, [0.0, -6.0]),
        ("q₃", q3, [-10.0, 14.0]),
    ];
    for (name, [x, y], [right, down]) in names {
        drawing.text("small middle", [x + right, y + down], name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pair_is_crossed_as_often_as_the_patch_mod_2() {
        for (name, origin, pair, _) in PANELS {
            let corners = CORNERS.map(|corner| minus(corner, origin));
            let with_pair: usize = triangles(corners, pair)
                .iter()
                .map(|patch| patch.crossings().len())
                .sum();
            assert_eq!(with_pair % 2, Patch(corners).crossings().len() % 2, "{name}");
        }
    }
}

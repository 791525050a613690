//! The size of pages.

use exact_ccd_mesh::{Step, TriangleMesh};
use exact_ccd_view::Page;

use crate::html::Html;

/// A page of 180,000 faces is at most 1.5 times as large as its indices and positions in binary.
#[test]
fn a_large_page_is_little_more_than_its_data() {
    let n = 300_u32;
    let row = n + 1;
    let squares = (0..n).flat_map(|i| (0..n).map(move |j| i * row + j));
    let faces: Vec<_> = squares
        .flat_map(|v| [[v, v + row, v + row + 1], [v, v + row + 1, v + 1]])
        .collect();
    // Every bit of the positions varies, and all vertices move.
    let place = |phase: f64| {
        (0..row * row).map(move |v| {
            let [x, y] = [v / row, v % row].map(|k| f64::from(k) / 7.3 + phase);
            [
                x + 0.1 * (y * 3.7).sin(),
                y + 0.1 * (x * 5.1).cos(),
                (x * y + phase).sin(),
            ]
        })
    };
    let [x0, x1]: [Vec<_>; 2] = [place(0.0), place(0.3)].map(Iterator::collect);
    let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
    assert_eq!(mesh.faces().len(), 180_000);
    let html = Html::of(&Page::of_step("large", Step::new(&mesh, &x0, &x1).unwrap(), &[], &[]).unwrap());
    let binary = 4 * 3 * (mesh.faces().len() + x0.len() + x1.len());
    assert!(
        html.0.len() < binary * 3 / 2,
        "{} bytes for {binary}",
        html.0.len()
    );
}

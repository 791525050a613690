//! Continuous collision detection by any method.

use ccd_mesh::{Bounds, Point, TriangleMesh};
use ccd_sim::contact::{Pairs, Surface};
use ccd_sim::filter::{self, Increment};

/// A vertex that falls through a triangle at t = ¾.
fn falling() -> (Surface, [Vec<Point>; 2]) {
    let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    let at = |height: f64| {
        vec![
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 4.0, 0.0],
            [1.0, 1.0, height],
            [1.0, 1.2, height + 9.0],
            [1.2, 1.0, height + 9.0],
        ]
    };
    (Surface::new(mesh, vec![false; 6]), [at(3.0), at(-1.0)])
}

fn room() -> Bounds {
    [[-9.0; 3], [19.0; 3]].into_iter().collect()
}

#[test]
fn every_method_stops_short_of_the_contact() {
    let (surface, [start, end]) = falling();
    let pairs = Pairs::near(&surface, &start, &end, 0.0);
    let increment = Increment::new(&surface, &pairs, &start, &end);
    let names = filter::names();
    assert_eq!(names[..3], ["exact", "bisection", "parity"]);
    assert!(names.len() >= 11);
    for name in names {
        let filter = filter::by_name(&name, room()).unwrap();
        assert_eq!(filter.name(), name);
        let size = filter.largest(&increment);
        assert!((0.5..=0.75).contains(&size), "{name}: {size}");
        assert!(!filter.is_free(&increment, &end), "{name}");
        assert!(filter.is_free(&increment, &increment.at(0.5)), "{name}");
        // Only as far as it is free.
        let short = Increment::new(&surface, &pairs, &start, &start);
        assert_eq!(filter.largest(&short), 1.0, "{name}");
    }
}

#[test]
fn the_exact_filter_stops_at_the_time_of_impact() {
    let (surface, [start, end]) = falling();
    let pairs = Pairs::near(&surface, &start, &end, 0.0);
    let increment = Increment::new(&surface, &pairs, &start, &end);
    let size = filter::by_name("exact", room()).unwrap().largest(&increment);
    assert_eq!(size, 0.75);
}

/// Obstacles do not meet each other.
#[test]
fn two_obstacles_are_no_pair() {
    let (surface, [start, end]) = falling();
    let all = Pairs::near(&surface, &start, &end, 0.0);
    assert!(all.vertex_face.contains(&[3, 0]));
    let obstacles = Surface::new(surface.mesh().clone(), vec![true; 6]);
    assert!(Pairs::near(&obstacles, &start, &end, 0.0).is_empty());
    let half = Surface::new(
        surface.mesh().clone(),
        vec![true, true, true, false, false, false],
    );
    assert_eq!(Pairs::near(&half, &start, &end, 0.0), all);
}

#[test]
fn pairs_within_a_distance_are_near() {
    let (surface, [start, _]) = falling();
    assert!(Pairs::near(&surface, &start, &start, 2.9).is_empty());
    assert!(!Pairs::near(&surface, &start, &start, 3.1).is_empty());
}

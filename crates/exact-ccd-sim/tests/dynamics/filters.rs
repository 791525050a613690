//! All filters of the line search.

use exact_ccd_mesh::{Aabb, Point, TriangleMesh};
use exact_ccd_sim::contact::{Pairs, Surface};
use exact_ccd_sim::filter::{self, Increment};
use exact_ccd_sim::{Body, BodyKind, Settings, ShellProperties, Simulation, System};

/// A vertex that passes through a triangle at t = ¾.
fn falling() -> (Surface, [Vec<Point>; 2]) {
    falling_to(-1.0)
}

/// A vertex that falls from the height 3 to the height `end`, with a triangle at the height 0.
fn falling_to(end: f64) -> (Surface, [Vec<Point>; 2]) {
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
    (Surface::new(mesh, vec![false; 6]), [at(3.0), at(end)])
}

fn room() -> Aabb {
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
        // A step without motion is free.
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

/// A motion that ends in contact is not free, and its step size is below 1.
#[test]
fn a_contact_at_the_end_counts() {
    for height in [0.0, -f64::MIN_POSITIVE] {
        let (surface, [start, end]) = falling_to(height);
        let pairs = Pairs::near(&surface, &start, &end, 0.0);
        let increment = Increment::new(&surface, &pairs, &start, &end);
        for name in filter::names() {
            let filter = filter::by_name(&name, room()).unwrap();
            let is_free = filter.is_free(&increment, &end);
            // Some methods miss this contact. Their step size and their decision agree.
            assert_eq!(filter.largest(&increment) == 1.0, is_free, "{name}");
            assert!(!is_free || !["exact", "bisection"].contains(&&*name), "{name}");
        }
    }
}

/// The line search takes no step that ends in contact. Without contact, the falling vertex would end exactly
/// on the slope.
#[test]
fn no_step_ends_in_contact() {
    let corners = [[-10.0, -1.0, -7.0], [11.0, 3.0, -6.0], [-1.0, -2.0, 13.0]];
    let material = ShellProperties {
        density: 1.5,
        // The material is so soft that the vertices move independently.
        young: 1e-30,
        poisson: 0.25,
        thickness: 0.5,
    };
    let falling = Body {
        points: vec![[0.0, 3.0, 0.0], [0.0, 7.0, 1.0], [0.0, 7.0, -1.0]],
        kind: BodyKind::Shell {
            faces: vec![[0, 1, 2]],
            material,
        },
        velocity: [0.0, -6.0, 0.0],
    };
    for scale in 1..20 {
        let slope = Body {
            points: corners
                .map(|corner| corner.map(|x| x * f64::from(scale)))
                .to_vec(),
            kind: BodyKind::Obstacle {
                faces: vec![[0, 1, 2]],
            },
            velocity: [0.0; 3],
        };
        let system = System::new(&[falling.clone(), slope], &[]).unwrap();
        let settings = Settings {
            time_step: 0.5,
            gravity: [0.0; 3],
            ..Settings::default()
        };
        let surface = system.surface().clone();
        let mut simulation = Simulation::new(system, settings).unwrap();
        let mut at = simulation.state().positions.clone();
        let mut visit = |positions: &[Point]| {
            assert!(exact_ccd_mesh::step(&surface, &at, positions).unwrap().is_free());
            at = positions.to_vec();
        };
        simulation.step_along(&mut visit).unwrap();
        // The height without contact is 0.
        let height = simulation.state().positions[0][1];
        assert!(height > 0.0 && height < 1.0, "{height}");
    }
}

#[test]
fn primitives_of_two_obstacles_are_no_candidates() {
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

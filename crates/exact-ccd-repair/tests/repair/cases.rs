//! Generated cases by kind. All have free positions, at least 95 % of them are repaired, and each result is
//! free by the search of the crate, over all pairs, and by the checker's proof.

use exact_ccd_certify::Maker;
use exact_ccd_check::ply::Frame;
use exact_ccd_check::{Mesh, check};
use exact_ccd_mesh::{CONTACT, Point};
use exact_ccd_repair::{Outcome, RepairOptions, repair};

use crate::shapes::{Body, bar, boxed, grid, joined, knot, limb, sleeve, sphere, torus, twisted_strip};
use crate::{is_free, is_free_by_brute_force};

/// A case: its name, the mesh, and the number of its first vertices that are pinned.
type Case = (String, Body, usize);

fn free(name: String, body: Body) -> Case {
    (name, body, 0)
}

/// Tubes around knots that are thicker than the knot leaves room for.
fn knots() -> impl Iterator<Item = Case> {
    let windings = [
        ([2.0, 3.0], 0.44),
        ([2.0, 3.0], 0.48),
        ([2.0, 5.0], 0.42),
        ([3.0, 2.0], 0.4),
    ];
    windings
        .into_iter()
        .map(|(winding, radius)| free(format!("knot {winding:?} {radius}"), knot(winding, 64, radius)))
}

fn strips() -> impl Iterator<Item = Case> {
    let strips = [(60, 1.0, 0.3), (60, 2.0, 0.4), (60, 3.0, 0.4), (60, 1.5, 0.5)];
    strips.into_iter().map(|(m, twist, width)| {
        free(
            format!("strip of {twist} turns, {width} wide"),
            twisted_strip(m, 4, twist, width),
        )
    })
}

fn boxes() -> impl Iterator<Item = Case> {
    let places = [
        [0.7, 0.33, 0.21],
        [0.9, 0.1, 0.05],
        [0.5, 0.6, 0.7],
        [0.8, -0.4, 0.13],
    ];
    let shifted = |place: Point| {
        let both = joined([boxed(3, 1.0), boxed(3, 0.8).tilted(0.2).moved(place)]);
        free(format!("boxes {place:?}"), both)
    };
    places.into_iter().map(shifted)
}

fn cloths() -> impl Iterator<Item = Case> {
    let cloths = [(0.3, 0.0), (0.2, 0.1), (0.33, -0.2), (-0.25, 0.05)];
    cloths.into_iter().map(|(height, angle)| {
        let cloth = grid(12, 1.6).moved([-0.83, -0.77, 0.0]).tilted(angle);
        let both = joined([sphere(6, 0.4), cloth.moved([0.0, 0.0, height])]);
        free(format!("cloth through a ball at {height}, {angle}"), both)
    })
}

/// Tubes over a bent limb that is thicker than they are, or not in their middle.
fn garments() -> impl Iterator<Item = Case> {
    let sleeves = [
        (0.34, 0.6, 0.05),
        (0.31, 0.5, 0.1),
        (0.36, 0.8, 0.0),
        (0.4, 0.9, 0.12),
    ];
    sleeves
        .into_iter()
        .enumerate()
        .map(|(index, (radius, height, off))| {
            let body = limb(20, 10);
            let pinned = if index % 2 == 0 { body.positions.len() } else { 0 };
            let worn = sleeve(8, 12, radius, height).moved([off, 0.03, 0.6]);
            (format!("sleeve of radius {radius}"), joined([body, worn]), pinned)
        })
}

fn stacks() -> impl Iterator<Item = Case> {
    [0.02, 0.05, 0.08, 0.12].into_iter().map(|angle| {
        let sheet = |angle: f64, place: Point| grid(7, 1.0).tilted(angle).moved(place);
        let stack = joined([
            sheet(0.0, [0.0; 3]),
            sheet(angle, [0.013, 0.02, -0.3 * angle]),
            sheet(-angle, [0.03, -0.01, 0.6 * angle]),
            sheet(0.5 * angle, [-0.02, 0.01, -0.2 * angle]),
        ]);
        free(format!("stack of sheets at {angle}"), stack)
    })
}

/// Letters of bars of one thickness, too near to each other.
fn letters() -> impl Iterator<Item = Case> {
    let upright = |place: Point| bar(3, [0.2, 1.0, 0.2]).moved(place);
    let level = |place: Point| bar(3, [0.7, 0.2, 0.2]).moved(place);
    let letters = [
        ("T", joined([level([0.0, 0.93, 0.01]), upright([0.25, 0.0, 0.0])])),
        (
            "L",
            joined([level([0.0, -0.11, 0.013]), upright([0.03, 0.0, 0.0])]),
        ),
        ("I I", joined([upright([0.0; 3]), upright([0.15, 0.03, 0.02])])),
        (
            "H",
            joined([
                upright([0.0; 3]),
                level([0.13, 0.4, 0.01]),
                upright([0.77, 0.02, 0.03]),
            ]),
        ),
    ];
    letters
        .into_iter()
        .map(|(name, body)| free(format!("letter {name}"), body))
}

/// Bolts in rings that are too narrow, or not around the middle of the bolt.
fn bolts() -> impl Iterator<Item = Case> {
    let bolts = [(0.33, 0.0), (0.3, 0.04), (0.28, 0.08), (0.35, -0.05)];
    bolts.into_iter().map(|(thickness, off)| {
        let bolt =
            bar(3, [thickness, thickness, 1.0]).moved([-0.5 * thickness + off, -0.5 * thickness, -0.5]);
        free(
            format!("bolt {thickness} at {off}"),
            joined([torus(16, 6, 0.32, 0.12), bolt]),
        )
    })
}

/// Surfaces that touch exactly, and that were exported several times.
fn touching() -> impl Iterator<Item = Case> {
    let tetrahedra = joined([sphere(2, 0.5), sphere(2, 0.5).moved([1.0, 0.0, 0.0])]);
    let cases = [
        (
            "a sheet exported three times",
            joined([grid(5, 1.0), grid(5, 1.0), grid(5, 1.0)]),
        ),
        ("a ball exported twice", joined([sphere(4, 0.5), sphere(4, 0.5)])),
        ("balls that touch in a point", tetrahedra),
        (
            "bars in one corner",
            joined([bar(2, [1.0, 0.5, 0.5]), bar(2, [0.5, 1.0, 0.25])]),
        ),
        (
            "a box on a sheet",
            joined([grid(6, 2.0), boxed(2, 0.5).moved([0.5, 0.5, 0.0])]),
        ),
        (
            "rings",
            joined([
                torus(16, 6, 1.0, 0.3),
                torus(16, 6, 1.0, 0.3).moved([0.1, 0.2, 0.5]),
            ]),
        ),
        (
            "rings side by side",
            joined([
                torus(16, 6, 1.0, 0.3),
                torus(16, 6, 1.0, 0.3).moved([2.4, 0.1, 0.05]),
            ]),
        ),
        (
            "sheets turned over",
            joined([
                grid(6, 1.0),
                grid(6, 1.0).reversed().tilted(0.1).moved([0.0, 0.01, -0.04]),
            ]),
        ),
    ];
    cases.into_iter().map(|(name, body)| free(name.to_owned(), body))
}

/// Rods through faces.
fn rods() -> impl Iterator<Item = Case> {
    let rod = |from: Point, to: Point, count: usize| -> Vec<Point> {
        let place = |i: usize| {
            let t = i as f64 / count as f64;
            [0, 1, 2].map(|axis: usize| from[axis] + t * (to[axis] - from[axis]))
        };
        (0..=count).map(place).collect()
    };
    let cases = [
        (
            "a rod through a sheet",
            grid(6, 1.0).with_rod(&rod([0.43, 0.52, -0.2], [0.47, 0.49, 0.5], 4)),
        ),
        (
            "a rod of one edge through a sheet",
            grid(6, 1.0).with_rod(&rod([0.43, 0.52, -0.2], [0.47, 0.49, 0.5], 1)),
        ),
        (
            "a rod that ends in a ball",
            sphere(5, 0.5).with_rod(&rod([0.1, 0.05, 0.3], [0.2, 0.1, 1.5], 6)),
        ),
        (
            "a rod through a ball",
            sphere(5, 0.5).with_rod(&rod([0.31, 0.05, -0.7], [0.33, 0.1, 1.1], 6)),
        ),
        (
            "two rods in a sheet",
            grid(6, 1.0)
                .with_rod(&rod([0.2, 0.3, -0.1], [0.25, 0.32, 0.6], 3))
                .with_rod(&rod([0.7, 0.6, -0.5], [0.72, 0.62, 0.15], 3)),
        ),
    ];
    cases.into_iter().map(|(name, body)| free(name.to_owned(), body))
}

/// Bodies in others, and through them.
fn nested() -> impl Iterator<Item = Case> {
    let inner = |radius: f64, place: Point| joined([sphere(6, 1.0), sphere(4, radius).moved(place)]);
    let cases = [
        ("a ball in a ball, and through it", inner(0.3, [0.75, 0.1, 0.05])),
        ("a ball half in a ball", inner(0.3, [0.98, 0.1, 0.05])),
        (
            "a box in a box, with a common corner",
            joined([boxed(3, 1.0), boxed(2, 0.4)]),
        ),
        (
            "a box in a box, with a common side",
            joined([boxed(3, 1.0), boxed(2, 0.4).moved([0.3, 0.2, 0.0])]),
        ),
        (
            "a ring linked with another one",
            joined([
                torus(24, 8, 1.0, 0.3),
                torus(24, 8, 1.0, 0.3).tilted(1.4).moved([0.45, 0.1, 0.05]),
            ]),
        ),
    ];
    cases.into_iter().map(|(name, body)| free(name.to_owned(), body))
}

/// Flat faces that coincide with others, not with the same cells.
fn coincident() -> impl Iterator<Item = Case> {
    let cases = [
        (
            "a sheet in a finer sheet",
            joined([grid(4, 1.0), grid(5, 0.6).moved([0.2, 0.1, 0.0])]),
        ),
        (
            "a sheet in the side of a box",
            joined([boxed(3, 1.0), grid(4, 1.0)]),
        ),
        (
            "boxes on each other",
            joined([boxed(2, 1.0), boxed(3, 1.0).moved([0.0, 0.0, 1.0])]),
        ),
        (
            "a box exported twice with other cells",
            joined([boxed(2, 1.0), boxed(3, 1.0)]),
        ),
    ];
    cases.into_iter().map(|(name, body)| free(name.to_owned(), body))
}

/// The checker accepts the certificate that positions are free at rest.
fn is_proved(body: &Body, x: &[Point]) -> bool {
    let mut maker = Maker::new(CONTACT.separation);
    maker
        .add_step(&body.mesh, [x, x], true, None)
        .expect("the positions fit the mesh");
    let certificate = maker.finish().expect("the mesh is free");
    let mesh = || Mesh::new(x.len(), body.mesh.faces().to_vec(), body.mesh.edges());
    let frame = || {
        mesh().map(|mesh| Frame {
            mesh,
            positions: x.to_vec(),
        })
    };
    check(&certificate, [frame(), frame()]).is_ok_and(|proved| proved.steps[0].head.rest)
}

#[test]
fn generated_cases_are_repaired_and_proved() {
    let cases: Vec<Case> = knots()
        .chain(strips())
        .chain(boxes())
        .chain(cloths())
        .chain(garments())
        .chain(stacks())
        .chain(letters())
        .chain(bolts())
        .chain(touching())
        .chain(rods())
        .chain(nested())
        .chain(coincident())
        .collect();
    assert_eq!(cases.len(), 54);
    let is_free_before = |(name, body, _): &Case| {
        is_free(&body.mesh, &body.positions, CONTACT.separation).then(|| name.clone())
    };
    let free_before: Vec<String> = cases.iter().filter_map(is_free_before).collect();
    assert!(free_before.is_empty(), "free before: {free_before:?}");
    let mut failed = Vec::new();
    for (name, body, pinned) in &cases {
        let separation = CONTACT.separation;
        let options = RepairOptions::default()
            .with_pinned((0..*pinned as u32).collect())
            .with_max_rounds(400);
        let outcome = repair(&body.mesh, &body.positions, &options).expect("the positions fit");
        let x = match &outcome {
            Outcome::Repaired(repaired) => &repaired.positions,
            Outcome::Unrepaired(unrepaired) => {
                failed.push((name, unrepaired.reason));
                continue;
            }
        };
        assert!(is_free(&body.mesh, x, separation), "{name}");
        assert!(is_free_by_brute_force(&body.mesh, x, separation), "{name}");
        assert!(is_proved(body, x), "{name}");
    }
    assert!(20 * failed.len() <= cases.len(), "not repaired: {failed:?}");
}

#[test]
fn knots_and_rings_keep_their_shape() {
    let rings = |place: Point| joined([torus(32, 12, 1.0, 0.3), torus(32, 12, 1.0, 0.3).moved(place)]);
    let bodies = [
        ("a trefoil", knot([2.0, 3.0], 96, 0.46)),
        ("another trefoil", knot([3.0, 2.0], 96, 0.42)),
        ("rings", rings([0.1, 0.2, 0.5])),
        ("rings beside each other", rings([2.4, 0.1, 0.05])),
    ];
    for (name, body) in bodies {
        let options = RepairOptions::default();
        let outcome = repair(&body.mesh, &body.positions, &options).expect("the positions fit");
        let Outcome::Repaired(repaired) = outcome else {
            panic!("{name} has free positions");
        };
        let change = repaired.change;
        assert_eq!(change.folds, 0, "{name}: {change:?}");
        let are_short = change.p95_stretch < 1.05 && change.max_stretch < 1.25;
        assert!(are_short && change.p5_stretch > 0.95, "{name}: {change:?}");
        assert!(
            change.worst_aspect < 2.0 * change.worst_aspect_before,
            "{name}: {change:?}"
        );
    }
}

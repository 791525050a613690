//! Cantilever strips against the theory of plates. All figures are those of `docs/simulation.md`.

mod hinges;
mod mesh;

use crate::{Body, BodyKind, Integrator, Length, Script, Settings, Simulation, System, shapes};
use mesh::{Mesh, Strip};

/// The figures of the documentation are rounded to this.
const ROUNDED: f64 = 1e-3;

/// A strip of 1 m × 0.2 m with square cells, `count` along it.
fn narrow(count: u32) -> Strip {
    Strip {
        cells: [count, count / 5],
        size: [1.0, 0.2],
    }
}

/// A strip of 1 m × 3 m: far from its short edges, it bends as a cylinder.
fn wide(count: u32) -> Strip {
    Strip {
        cells: [count, 3 * count],
        size: [1.0, 3.0],
    }
}

impl Strip {
    /// True for the vertices of the first two columns, which are clamped.
    fn is_clamped(&self, [x, _, _]: [f64; 3]) -> bool {
        x < 1.01 * self.cell()
    }

    /// The mean deflection of the middle of the free end, divided by q L⁴ / (8 D). `deflections` are those of
    /// the vertices, divided by q / D.
    fn relative(&self, mesh: &Mesh, deflections: &[f64]) -> f64 {
        let is_counted = |[x, _, z]: [f64; 3]| {
            x > self.size[0] - 1e-9 && (z - 0.5 * self.size[1]).abs() < 0.101 * self.size[0]
        };
        let counted = mesh.points.iter().zip(deflections);
        let counted: Vec<f64> = counted
            .filter(|(point, _)| is_counted(**point))
            .map(|(_, deflection)| *deflection)
            .collect();
        // The hinges at the clamped edge stand for half of the cells beside them.
        let free = self.size[0] - 0.5 * self.cell();
        counted.iter().sum::<f64>() / counted.len() as f64 / (free.powi(4) / 8.0)
    }

    /// The relative deflection of a strip in a simulation, with a Poisson's ratio.
    fn simulated(&self, mesh: &Mesh, poisson: f64) -> f64 {
        let mut material = shapes::CLOTH;
        material.poisson = poisson;
        let clamped: Vec<u32> = (0..mesh.points.len() as u32)
            .filter(|&vertex| self.is_clamped(mesh.points[vertex as usize]))
            .collect();
        let gravity = 1e-5;
        let faces = mesh.faces.clone();
        let body = Body::new(mesh.points.clone(), BodyKind::Shell { faces, material });
        let system = System::new(&[body], &[Script::Fixed.on(clamped)]).unwrap();
        let settings = Settings {
            time_step: 1e3,
            gravity: [0.0, -gravity, 0.0],
            integrator: Integrator::QuasiStatic,
            contact_distance: Length::Absolute(1e-6),
            tolerance: Length::Absolute(1e-13),
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        for _ in 0..2 {
            assert!(simulation.step().unwrap().converged);
        }
        let rigidity = material.young * material.thickness.powi(3) / (12.0 * (1.0 - poisson * poisson));
        let load = material.density * material.thickness * gravity;
        let positions = simulation.state().positions.iter();
        let deflections: Vec<f64> = positions.map(|point| -point[1] * rigidity / load).collect();
        self.relative(mesh, &deflections)
    }

    /// The relative deflection of a strip of hinges alone.
    fn hinged(&self, mesh: &Mesh) -> f64 {
        let is_clamped = |vertex: u32| self.is_clamped(mesh.points[vertex as usize]);
        self.relative(mesh, &hinges::deflections(mesh, is_clamped))
    }
}

/// The rows of the table of the documentation that begins with this header: their meshes and numbers.
fn table(header: &str) -> Vec<(&'static str, Vec<f64>)> {
    let documentation = include_str!("../../../../../docs/simulation.md");
    let (_, rows) = documentation.split_once(header).unwrap();
    let rows = rows.lines().skip(2).take_while(|line| line.starts_with('|'));
    let cells = |row: &'static str| row.trim_matches('|').split(" | ");
    rows.map(|row| {
        let numbers = cells(row).skip(1).flat_map(|cell| cell.split(','));
        let numbers = numbers.map(|number| number.trim().parse().unwrap());
        (cells(row).next().unwrap().trim(), numbers.collect())
    })
    .collect()
}

#[track_caller]
fn assert_rounded(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < ROUNDED, "{what}: {found}, {expected}");
}

/// With ν = 0, a strip bends as a beam, as wide as it is.
#[test]
fn strips_without_contraction_deflect_as_plates() {
    let rows = table("| mesh | hinges alone, n = 20, 40 | bending energy, n = 20, 40 |");
    assert_eq!(rows.len(), 5);
    for (name, expected) in rows {
        for (place, count) in [20, 40].into_iter().enumerate() {
            let strip = narrow(count);
            let mesh = strip.mesh(name);
            let what = format!("{name}, n = {count}");
            assert_rounded(
                strip.hinged(&mesh),
                expected[place],
                &format!("hinges alone, {what}"),
            );
            let found = strip.simulated(&mesh, 0.0);
            assert_rounded(found, expected[2 + place], &what);
            if count == 40 && name != "shifted points, random diagonals" {
                assert!((found - 1.0).abs() < 0.03, "{what}: {found}");
            }
        }
    }
}

/// With ν = 0.3, the middle of a wide strip bends as a cylinder, of which D = E h³ / (12 (1 − ν²)) is the
/// rigidity. That of a beam is 9 % smaller.
#[test]
fn wide_strips_deflect_as_plates() {
    let rows = table("| mesh, ν = 0.3 | n = 10, 20 |");
    assert_eq!(rows.len(), 4);
    for (name, expected) in rows {
        for (place, count) in [10, 20].into_iter().enumerate() {
            let strip = wide(count);
            let found = strip.simulated(&strip.mesh(name), 0.3);
            assert_rounded(found, expected[place], &format!("{name}, n = {count}"));
            assert!(count == 10 || (found - 1.0).abs() < 0.03, "{name}: {found}");
        }
    }
}

//! Cantilever strips against the theory of plates. All figures are in `docs/simulation/validation.md`.

mod curvatures;
mod hinges;
mod mesh;

use crate::{Body, BodyKind, Integrator, Length, Script, Settings, Simulation, System, shapes};
use curvatures::Plate;
use mesh::{Mesh, Strip};

/// The figures of the documentation are rounded to this.
const ROUNDED: f64 = 1e-3;

/// The deflection of the middle of the free end of a plate with ν = 0.3, divided by q L⁴ / (8 D): of 1 m ×
/// 0.2 m and of 1 m × 3 m. They are computed with a finite element of rectangles (A. Adini and R. Clough,
/// *Analysis of plate bending by the finite element method*, 1960), on 60 × 12 and 16 × 40 cells. The next
/// coarser mesh gives the same four digits.
const NARROW_PLATE: f64 = 0.9752 / (1.0 - 0.3 * 0.3);
const WIDE_PLATE: f64 = 1.0135;

/// A strip of 1 m × 0.2 m.
fn narrow(cells: [u32; 2]) -> Strip {
    let size = [1.0, 0.2];
    Strip { cells, size }
}

/// A strip of 1 m × 3 m: far from its short edges, it bends as a cylinder.
fn wide(cells: [u32; 2]) -> Strip {
    let size = [1.0, 3.0];
    Strip { cells, size }
}

impl Strip {
    /// True for the vertices of the first two columns, which are clamped.
    fn is_clamped(&self, [x, _, _]: [f64; 3]) -> bool {
        x < 1.01 * self.cell()
    }

    /// The mean deflection of the middle of the free end, divided by q L⁴ / (8 D). `deflections` has the
    /// deflection of each vertex, divided by q / D.
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
        // The deflection is a tenth of the thickness. A larger one stretches a strip that curves across its
        // length too.
        let gravity = 2e-8;
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
fn table(header: &str) -> Vec<(String, Vec<f64>)> {
    let documentation = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/simulation/validation.md");
    let documentation = std::fs::read_to_string(documentation).unwrap();
    let (_, rows) = documentation.split_once(header).unwrap();
    let row = |row: &str| {
        let mut cells = row.trim_matches('|').split(['|', ',']).map(str::trim);
        let mesh = [cells.next().unwrap(), cells.next().unwrap()].join(", ");
        (mesh, cells.map(|number| number.parse().unwrap()).collect())
    };
    let rows = rows.lines().skip(2).take_while(|line| line.starts_with('|'));
    rows.map(row).collect()
}

/// Compares figures with a row of the documentation, and the `precise` ones with the theory to 3 %. The text
/// of a row that differs is returned.
fn difference(name: &str, found: &[f64], expected: &[f64], precise: &[f64]) -> Option<String> {
    let is_rounded = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < ROUNDED);
    let is_precise = precise.iter().all(|ratio| (ratio - 1.0).abs() < 0.03);
    let is_right = is_rounded && is_precise && found.len() == expected.len();
    (!is_right).then(|| format!("{name}: {found:.3?}, expected {expected:?}, and {precise:.3?} within 3 %"))
}

/// With ν = 0, a strip bends as a beam, as wide as it is.
#[test]
fn strips_without_contraction_deflect_as_plates() {
    let rows = table("| mesh, ν = 0 | hinges alone, 20 × 4, 40 × 8 | bending energy, 20 × 4, 40 × 8 |");
    assert_eq!(rows.len(), 5);
    let rows = rows.into_iter().filter_map(|(name, expected)| {
        let strips = [[20, 4], [40, 8]].map(narrow);
        let hinged = strips.map(|strip| strip.hinged(&strip.mesh(&name)));
        let found = strips.map(|strip| strip.simulated(&strip.mesh(&name), 0.0));
        difference(&name, &[hinged, found].concat(), &expected, &found)
    });
    assert_eq!(rows.collect::<Vec<_>>(), [] as [String; 0]);
}

/// With ν = 0.3, a narrow strip bends as a beam far from its clamped edge: it curves across its length too.
#[test]
fn narrow_strips_deflect_as_plates() {
    let rows = table("| mesh, ν = 0.3, 1 m × 0.2 m | 20 × 4 | 40 × 8 | 80 × 16 | 20 × 8 | 40 × 4 | 80 × 8 |");
    assert_eq!(rows.len(), 5);
    let rows = rows.into_iter().filter_map(|(name, expected)| {
        let strips = [[20, 4], [40, 8], [80, 16], [20, 8], [40, 4], [80, 8]].map(narrow);
        let found = strips.map(|strip| strip.simulated(&strip.mesh(&name), 0.3) / NARROW_PLATE);
        difference(&name, &found, &expected, &found)
    });
    assert_eq!(rows.collect::<Vec<_>>(), [] as [String; 0]);
}

/// With ν = 0.3, the middle of a wide strip bends as a cylinder, with the rigidity D = E h³ / (12 (1 − ν²)).
/// A beam has a rigidity 9 % smaller.
#[test]
fn wide_strips_deflect_as_plates() {
    let rows = table("| mesh, ν = 0.3, 1 m × 3 m | 10 × 30 | 20 × 30 |");
    assert_eq!(rows.len(), 5);
    let rows = rows.into_iter().filter_map(|(name, expected)| {
        let strips = [[10, 30], [20, 30]].map(wide);
        let found = strips.map(|strip| strip.simulated(&strip.mesh(&name), 0.3) / WIDE_PLATE);
        difference(&name, &found, &expected, &found)
    });
    assert_eq!(rows.collect::<Vec<_>>(), [] as [String; 0]);
}

/// Strips that are twisted, and squares that are rolled along three directions. A square of n × n cells lacks
/// a part of its energy of about 1/n, in the row of cells at its rim; so only the finer ones are within 3 %.
#[test]
fn twisted_strips_and_rolled_squares_have_the_energy_of_plates() {
    let rows = table("| mesh, ν = 0.3 | twist, 40 × 4, 80 × 8 | 24 × 24 at 0°, 22.5°, 45° | 48 × 48 |");
    assert_eq!(rows.len(), 5);
    let rows = rows.into_iter().filter_map(|(name, expected)| {
        let twist = |cells: [u32; 2]| {
            let size = [1.0, 0.1];
            let strip = Strip { cells, size };
            Plate::new(&strip, &strip.mesh(&name), 0.3).twisted()
        };
        let rolled = |n: u32| {
            let (cells, size) = ([n, n], [1.0, 1.0]);
            let strip = Strip { cells, size };
            let mesh = strip.mesh(&name);
            let plate = Plate::new(&strip, &mesh, 0.3);
            [0.0, 22.5, 45.0].map(|degrees| plate.rolled(degrees))
        };
        let found = [[40, 4], [80, 8]].map(twist).into_iter();
        let found: Vec<f64> = found.chain(rolled(24)).chain(rolled(48)).collect();
        // The mesh of the built-in grid.
        let precise = if name.contains("parallel") {
            [&found[..2], &found[5..]].concat()
        } else {
            Vec::new()
        };
        difference(&name, &found, &expected, &precise)
    });
    assert_eq!(rows.collect::<Vec<_>>(), [] as [String; 0]);
}

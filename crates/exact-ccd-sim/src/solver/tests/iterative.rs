//! Conjugate gradients against the sparse factorisation, on the first linear system of a time step. See
//! `docs/simulation/cost.md` for the command and its table.

use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

use nalgebra::{Matrix3, Vector3};

use crate::energies::contact::{Barrier, CollisionSet};
use crate::prescribed::ScriptedVertices;
use crate::solver::couplings::Couplings;
use crate::solver::linear::LinearSolver;
use crate::solver::pattern::Pattern;
use crate::solver::potential::{Potential, Terms};
use crate::solver::unknowns::Unknowns;
use crate::{Body, BodyKind, Length, Script, Settings, Simulation, System, shapes};

/// The residuals at which conjugate gradients stop, relative to the right-hand side.
const RESIDUALS: [f64; 2] = [1e-3, 1e-8];

/// The most iterations of conjugate gradients.
const MOST: usize = 20_000;

/// A symmetric matrix by the columns of its lower triangle. Each begins with the diagonal.
struct Matrix {
    starts: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl Matrix {
    fn new(pattern: &Pattern, values: Vec<f64>) -> Self {
        let scalars = pattern.scalars();
        Self {
            starts: scalars.col_ptr().to_vec(),
            rows: scalars.row_idx().to_vec(),
            values,
        }
    }

    fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// The rows and values of a column below the diagonal.
    fn below(&self, column: usize) -> impl Iterator<Item = (usize, f64)> {
        let places = self.starts[column] + 1..self.starts[column + 1];
        let rows = self.rows[places.clone()].iter().copied();
        rows.zip(self.values[places].iter().copied())
    }

    fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for column in 0..self.size() {
            let mut sum = self.values[self.starts[column]] * x[column];
            for (row, value) in self.below(column) {
                product[row] += value * x[column];
                sum += value * x[row];
            }
            product[column] += sum;
        }
        product
    }

    /// The matrix in Matrix Market's format.
    fn market(&self) -> String {
        let (size, count) = (self.size(), self.rows.len());
        let mut text = format!("%%MatrixMarket matrix coordinate real symmetric\n{size} {size} {count}\n");
        for column in 0..size {
            for place in self.starts[column]..self.starts[column + 1] {
                let row = self.rows[place] + 1;
                let _ = writeln!(text, "{row} {} {:e}", column + 1, self.values[place]);
            }
        }
        text
    }

    /// The inverses of the 3 × 3 blocks on the diagonal.
    fn inverse_blocks(&self) -> Vec<Matrix3<f64>> {
        let block = |vertex: usize| {
            let lower = Matrix3::from_fn(|row, column| {
                let (row, column) = (row.max(column), row.min(column));
                self.values[self.starts[3 * vertex + column] + row - column]
            });
            lower.try_inverse().unwrap()
        };
        (0..self.size() / 3).map(block).collect()
    }

    /// The incomplete Cholesky factor with the pattern of the matrix. The diagonal is increased by as much as
    /// it needs.
    fn incomplete_factor(&self) -> Self {
        let mut shift = 0.0;
        loop {
            let mut factor = Self {
                starts: self.starts.clone(),
                rows: self.rows.clone(),
                values: self.values.clone(),
            };
            for &place in &factor.starts[..self.size()] {
                factor.values[place] *= 1.0 + shift;
            }
            if (0..self.size()).all(|column| factor.eliminate(column)) {
                return factor;
            }
            shift = (2.0_f64 * shift).max(1e-3);
        }
    }

    /// Eliminates a column. Returns false if its diagonal is not positive.
    fn eliminate(&mut self, column: usize) -> bool {
        let places = self.starts[column]..self.starts[column + 1];
        let pivot = self.values[places.start];
        if pivot <= 0.0 {
            return false;
        }
        for value in &mut self.values[places.clone()] {
            *value /= pivot.sqrt();
        }
        for first in places.start + 1..places.end {
            let other = self.rows[first];
            let mut at = self.starts[other];
            let end = self.starts[other + 1];
            for place in first..places.end {
                while at < end && self.rows[at] < self.rows[place] {
                    at += 1;
                }
                if at < end && self.rows[at] == self.rows[place] {
                    self.values[at] -= self.values[first] * self.values[place];
                }
            }
        }
        true
    }

    /// The solution of L Lᵀ x = b for a lower triangle L.
    fn solved(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for column in 0..x.len() {
            x[column] /= self.values[self.starts[column]];
            for (row, value) in self.below(column) {
                x[row] -= value * x[column];
            }
        }
        for column in (0..x.len()).rev() {
            let sum: f64 = self.below(column).map(|(row, value)| value * x[row]).sum();
            x[column] = (x[column] - sum) / self.values[self.starts[column]];
        }
        x
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds a multiple of a vector.
fn add(x: &mut [f64], factor: f64, y: &[f64]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x += factor * y;
    }
}

/// The solution up to a relative residual by preconditioned conjugate gradients, with the iterations.
fn conjugate_gradients(
    matrix: &Matrix,
    right: &[f64],
    residual: f64,
    precondition: &dyn Fn(&[f64]) -> Vec<f64>,
) -> (Vec<f64>, usize) {
    let mut x = vec![0.0; right.len()];
    let mut r = right.to_vec();
    let mut z = precondition(&r);
    let mut p = z.clone();
    let mut rz = dot(&r, &z);
    for iteration in 0..MOST {
        if dot(&r, &r) <= residual * residual * dot(right, right) {
            return (x, iteration);
        }
        let along = matrix.times(&p);
        let size = rz / dot(&p, &along);
        add(&mut x, size, &p);
        add(&mut r, -size, &along);
        z = precondition(&r);
        let before = std::mem::replace(&mut rz, dot(&r, &z));
        for (p, z) in p.iter_mut().zip(&z) {
            *p = z + rz / before * *p;
        }
    }
    (x, MOST)
}

/// The first linear system of the next time step, with the number of contacts.
fn first_system(simulation: &Simulation) -> (Pattern, Vec<f64>, Vec<f64>, usize) {
    let (system, settings, state) = (simulation.system(), simulation.settings(), simulation.state());
    let held = system.held(simulation.time() + settings.time_step);
    let scheme = settings
        .integrator
        .scheme(state, settings.time_step, settings.damping);
    let terms = Terms {
        duration: scheme.duration,
        inertia: scheme.inertia(&system.masses, &held, |_| Vector3::from(settings.gravity)),
        dampers: Vec::new(),
        friction: Vec::new(),
    };
    let barrier = Barrier::new(settings.contact_distance.meters(system.size()));
    let candidates = system.geometry.near_at(&state.positions, &barrier);
    let surface = system.contact_surface(settings.formulation);
    let collisions = CollisionSet::new(surface, &candidates, &state.positions, barrier);
    let potential = Potential {
        system,
        terms: &terms,
        stiffness: state.stiffness.unwrap_or(0.0) * scheme.duration * scheme.duration,
        twists: &[],
    };
    let unknowns = Unknowns::new(&held);
    let couplings = Couplings::new(system, &[], &unknowns);
    let rest = vec![Vector3::zeros(); state.positions.len()];
    let model = potential.quadratic(
        &state.positions,
        collisions.as_slice(),
        &unknowns,
        &couplings,
        &rest,
        None,
    );
    let right = model.right(&unknowns);
    (model.pattern, model.values, right, collisions.count())
}

/// The time that this thread has had a processor, on Linux: other work on the machine hardly counts.
fn processor_time() -> Duration {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    let nanoseconds = statistics.split(' ').next().unwrap();
    Duration::from_nanos(nanoseconds.parse().unwrap())
}

/// The least processor time of three calls, and the result.
fn timed<T>(mut f: impl FnMut() -> T) -> (T, Duration) {
    let mut once = || {
        let before = processor_time();
        let result = f();
        (result, processor_time() - before)
    };
    let (mut result, mut least) = once();
    for _ in 0..2 {
        let (again, time) = once();
        (result, least) = (again, least.min(time));
    }
    (result, least)
}

/// A solid of cubes with a Young's modulus.
fn solid(cells: [u8; 3], size: [f64; 3], modulus: f64) -> Body {
    let mut body = shapes::solid_box(cells, size);
    if let BodyKind::Solid { material, .. } = &mut body.kind {
        material.young = modulus;
    }
    body
}

/// Cubes of 0.5 m above each other, 2 mm apart.
fn stack(count: usize, cells: u8, modulus: f64) -> Vec<Body> {
    let cube = |place: usize| {
        let height = 0.002 + 0.502 * place as f64;
        solid([cells; 3], [0.5; 3], modulus).placed(move |[x, y, z]| [x + 0.25, y + height, z + 0.25])
    };
    let floor = shapes::floor([1, 1], [1.0, 1.0]);
    (0..count).map(cube).chain([floor]).collect()
}

#[test]
#[ignore = "it measures times"]
fn conjugate_gradients_against_the_factorisation() {
    let cloth = |height: f64| {
        shapes::cloth([40, 40], [1.0; 2]).placed(move |[x, y, z]| [x - 0.5, y + height, z - 0.5])
    };
    let beam = vec![solid([44, 4, 4], [1.1, 0.1, 0.1], 1e6)];
    let end: Vec<ScriptedVertices> = vec![Script::Fixed.on((0..25).map(|row| 45 * row))];
    let scenes = [
        ("beam that hangs at one end, 1 MPa", beam, end, 5),
        ("cube on a floor, 0.1 MPa", stack(1, 17, 1e5), vec![], 1),
        ("cube on a floor, 100 MPa", stack(1, 17, 1e8), vec![], 1),
        ("two cubes at rest, 0.1 MPa", stack(2, 13, 1e5), vec![], 8),
        ("two cubes at rest, 100 MPa", stack(2, 13, 1e8), vec![], 8),
        (
            "two cloths on a sphere",
            vec![cloth(0.302), cloth(0.305), shapes::sphere(3, 0.3)],
            vec![],
            6,
        ),
    ];
    for (name, bodies, scripts, steps) in scenes {
        let settings = Settings {
            time_step: 0.02,
            contact_distance: Length::Absolute(2e-3),
            ..Settings::default()
        };
        let system = System::new(&bodies, &scripts).unwrap();
        let mut simulation = Simulation::new(system, settings).unwrap();
        for _ in 0..steps {
            simulation.step().unwrap();
        }
        let (pattern, values, right, contacts) = first_system(&simulation);
        let solve =
            |solver: &mut LinearSolver| solver.solve(pattern.clone(), values.clone(), &right).unwrap();
        let (expected, whole) = timed(|| solve(&mut LinearSolver::default()));
        let mut kept = LinearSolver::default();
        solve(&mut kept);
        let (_, numeric) = timed(|| solve(&mut kept));
        let matrix = Matrix::new(&pattern, values.clone());
        if let Some(folder) = std::env::var_os("SYSTEMS") {
            let file = format!("{}.mtx", name.replace([' ', ','], "-"));
            std::fs::write(Path::new(&folder).join(file), matrix.market()).unwrap();
        }
        let tetrahedra = simulation.system().tetrahedra().len();
        let mut row = format!(
            "| {name} | {tetrahedra} | {} | {contacts} | {:.0} | {:.0} |",
            right.len(),
            1e3 * whole.as_secs_f64(),
            1e3 * numeric.as_secs_f64()
        );
        for is_incomplete in [false, true] {
            for residual in RESIDUALS {
                let ((found, iterations), time) = timed(|| {
                    if is_incomplete {
                        let factor = matrix.incomplete_factor();
                        conjugate_gradients(&matrix, &right, residual, &|r| factor.solved(r))
                    } else {
                        let blocks = matrix.inverse_blocks();
                        let product = |r: &[f64]| {
                            let parts = r.chunks_exact(3).map(Vector3::from_column_slice);
                            let products = blocks.iter().zip(parts).map(|(block, part)| block * part);
                            products.flat_map(<[f64; 3]>::from).collect()
                        };
                        conjugate_gradients(&matrix, &right, residual, &product)
                    }
                });
                row += &format!(" {iterations}, {:.0} |", 1e3 * time.as_secs_f64());
                // The error in the norm of the matrix, relative to the exact solution.
                let mut error = found;
                add(&mut error, -1.0, &expected);
                let energy = |x: &[f64]| dot(x, &matrix.times(x));
                let relative = (energy(&error) / energy(&expected)).sqrt();
                assert!(
                    iterations == MOST || relative < 1e3 * residual,
                    "{name}: {relative}"
                );
            }
        }
        println!("{row}");
    }
}

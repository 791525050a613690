//! The quadratic model that a Newton iteration minimises.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use super::pattern::{Pattern, key};
use super::potential::{Potential, each};
use super::unknowns::Unknowns;
use crate::contact::Collisions;
use crate::element::Term;
use crate::gather::gather_some;
use crate::scripted::Axes;

/// The gradient and the Hessian of a potential, and the effect of the prescribed displacements.
pub(crate) struct Quadratic {
    /// The gradient with respect to all vertices.
    pub(crate) gradient: Vec<Vector3<f64>>,
    /// The sparsity pattern of the Hessian with respect to the unknowns.
    pub(crate) pattern: Pattern,
    /// The entries of this Hessian.
    pub(crate) values: Vec<f64>,
    /// The change of the gradient by the prescribed displacements: the columns of the Hessian that belong to
    /// the coordinates that are not unknown, times their displacements.
    pub(crate) prescribed: Vec<Vector3<f64>>,
}

impl Potential<'_> {
    /// The pairs of unknowns that share an elastic element.
    pub(crate) fn elastic_keys(&self, unknowns: &Unknowns) -> Vec<u64> {
        let mut keys = Vec::new();
        for element in &self.system.elements {
            add_keys(&mut keys, unknowns, &element.vertices());
        }
        for bend in &self.system.bends {
            add_keys(&mut keys, unknowns, bend.vertices());
        }
        keys.sort_unstable();
        keys.dedup();
        keys
    }

    /// The quadratic model. `displacements` are the prescribed ones: zero for unknown coordinates.
    pub(crate) fn quadratic(
        &self,
        points: &[Point],
        collisions: &Collisions,
        unknowns: &Unknowns,
        elastic_keys: &[u64],
        displacements: &[Vector3<f64>],
    ) -> Quadratic {
        let mut keys = elastic_keys.to_vec();
        let contacts = collisions.as_slice();
        contacts
            .iter()
            .for_each(|c| add_keys(&mut keys, unknowns, c.vertices()));
        self.friction
            .iter()
            .for_each(|c| add_keys(&mut keys, unknowns, c.vertices()));
        let pattern = Pattern::new(unknowns.len(), keys);
        let mut sum = Sum {
            values: vec![0.0; pattern.scalar_count()],
            gradient: self.inertia_gradient(points),
            prescribed: vec![Vector3::zeros(); points.len()],
            pattern,
            unknowns,
            displacements,
        };

        for (vertex, mass) in self.inertia() {
            sum.add_diagonal(vertex as u32, &Vector3::repeat(mass));
        }
        for spring in self.springs {
            sum.gradient[spring.vertex as usize] += spring.gradient(points);
            sum.add_diagonal(spring.vertex, &spring.stiffness);
        }
        let scale = self.scheme.duration * self.scheme.duration;
        each(
            &self.system.elements,
            |element| element.derivatives(points, true).scaled(scale),
            |_, element| sum.add(element),
        );
        each(
            &self.system.bends,
            |bend| {
                let mut patch = bend.derivatives(points);
                patch.gradient *= scale;
                patch.hessian *= scale;
                patch
            },
            |_, patch| sum.add(patch),
        );
        each(
            contacts,
            |collision| {
                let corners = gather_some(points, collision.vertices());
                collision
                    .derivatives(&corners, collisions.barrier(), true)
                    .scaled(self.stiffness)
            },
            |_, element| sum.add(element),
        );
        each(
            self.friction,
            |contact| contact.derivatives(&self.displacements(points, contact), self.smoothing),
            |_, element| sum.add(element),
        );
        let mut quadratic = Quadratic {
            gradient: sum.gradient,
            pattern: sum.pattern,
            values: sum.values,
            prescribed: sum.prescribed,
        };
        if let Some(known) = unknowns.known() {
            quadratic.eliminate(known, unknowns, displacements);
        }
        quadratic
    }
}

impl Quadratic {
    /// Eliminates the known coordinates of unknown vertices: their rows and columns become those of a
    /// diagonal matrix, and the change of the gradient by their displacements is that of the columns before.
    fn eliminate(&mut self, known: &[Axes], unknowns: &Unknowns, displacements: &[Vector3<f64>]) {
        let vertex = |scalar: usize| unknowns.vertices()[scalar / 3] as usize;
        let is_known = |scalar: usize| known[scalar / 3][scalar % 3];
        let (pattern, prescribed) = (&self.pattern, &mut self.prescribed);
        pattern.each(&mut self.values, |[row, column], value| {
            if row == column || !(is_known(row) || is_known(column)) {
                return;
            }
            for [row, column] in [[row, column], [column, row]] {
                if is_known(column) && !is_known(row) {
                    let displacement = displacements[vertex(column)][column % 3];
                    prescribed[vertex(row)][row % 3] += *value * displacement;
                }
            }
            *value = 0.0;
        });
    }

    /// The right-hand side of the Newton direction for the unknowns: zero for known coordinates.
    pub(super) fn right(&self, unknowns: &Unknowns) -> Vec<f64> {
        let mut right: Vec<f64> = unknowns
            .vertices()
            .iter()
            .flat_map(|&v| <[f64; 3]>::from(-self.gradient[v as usize] - self.prescribed[v as usize]))
            .collect();
        let known = unknowns.known().unwrap_or_default().as_flattened();
        for (value, _) in right.iter_mut().zip(known).filter(|(_, is_known)| **is_known) {
            *value = 0.0;
        }
        right
    }
}

fn add_keys(keys: &mut Vec<u64>, unknowns: &Unknowns, vertices: &[u32]) {
    for (place, &a) in vertices.iter().enumerate() {
        let Some(a) = unknowns.number(a) else { continue };
        let others = vertices[..place].iter().filter_map(|&b| unknowns.number(b));
        keys.extend(others.map(|b| key(a, b)));
    }
}

/// A quadratic model under construction.
struct Sum<'a> {
    pattern: Pattern,
    values: Vec<f64>,
    gradient: Vec<Vector3<f64>>,
    prescribed: Vec<Vector3<f64>>,
    unknowns: &'a Unknowns,
    displacements: &'a [Vector3<f64>],
}

impl Sum<'_> {
    fn add_diagonal(&mut self, vertex: u32, values: &Vector3<f64>) {
        if let Some(number) = self.unknowns.number(vertex) {
            let block = Matrix3::from_diagonal(values);
            self.pattern.add(&mut self.values, number, number, &block);
        }
    }

    fn add(&mut self, element: &impl Term) {
        for (row, &vertex) in element.vertices().iter().enumerate() {
            self.gradient[vertex as usize] += element.force(row);
            let Some(number) = self.unknowns.number(vertex) else {
                continue;
            };
            for (column, &other) in element.vertices().iter().enumerate() {
                match self.unknowns.number(other) {
                    None => {
                        let displacement = self.displacements[other as usize];
                        self.prescribed[vertex as usize] += element.block(row, column) * displacement;
                    }
                    // The upper triangle is not stored.
                    Some(other) if other > number => {}
                    Some(other) => {
                        let block = element.block(row, column);
                        self.pattern.add(&mut self.values, number, other, &block);
                    }
                }
            }
        }
    }
}

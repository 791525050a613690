//! The quadratic model that a Newton iteration minimises.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, Vector3};

use super::form::Form;
use super::pattern::{Pattern, key};
use super::potential::Potential;
use super::unknowns::Unknowns;
use crate::carriers::Carriers;
use crate::contact::Collision;
use crate::energy::Projection;
use crate::scripted::Axes;

/// The gradient and the Hessian of a potential, and the effect of the prescribed displacements.
pub(crate) struct Quadratic {
    /// The gradient with respect to all vertices: zero for carried ones, on which nothing depends then.
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
        let (mut keys, carriers) = (Vec::new(), &self.system.carriers);
        add_keys(&mut keys, unknowns, carriers, &self.elasticity(1.0));
        add_keys(&mut keys, unknowns, carriers, &Form::of(self.twists, 1.0));
        keys.sort_unstable();
        keys.dedup();
        keys
    }

    /// The quadratic model. `displacements` are the prescribed ones: zero for unknown coordinates.
    pub(crate) fn quadratic(
        &self,
        points: &[Point],
        collisions: &[Collision],
        unknowns: &Unknowns,
        elastic_keys: &[u64],
        displacements: &[Vector3<f64>],
    ) -> Quadratic {
        let (mut keys, carriers) = (elastic_keys.to_vec(), &self.system.carriers);
        add_keys(&mut keys, unknowns, carriers, &Form::of(collisions, 1.0));
        add_keys(
            &mut keys,
            unknowns,
            carriers,
            &Form::of(&self.terms.friction, 1.0),
        );
        let pattern = Pattern::new(unknowns.len(), keys);
        let mut sum = Quadratic {
            gradient: vec![Vector3::zeros(); points.len()],
            values: vec![0.0; pattern.scalar_count()],
            prescribed: vec![Vector3::zeros(); points.len()],
            pattern,
        };
        for form in self.forms(collisions) {
            form.add_gradient(points, &mut sum.gradient);
            form.each(
                |term| {
                    let hessian = term.hessian(points, Projection::SemiDefinite) * form.factor;
                    carriers.pulled(term.vertices(), hessian)
                },
                |term, hessian| {
                    sum.add(
                        &carriers.unknowns(term.vertices()),
                        hessian,
                        unknowns,
                        displacements,
                    );
                },
            );
        }
        carriers.collect(&mut sum.gradient);
        if let Some(known) = unknowns.known() {
            sum.eliminate(known, unknowns, displacements);
        }
        sum
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

    /// Adds the Hessian of a term.
    fn add(
        &mut self,
        vertices: &[u32],
        hessian: &DMatrix<f64>,
        unknowns: &Unknowns,
        displacements: &[Vector3<f64>],
    ) {
        for (row, &vertex) in vertices.iter().enumerate() {
            let Some(number) = unknowns.number(vertex) else {
                continue;
            };
            for (column, &other) in vertices.iter().enumerate() {
                let block = hessian.fixed_view::<3, 3>(3 * row, 3 * column);
                match unknowns.number(other) {
                    None => self.prescribed[vertex as usize] += block * displacements[other as usize],
                    // The upper triangle is not stored.
                    Some(other) if other > number => {}
                    Some(other) => self
                        .pattern
                        .add(&mut self.values, number, other, &block.into_owned()),
                }
            }
        }
    }
}

fn add_keys(keys: &mut Vec<u64>, unknowns: &Unknowns, carriers: &Carriers, form: &Form<'_>) {
    for vertices in form.terms.iter().map(|term| carriers.unknowns(term.vertices())) {
        for (place, &a) in vertices.iter().enumerate() {
            let Some(a) = unknowns.number(a) else { continue };
            let others = vertices[..place].iter().filter_map(|&b| unknowns.number(b));
            keys.extend(others.map(|b| key(a, b)));
        }
    }
}

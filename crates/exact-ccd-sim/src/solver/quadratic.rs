//! The quadratic model that a Newton iteration minimises.

use std::borrow::Cow;

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use super::couplings::{Couplings, Place, add_keys};
use super::form::Form;
use super::pattern::Pattern;
use super::potential::Potential;
use super::unknowns::Unknowns;
use crate::carriers::Carriers;
use crate::energies::contact::Collision;
use crate::energies::term::{Block, Projection, pair_count, write_blocks};
use crate::prescribed::Axes;

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
    /// The quadratic model. `displacements` are the prescribed ones: zero for unknown coordinates.
    /// `couplings` belong to the same system, unknowns and twists. If an earlier pattern has all pairs of
    /// this model, the model takes it.
    pub(crate) fn quadratic(
        &self,
        points: &[Point],
        collisions: &[Collision],
        unknowns: &Unknowns,
        couplings: &Couplings,
        displacements: &[Vector3<f64>],
        earlier: Option<&Pattern>,
    ) -> Quadratic {
        let (mut keys, carriers) = (Vec::new(), &self.system.carriers);
        add_keys(&mut keys, unknowns, carriers, &Form::of(collisions, 1.0));
        add_keys(
            &mut keys,
            unknowns,
            carriers,
            &Form::of(&self.terms.friction, 1.0),
        );
        let own = couplings.pattern.with(keys);
        let pattern = match earlier.filter(|earlier| own.places_in(earlier).is_some()) {
            Some(earlier) => earlier.clone(),
            None => own,
        };
        let places = couplings.pattern.places_in(&pattern).unwrap_or_default();
        let mut sum = Sum {
            points,
            carriers,
            blocks: vec![[0.0; 9]; pattern.len()],
            gradient: vec![Vector3::zeros(); points.len()],
            prescribed: Prescribed {
                unknowns,
                displacements,
                change: vec![Vector3::zeros(); points.len()],
            },
        };
        let [inertia, elastic, others @ ..] = self.forms(collisions);
        let place = |pair| Place::of(&pattern, unknowns, pair);
        sum.add(&inertia, place);
        let mut elastic_places = couplings.places.iter();
        sum.add(&elastic, |_| {
            elastic_places.next().copied().flatten()?.among(&places)
        });
        for form in &others {
            sum.add(form, place);
        }
        let Sum {
            blocks,
            mut gradient,
            prescribed,
            ..
        } = sum;
        carriers.collect(&mut gradient);
        let mut quadratic = Quadratic {
            gradient,
            values: pattern.values(&blocks),
            pattern,
            prescribed: prescribed.change,
        };
        if let Some(known) = unknowns.known() {
            quadratic.eliminate(known, unknowns, displacements);
        }
        quadratic
    }
}

/// The derivatives of the terms so far.
struct Sum<'a> {
    points: &'a [Point],
    carriers: &'a Carriers,
    blocks: Vec<Block>,
    gradient: Vec<Vector3<f64>>,
    prescribed: Prescribed<'a>,
}

impl Sum<'_> {
    /// Adds the derivatives of some terms. `place` is called for each pair of vertices of a term, in the
    /// order of [`pairs`](crate::energies::term::pairs), and returns the place of its block, if both are
    /// unknown.
    fn add(&mut self, form: &Form<'_>, mut place: impl FnMut([u32; 2]) -> Option<Place>) {
        let (points, carriers) = (self.points, self.carriers);
        form.each(
            |term| 3 * term.vertices().len() + 9 * pair_count(carriers.unknowns(term.vertices()).len()),
            |term, derivatives| {
                let (gradient, hessian) = derivatives.split_at_mut(3 * term.vertices().len());
                let (hessian, _) = hessian.as_chunks_mut();
                let projection = Projection::SemiDefinite;
                match carriers.unknowns(term.vertices()) {
                    Cow::Borrowed(_) => term.write_derivatives(points, projection, gradient, hessian),
                    Cow::Owned(unknowns) => {
                        term.write_gradient(points, gradient);
                        let pulled = carriers.pulled(term.vertices(), term.hessian(points, projection));
                        write_blocks(&pulled, unknowns.len(), hessian);
                    }
                }
            },
            |term, derivatives| {
                let (gradient, hessian) = derivatives.split_at(3 * term.vertices().len());
                form.add_forces(term, gradient, &mut self.gradient);
                let mut blocks = hessian.as_chunks().0.iter();
                let vertices = carriers.unknowns(term.vertices());
                for (column, &vertex) in vertices.iter().enumerate() {
                    for (&row, block) in vertices[column..].iter().zip(&mut blocks) {
                        match place([row, vertex]) {
                            Some(place) => place.add(&mut self.blocks, block, form.factor),
                            None => self.prescribed.add([row, vertex], block, form.factor),
                        }
                    }
                }
            },
        );
    }
}

/// The change of the gradient by the prescribed displacements.
struct Prescribed<'a> {
    unknowns: &'a Unknowns,
    displacements: &'a [Vector3<f64>],
    change: Vec<Vector3<f64>>,
}

impl Prescribed<'_> {
    /// Adds the product of the block of a pair with one unknown vertex.
    fn add(&mut self, [row, column]: [u32; 2], block: &Block, factor: f64) {
        let block = Matrix3::from_column_slice(block) * factor;
        for (at, by, block) in [(row, column, block), (column, row, block.transpose())] {
            if self.unknowns.number(at).is_some() && self.unknowns.number(by).is_none() {
                self.change[at as usize] += block * self.displacements[by as usize];
            }
        }
    }
}

impl Quadratic {
    /// Eliminates the known coordinates of unknown vertices: the entries of their rows and columns off the
    /// diagonal become 0. These columns, times their displacements, have been added to the gradient's change.
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

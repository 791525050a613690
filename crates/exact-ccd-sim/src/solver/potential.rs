//! The incremental potential, whose minimum is the result of a time step.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::form::Form;
use crate::energies::anchor::Anchor;
use crate::energies::contact::Collision;
use crate::energies::damper::Damper;
use crate::energies::elasticity::Twist;
use crate::energies::friction::FrictionContact;
use crate::system::System;

/// The terms of an incremental potential that stay constant while it is minimised.
pub(crate) struct Terms {
    /// The effective time step h, in s.
    pub(crate) duration: f64,
    pub(crate) inertia: Vec<Anchor>,
    pub(crate) dampers: Vec<Damper>,
    pub(crate) friction: Vec<FrictionContact>,
}

/// Inertia + h² Ψ(x) + κ Σ b + friction + damping, in kg m².
pub(crate) struct Potential<'a> {
    pub(crate) system: &'a System,
    pub(crate) terms: &'a Terms,
    /// κ.
    pub(crate) stiffness: f64,
    pub(crate) twists: &'a [Twist],
}

impl Potential<'_> {
    /// All terms.
    pub(super) fn forms<'a>(&'a self, collisions: &'a [Collision]) -> [Form<'a>; 6] {
        let Terms {
            duration,
            inertia,
            dampers,
            friction,
        } = self.terms;
        let squared = duration * duration;
        [
            Form::of(inertia, 1.0),
            Form::elastic(self.system, squared),
            Form::of(self.twists, squared),
            Form::of(collisions, self.stiffness),
            Form::of(friction, 1.0),
            // They act on the vertices of elastic elements.
            Form::of(dampers, 1.0),
        ]
    }

    /// The value. Infinite if a neo-Hookean element is inverted.
    pub(crate) fn value(&self, points: &[Point], collisions: &[Collision]) -> f64 {
        self.forms(collisions).iter().map(|form| form.value(points)).sum()
    }

    /// The gradient by the unknowns: zero for carried vertices.
    pub(crate) fn gradient(&self, points: &[Point], collisions: &[Collision]) -> Vec<Vector3<f64>> {
        let mut gradient = vec![Vector3::zeros(); points.len()];
        for form in self.forms(collisions) {
            form.add_gradient(points, &mut gradient);
        }
        self.system.carriers.collect(&mut gradient);
        gradient
    }

    /// The magnitude of the rounding error of a value.
    pub(crate) fn noise(&self, value: f64) -> f64 {
        let elastic = self.terms.duration * self.terms.duration * self.system.elastic.rigidity;
        8.0 * f64::EPSILON * (elastic + value.abs())
    }
}

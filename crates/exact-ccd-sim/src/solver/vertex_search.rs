//! The line search in which each vertex takes a part of its own of the direction.
//!
//! The Newton direction d decreases the potential: with the gradient g, the projected Hessian H and δ = −g
//! · d = dᵀ H d > 0, the quadratic model of the potential falls by m(α) = α (1 − α/2) δ in the common step
//! α. For parts αᵥ of its own for each vertex, p = (αᵥ dᵥ) can increase the potential, because Σ αᵥ gᵥ · dᵥ
//! has terms of both signs. A step β p is therefore taken only if the potential falls by at least m(α), for
//! the free common step α, as the common step promises. So the sum of m(α) over all such steps with the
//! same stiffness is bounded, up to rounding, as for the common step with a condition of descent.
//!
//! The model is convex. Along p it falls by at most −β g · p, so that no β with −β g · p < m(α) is tried.

use std::time::Instant;

use exact_ccd_mesh::{Point, Step};
use nalgebra::Vector3;

use super::direction::Direction;
use super::line_search::Taken;
use super::newton::{Iterate, Newton};
use super::potential::Potential;
use crate::statistics::Statistics;

impl Newton<'_> {
    /// A step towards positions, each on the straight way of its vertex. It is free of contact and decreases
    /// the potential by at least as much as the model does in the step of size `common`. `None` if there is
    /// none.
    pub(super) fn search_to(
        &self,
        now: &Iterate<'_>,
        end: &[Point],
        direction: &Direction<'_>,
        common: f64,
        potential: &Potential<'_>,
        statistics: &mut Statistics,
    ) -> Option<Taken> {
        let clock = Instant::now();
        let step = Step::new(&self.system.geometry.mesh, &now.positions, end).ok()?;
        // Vertices that move alike in the whole step are no candidates there, but can be here.
        let candidates = self.system.geometry.near(step, &self.barrier);
        statistics.seconds.ccd += clock.elapsed().as_secs_f64();
        let pairs = || end.iter().zip(&now.positions);
        let moves: Vec<Vector3<f64>> = pairs()
            .map(|(to, from)| Vector3::from(*to) - Vector3::from(*from))
            .collect();
        let slope = direction.slope(&moves);
        let promised = common * (1.0 - 0.5 * common) * direction.decrease;
        let before = now.potential(potential);
        let mut part = 1.0;
        while promised > 0.0 && -slope * part >= promised {
            let clock = Instant::now();
            let positions = step.at(part);
            let collisions = self.collisions(&candidates, &positions);
            let after = potential.value(&positions, collisions.as_slice());
            statistics.seconds.line_search += clock.elapsed().as_secs_f64();
            if after <= before - promised {
                let clock = Instant::now();
                let is_free = Step::new(step.mesh(), &now.positions, &positions)
                    .is_ok_and(|step| self.is_free(&candidates, step));
                statistics.seconds.ccd += clock.elapsed().as_secs_f64();
                if is_free {
                    return Some(Taken {
                        positions,
                        collisions,
                        value: after,
                        size: part * direction.share(&moves),
                    });
                }
            }
            part *= 0.5;
        }
        None
    }
}

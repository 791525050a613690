//! The phases of a repair, and the decision at its end.

use std::sync::Arc;

use exact_ccd_mesh::{Point, TriangleMesh};

use crate::change::Change;
use crate::error::RepairError;
use crate::linked::linked;
use crate::loosen::loosen;
use crate::one_sided::one_sided_surface;
use crate::options::RepairOptions;
use crate::outcome::{Outcome, Reason, Repaired, Unrepaired};
use crate::problem::Problem;
use crate::progress::Phase;
use crate::restore::restore;
use crate::separate::separate;

/// Moves vertices of a mesh, as little as the method finds, until no edge passes through a face and no pair
/// is within the minimum distance. See the [crate](crate) for the method.
///
/// # Errors
/// [`RepairError`] names the positions that do not fit the mesh, or the pinned vertex that it does not have.
pub fn repair(
    mesh: &Arc<TriangleMesh>,
    positions: &[Point],
    options: &RepairOptions<'_>,
) -> Result<Outcome, RepairError> {
    let mut problem = Problem::new(mesh, positions, options)?;
    let (crossings, contacts) = problem.found(positions)?;
    let is_pinned = |vertices: &[u32]| {
        vertices
            .iter()
            .all(|&vertex| problem.unknowns.is_pinned(vertex as usize))
    };
    let are_pinned = |found: Option<([u32; 2], [u32; 3])>| {
        found.is_some_and(|(ends, corners)| is_pinned(&ends) && is_pinned(&corners))
    };
    let pinned = Unrepaired {
        positions: positions.to_vec(),
        crossings: crossings
            .iter()
            .copied()
            .filter(|pair| are_pinned(pair.vertices(mesh)))
            .collect(),
        contacts: contacts
            .iter()
            .copied()
            .filter(|pair| pair.vertices(mesh).is_some_and(|vertices| is_pinned(&vertices)))
            .collect(),
        reason: Reason::Pinned,
    };
    if !pinned.crossings.is_empty() || !pinned.contacts.is_empty() {
        return Ok(Outcome::Unrepaired(pinned));
    }
    let repaired = |problem: &Problem<'_>, positions: Vec<Point>| {
        Outcome::Repaired(Repaired {
            change: Change::new(mesh, &problem.size, problem.given, &positions),
            crossings: crossings.len(),
            contacts: contacts.len(),
            positions,
        })
    };
    if crossings.is_empty() && contacts.is_empty() {
        return Ok(repaired(&problem, positions.to_vec()));
    }
    if let Some(face) = one_sided_surface(mesh, &options.can_collide) {
        return Ok(Outcome::Unrepaired(Unrepaired {
            positions: positions.to_vec(),
            crossings,
            contacts,
            reason: Reason::OneSided { face },
        }));
    }
    let is_pinned = |vertex: u32| problem.unknowns.is_pinned(vertex as usize);
    if options.can_collide.is_all()
        && let Some((edge, face)) = linked(mesh, is_pinned, &crossings, &problem.touching(positions)?)
    {
        return Ok(Outcome::Unrepaired(Unrepaired {
            positions: positions.to_vec(),
            crossings,
            contacts,
            reason: Reason::Linked { edge, face },
        }));
    }
    problem.size.check()?;
    let ended = match loosen(&mut problem)? {
        Ok(loose) => separate(&mut problem, loose)?,
        Err(ended) => Err(ended),
    };
    let (positions, reason) = match ended {
        Ok(apart) => (restore(&mut problem, apart)?, Reason::Rounds(Phase::Return)),
        Err(ended) => ended,
    };
    // The steps are certified one by one; this is the statement about the result.
    let (crossings, contacts) = problem.found(&positions)?;
    if crossings.is_empty() && contacts.is_empty() {
        return Ok(repaired(&problem, positions));
    }
    Ok(Outcome::Unrepaired(Unrepaired {
        positions,
        crossings,
        contacts,
        reason,
    }))
}

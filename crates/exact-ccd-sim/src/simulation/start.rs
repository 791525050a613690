//! The start of a simulation: its state, and the check that nothing intersects.

use std::collections::BTreeMap;

use exact_ccd::Options;
use exact_ccd_mesh::{Audit, MotionError, Point, Step, StepError, TriangleMesh, Violation};

use crate::energies::contact::Barrier;
use crate::error::SimulationError;
use crate::settings::Formulation;
use crate::state::State;
use crate::system::{BodyPrimitive, Primitive, System};

/// The initial positions and velocities of a system.
pub(super) fn state(system: &System) -> State {
    State {
        step: 0,
        positions: system.start.clone(),
        velocities: system.velocities.clone(),
        earlier: None,
        stiffness: None,
        origins: BTreeMap::new(),
        behind: BTreeMap::new(),
        twists: BTreeMap::new(),
    }
}

/// Checks that no two primitives intersect or touch, including pairs of two obstacles. An [`Audit`] of the
/// recorded motion starts with the same check. Then checks that all pairs except pairs of two obstacles are
/// farther apart than the sum of their offsets, that particles touch nothing, and that all bodies but
/// obstacles are apart from all half spaces.
pub(super) fn check(system: &System, state: &State) -> Result<(), SimulationError> {
    if let Some((vertex, half_space)) = system.geometry.first_grounded(&state.positions) {
        return Err(SimulationError::Grounded {
            vertex: BodyPrimitive::new(system, Primitive::Vertex(vertex)),
            half_space: system.designation(system.body_vertices().len() + half_space),
            near: state.positions[vertex as usize],
        });
    }
    // The frame has no vertices in the interior of solids, which touch nothing.
    let frame = system.surface_frame(&state.positions).map_err(StepError::Start);
    let frame = frame.map_err(MotionError::from)?;
    let mesh = frame.mesh.clone();
    let violation = Audit::default().examine(frame)?;
    if let Some(violation) = violation {
        let primitives = primitives(system, &mesh, &violation);
        let near = at(state, primitives[0]);
        let primitives = BodyPrimitive::both(system, primitives);
        return Err(SimulationError::Start { primitives, near });
    }
    let positions = &state.positions;
    let step = Step::new(&system.geometry.mesh, positions, positions).map_err(MotionError::from)?;
    let near = system.geometry.near(step, &Barrier::new(0.0));
    let Some(contact) = near.collision(step, Options::within(system.geometry.min_distance.clone())) else {
        return Ok(());
    };
    let primitives = Primitive::of_pair(&system.geometry.mesh, contact.pair);
    let [a, b] = primitives.each_ref().map(Primitive::vertices);
    Err(SimulationError::Close {
        thickness: system.contact_surface(Formulation::Sum).thickness(a, b),
        near: at(state, primitives[0]),
        primitives: BodyPrimitive::both(system, primitives),
    })
}

/// The position of the first vertex of a primitive.
fn at(state: &State, primitive: Primitive) -> Point {
    state.positions[primitive.vertices()[0] as usize]
}

/// The two primitives of a violation, with the vertex indices of the system.
fn primitives(system: &System, mesh: &TriangleMesh, violation: &Violation) -> [Primitive; 2] {
    let primitives = match violation {
        Violation::Intersection { intersection, .. } => [
            Primitive::Edge(mesh.edges()[intersection.edge as usize]),
            Primitive::Face(mesh.faces()[intersection.face as usize]),
        ],
        Violation::Contact { contact, .. } => Primitive::of_pair(mesh, contact.pair),
    };
    primitives.map(|primitive| primitive.map(|vertex| system.geometry.vertices[vertex as usize]))
}

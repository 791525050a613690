//! Rigid bodies as instances of meshes.

use exact_ccd_mesh::{CanCollide, Frame, FrameError, PositionsError, TriangleMesh, check_positions};

use crate::pose::Pose;
use crate::rigid::{RigidMotionError, RigidPoint};

/// A rigid body: a mesh in the coordinates of the body, and its poses at t = 0 and at t = 1.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a> {
    /// The mesh. Its origin is the point about which the body turns.
    pub frame: &'a Frame,
    /// The pose at t = 0. The places of the vertices there are rounded, and then taken exactly.
    pub start: Pose,
    /// The pose at t = 1, reached by [`Pose::motion_to`].
    pub end: Pose,
}

/// The mesh of some rigid bodies, with the trajectory of each vertex.
#[derive(Clone, Debug)]
pub struct Instances {
    /// The meshes of all bodies, one after the other.
    pub mesh: TriangleMesh,
    /// The trajectory of each vertex.
    pub trajectories: Vec<RigidPoint>,
    /// For each vertex, the index of its body.
    pub bodies: Vec<u32>,
}

/// The reason why rigid bodies cannot move.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InstanceError {
    /// The motion of a body is not valid.
    #[error("body {body}: {source}")]
    Motion {
        /// The index of the body.
        body: usize,
        /// The number that is not valid.
        source: RigidMotionError,
    },
    /// The positions of a body do not fit its mesh.
    #[error("body {body}: {source}")]
    Positions {
        /// The index of the body.
        body: usize,
        /// The number of positions, or the coordinate that is not finite.
        source: PositionsError,
    },
    /// All bodies together do not form a mesh, or a place at t = 0 is not finite.
    #[error(transparent)]
    Frame(#[from] FrameError),
}

impl Instances {
    /// The mesh and the trajectories of some bodies.
    ///
    /// # Errors
    /// [`InstanceError`] names the body whose motion or positions are not valid, the vertex whose
    /// place is not finite, or the number of vertices if it exceeds 2³² − 1.
    pub fn new(instances: &[Instance<'_>]) -> Result<Self, InstanceError> {
        let (mut positions, mut trajectories, mut bodies) = (Vec::new(), Vec::new(), Vec::new());
        for (body, instance) in instances.iter().enumerate() {
            let checked = instance.frame.check();
            checked.map_err(|source| InstanceError::Positions { body, source })?;
            let motion = instance.start.motion_to(&instance.end);
            let motion = motion.map_err(|source| InstanceError::Motion { body, source })?;
            for &vertex in &instance.frame.positions {
                let start = instance.start.place(vertex);
                positions.push(start);
                trajectories.push(motion.point(start));
                bodies.push(body as u32);
            }
        }
        let meshes = instances.iter().map(|instance| &instance.frame.mesh);
        let mesh = TriangleMesh::joined(meshes).map_err(FrameError::from)?;
        check_positions(mesh.vertex_count(), &positions).map_err(FrameError::from)?;
        Ok(Self {
            mesh,
            trajectories,
            bodies,
        })
    }

    /// The pairs of primitives of different bodies.
    #[must_use]
    pub fn can_collide(&self) -> CanCollide {
        CanCollide::different_groups(self.bodies.clone())
    }
}

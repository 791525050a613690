//! A mesh to repair, and the exact decisions about its positions at rest.

use std::sync::Arc;

use exact_ccd_mesh::{
    Bvh, Contact, Detector, Intersection, IntersectionOptions, Meeting, Options, Pair, Point, Separation,
    TriangleMesh, check_positions, intersections,
};

use crate::closeness::closeness;
use crate::error::RepairError;
use crate::options::RepairOptions;
use crate::outcome::Reason;
use crate::progress::{Phase, Progress};
use crate::size::Size;
use crate::system::{System, Unknowns};

/// A mesh to repair.
pub(crate) struct Problem<'a> {
    pub(crate) mesh: &'a TriangleMesh,
    /// The given positions.
    pub(crate) given: &'a [Point],
    pub(crate) options: &'a RepairOptions<'a>,
    pub(crate) size: Size,
    /// The closeness of the ends of each edge, as given.
    pub(crate) closeness: Vec<f64>,
    pub(crate) unknowns: Unknowns,
    pub(crate) detector: Detector,
    crossing: IntersectionOptions,
}

/// Edges shorter than this part of the mean length count more in a smoothing.
const SHORT: f64 = 0.5;

/// The end of a phase: positions that are free in its sense, or the last positions and the reason.
pub(crate) type Ended = Result<Vec<Point>, (Vec<Point>, Reason)>;

impl<'a> Problem<'a> {
    pub(crate) fn new(
        mesh: &'a Arc<TriangleMesh>,
        given: &'a [Point],
        options: &'a RepairOptions<'a>,
    ) -> Result<Self, RepairError> {
        let vertex_count = mesh.vertex_count();
        check_positions(vertex_count, given)?;
        let mut is_pinned = vec![false; vertex_count];
        for &vertex in &options.pinned {
            let place = is_pinned.get_mut(vertex as usize);
            *place.ok_or(RepairError::Pinned { vertex, vertex_count })? = true;
        }
        let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let size = Size::new(mesh, given);
        Ok(Self {
            mesh,
            given,
            options,
            size,
            closeness: closeness(mesh, given, size.mean_edge),
            unknowns: Unknowns::new(&is_pinned),
            detector: Detector::new(mesh.clone()).with_can_collide(options.can_collide.clone()),
            crossing: crossing.with_can_collide(options.can_collide.clone()),
        })
    }

    /// The smoothing (1 + `weight` L)⁻¹ of displacements, with L the Laplacian of the graph of edges. An edge
    /// counts once, and one shorter than a part of the mean counts by its closeness: the ends of a short edge
    /// move alike, so that thin triangles do not turn over.
    pub(crate) fn smoothing(&self, weight: f64) -> Result<System, RepairError> {
        let weight = |closeness: &f64| weight * (SHORT * closeness).max(1.0);
        let weights = self.closeness.iter().map(weight);
        self.unknowns
            .system(1.0, self.mesh.edges().iter().copied().zip(weights))
    }

    /// The edges that pass through faces. With no such pair and no [contact](Self::contacts), the mesh is
    /// free: see [`Meeting`].
    pub(crate) fn crossings(&self, x: &[Point]) -> Result<Vec<Intersection>, RepairError> {
        Ok(intersections(self.mesh, x, &Bvh, &self.crossing)?)
    }

    /// The edges and faces with a common point.
    pub(crate) fn touching(&self, x: &[Point]) -> Result<Vec<Intersection>, RepairError> {
        let options = self.crossing.clone().with_meeting(Meeting::Touching);
        Ok(intersections(self.mesh, x, &Bvh, &options)?)
    }

    /// The pairs within a distance.
    pub(crate) fn contacts(
        &mut self,
        x: &[Point],
        distance: Separation,
    ) -> Result<Vec<Contact>, RepairError> {
        Ok(self
            .detector
            .collisions(x, x, Options::within(distance).until(0.0))?)
    }

    /// The edges that pass through faces, and the pairs within the minimum distance.
    pub(crate) fn found(&mut self, x: &[Point]) -> Result<(Vec<Intersection>, Vec<Pair>), RepairError> {
        let contacts = self.contacts(x, self.options.min_distance)?;
        Ok((
            self.crossings(x)?,
            contacts.into_iter().map(|contact| contact.pair).collect(),
        ))
    }

    /// Returns true if a pair is within a distance.
    pub(crate) fn has_contacts(&mut self, x: &[Point], distance: Separation) -> Result<bool, RepairError> {
        Ok(self
            .detector
            .collides(x, x, Options::within(distance).until(0.0))?)
    }

    /// The reason to end a phase before its next round.
    pub(crate) fn ends(&self, phase: Phase, round: usize, pairs: usize) -> Option<Reason> {
        let progress = Progress { phase, round, pairs };
        if self.options.stop.is_some_and(|stop| stop(progress)) {
            Some(Reason::Stopped(phase))
        } else {
            (round >= self.options.max_rounds).then_some(Reason::Rounds(phase))
        }
    }
}

/// Positions with displacements times a factor.
pub(crate) fn moved(x: &[Point], displacements: &[Point], factor: f64) -> Vec<Point> {
    let places = x.iter().zip(displacements);
    places
        .map(|(x, d)| [0, 1, 2].map(|axis: usize| x[axis] + factor * d[axis]))
        .collect()
}

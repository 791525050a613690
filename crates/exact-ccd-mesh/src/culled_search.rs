//! A search that examines few candidates: contacts that are found cull the rest.

use std::ops::ControlFlow;

use exact_ccd::{EdgeEdge, Point, VertexFace};

use crate::broad_phase::BroadPhase;
use crate::can_collide::CanCollide;
use crate::collect::{AnyContact, Collect, Earliest};
use crate::contact::Contact;
use crate::mesh::TriangleMesh;
use crate::narrow_phase::NarrowPhase;
use crate::step::Step;
use crate::step_boxes::StepBoxes;

/// The memory of a search in successive steps of one mesh.
#[derive(Clone, Debug)]
pub(crate) struct CulledSearch<B> {
    broad_phase: B,
    narrow_phase: NarrowPhase,
    resting: StepBoxes<1>,
    moving: StepBoxes<2>,
}

/// One block of primitives in this many is examined first: enough to find an early contact among
/// many.
const SAMPLE_STRIDE: usize = 64;

/// Displacements below this fraction of the mean edge length count as short. The box around a short
/// path is hardly larger than a box that moves along it, and its tests are cheaper.
const SHORT_DISPLACEMENT: f64 = 0.25;

/// Boxes are placed anew if the time until which contacts matter has shrunk to this fraction.
const SHRUNK_TIME: f64 = 0.5;

impl<B: BroadPhase> CulledSearch<B> {
    /// A search among the pairs that can collide.
    pub(crate) fn new(broad_phase: B, can_collide: CanCollide) -> Self {
        Self {
            broad_phase,
            narrow_phase: NarrowPhase::new(can_collide),
            resting: StepBoxes::new(0.0),
            moving: StepBoxes::new(0.0),
        }
    }

    /// The same broad phase, without memory, for other pairs that can collide.
    pub(crate) fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self::new(self.broad_phase, can_collide)
    }

    /// The earliest contact of a step of the mesh.
    pub(crate) fn earliest_contact(&mut self, step: &Step<'_>) -> Option<Contact> {
        let earliest = Earliest::new();
        self.run(step, &earliest);
        earliest.contact(step)
    }

    /// Returns true if a step of the mesh is free of contact.
    pub(crate) fn is_free(&mut self, step: &Step<'_>) -> bool {
        let contact = AnyContact::default();
        self.run(step, &contact);
        !contact.is_found()
    }

    /// Passes all candidates until the collector's time to the collector, possibly with others. The
    /// search ends early if the collector breaks.
    pub(crate) fn run(&mut self, step: &Step<'_>, collector: &impl Collect) {
        let Self {
            broad_phase,
            narrow_phase,
            resting,
            moving,
        } = self;
        // All on threads of the pool: entering it from outside costs a context switch each time.
        let _ = rayon::scope(|_| {
            narrow_phase.begin(step);
            let can_collide = narrow_phase.can_collide();
            let short = time_of_short_displacements(step);
            let pass = Pass {
                step,
                broad_phase: &*broad_phase,
                narrow_phase: &*narrow_phase,
                collector,
            };
            let were_short = collector.until() < short;
            if were_short {
                resting.begin(step, can_collide);
                pass.vertices_and_faces(resting)?;
            } else {
                moving.begin(step, can_collide);
                pass.vertices_and_faces(moving)?;
            }
            if collector.until() >= short {
                return pass.edges(moving);
            }
            if !were_short {
                resting.begin(step, can_collide);
            }
            pass.edges(resting)
        });
    }
}

impl Step<'_> {
    /// The earliest contact, or `None` if the step is free of contact. For many steps of one mesh,
    /// a [`Detector`](crate::Detector) is faster.
    #[must_use]
    pub fn earliest_contact(&self, broad_phase: &impl BroadPhase) -> Option<Contact> {
        CulledSearch::new(broad_phase, CanCollide::all()).earliest_contact(self)
    }

    /// Returns true if no two primitives touch during the step. For many steps of one mesh, a
    /// [`Detector`](crate::Detector) is faster.
    #[must_use]
    pub fn is_free(&self, broad_phase: &impl BroadPhase) -> bool {
        CulledSearch::new(broad_phase, CanCollide::all()).is_free(self)
    }
}

/// The time until which all displacements are short.
fn time_of_short_displacements(step: &Step<'_>) -> f64 {
    let [x0, x1] = step.positions();
    let length = |a: Point, b: Point| (0..3).fold(0.0, |most: f64, axis| most.max((a[axis] - b[axis]).abs()));
    let longest = x0.iter().zip(x1).map(|(&a, &b)| length(a, b)).fold(0.0, f64::max);
    let edges = step.mesh().edges().iter().step_by(SAMPLE_STRIDE);
    let count = edges.len() as f64;
    let sum: f64 = edges
        .map(|edge| edge.map(|v| x0[v as usize]))
        .map(|[a, b]| length(a, b))
        .sum();
    SHORT_DISPLACEMENT * sum / count / longest
}

/// One pass over the candidates of a step.
struct Pass<'a, B, C> {
    step: &'a Step<'a>,
    broad_phase: &'a B,
    narrow_phase: &'a NarrowPhase,
    collector: &'a C,
}

impl<B: BroadPhase, C: Collect> Pass<'_, B, C> {
    fn vertices_and_faces<const T: usize>(&self, boxes: &mut StepBoxes<T>) -> ControlFlow<()> {
        let mesh: &TriangleMesh = self.step.mesh();
        let examine = |pairs: &[_]| {
            self.collector
                .examine::<VertexFace>(self.narrow_phase, mesh, pairs)
        };
        let time = self.collector.until();
        boxes.vertices_and_faces_until(self.step, time);
        if C::PROFITS_FROM_SAMPLE {
            let sample = boxes.vertices.sample(SAMPLE_STRIDE);
            self.broad_phase.between(&sample, &boxes.faces, &examine)?;
            if self.collector.until() < SHRUNK_TIME * time {
                boxes.vertices_and_faces_until(self.step, self.collector.until());
            }
        }
        self.broad_phase.between(&boxes.vertices, &boxes.faces, &examine)
    }

    fn edges<const T: usize>(&self, boxes: &mut StepBoxes<T>) -> ControlFlow<()> {
        let mesh: &TriangleMesh = self.step.mesh();
        let examine = |pairs: &[_]| self.collector.examine::<EdgeEdge>(self.narrow_phase, mesh, pairs);
        let time = self.collector.until();
        boxes.edges_until(self.step, time);
        if C::PROFITS_FROM_SAMPLE {
            let sample = boxes.edges.sample(SAMPLE_STRIDE);
            self.broad_phase.between(&sample, &boxes.edges, &examine)?;
            if self.collector.until() < SHRUNK_TIME * time {
                boxes.edges_until(self.step, self.collector.until());
            }
        }
        self.broad_phase.within(&boxes.edges, &examine)
    }
}

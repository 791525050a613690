//! Two bodies in a step: their primitives that come near each other.

use std::sync::OnceLock;

use arrayvec::ArrayVec;
use exact_ccd::motion::{BodyPair, Chain};
use rayon::prelude::*;

use super::apart::{self, Places};
use super::body::Body;
use super::candidate::Candidate;
use super::collect::Collect;
use super::part::Part;
use super::placed::Placed;
use super::scene::Scene;
use super::shape::Primitive;
use super::tree::{Leaf, Node, Parts};
use super::world::World;

/// The number of candidates that are decided together.
const CHUNK: usize = 64;

/// The number of pairs of nodes that threads share.
const SHARED: usize = 64;

/// Two bodies in a step, the lesser first.
pub(super) struct Encounter<'a> {
    pub(super) ids: [usize; 2],
    /// In the unit of the search, as the motions and the distance.
    pub(super) bodies: [&'a Body; 2],
    motions: [&'a Chain; 2],
    separation: f64,
    /// The motions as they are given.
    pub(super) given: [&'a Chain; 2],
    /// The motions of the first one relative to the second one, and of the second one relative to the first
    /// one, as soon as they are needed.
    relative: [OnceLock<BodyPair>; 2],
}

/// A pair of nodes, one of each body.
pub(super) type Nodes = [u32; 2];

/// The next to examine in place of two nodes.
pub(super) enum Below<'a> {
    /// The same nodes, in halves of the part.
    Later,
    Split([Nodes; 2]),
    Leaves([&'a Leaf; 2]),
}

impl Below<'_> {
    fn of_first(parts: &[u32; 2], pair: Nodes) -> Self {
        Self::Split(parts.map(|part| [part, pair[1]]))
    }
}

impl<'a> Encounter<'a> {
    pub(super) fn new(ids: [usize; 2], world: &'a World<'_>, given: &'a [Chain]) -> Self {
        Self {
            ids,
            bodies: ids.map(|id| &world.bodies[id]),
            motions: ids.map(|id| &world.motions[id]),
            separation: world.separation,
            given: ids.map(|id| &given[id]),
            relative: [OnceLock::new(), OnceLock::new()],
        }
    }

    /// Passes all candidates that matter to a collector.
    pub(super) fn search(&self, collector: &impl Collect) {
        if let Some(roots) = self.roots() {
            self.search_part(Part::WHOLE, &[roots], collector);
        }
    }

    /// The roots of both trees, if both bodies have primitives.
    pub(super) fn roots(&self) -> Option<Nodes> {
        let mut bodies = self.bodies.iter();
        bodies.all(|body| body.tree.root().is_some()).then_some([0, 0])
    }

    /// Searches a part of the step below pairs of nodes: what needs a shorter part, in its halves, the
    /// earlier one first.
    fn search_part(&self, part: Part, pairs: &[Nodes], collector: &impl Collect) {
        if pairs.is_empty() || part.start > collector.until() {
            return;
        }
        let scene = self.scene(part);
        // The roots, or the only pair that is left.
        if let &[pair] = pairs
            && self.has_plane_between(&scene, pair)
        {
            return;
        }
        let (shared, mut later) = self.spread(&scene, pairs, collector);
        let found = shared
            .par_iter()
            .map(|&pair| self.descend(&scene, pair, collector));
        later.extend(found.collect::<Vec<_>>().into_iter().flatten());
        for half in part.halves().into_iter().flatten() {
            self.search_part(half, &later, collector);
        }
    }

    /// Both bodies in a part of the step.
    pub(super) fn scene(&self, part: Part) -> Scene {
        let placed = [0, 1].map(|i: usize| Placed::new(self.motions[i], self.bodies[i].reach, part));
        Scene::new(part, placed, self.separation)
    }

    /// Splits pairs of nodes until there are enough for all threads, one level after the other.
    fn spread(&self, scene: &Scene, pairs: &[Nodes], collector: &impl Collect) -> (Vec<Nodes>, Vec<Nodes>) {
        let (mut shared, mut later) = (pairs.to_vec(), Vec::new());
        for _ in 0..SHARED.ilog2() {
            if shared.len() >= SHARED || shared.is_empty() {
                break;
            }
            let mut next = Vec::new();
            shared.retain(|&pair| self.first_near(scene, pair, collector).is_some());
            for pair in shared {
                match self.below(scene, pair) {
                    Below::Later => later.push(pair),
                    Below::Split(halves) => next.extend(halves),
                    Below::Leaves(_) => next.push(pair),
                }
            }
            shared = next;
        }
        (shared, later)
    }

    /// Examines all pairs of nodes below one, those that come near each other earlier first. Returns the
    /// pairs that need a shorter part.
    fn descend(&self, scene: &Scene, pair: Nodes, collector: &impl Collect) -> Vec<Nodes> {
        let (mut later, mut found) = (Vec::new(), Vec::new());
        let near = |pair: Nodes| Some((self.first_near(scene, pair, collector)?, pair));
        let mut stack: Vec<_> = near(pair).into_iter().collect();
        while let Some((time, pair)) = stack.pop() {
            if time > collector.until() {
                continue;
            }
            match self.below(scene, pair) {
                Below::Later => later.push(pair),
                Below::Split(halves) => {
                    let mut halves: ArrayVec<_, 2> = halves.into_iter().filter_map(near).collect();
                    halves.sort_by(|(a, _), (b, _)| b.total_cmp(a));
                    stack.extend(halves);
                }
                Below::Leaves(_) if self.has_plane_between(scene, pair) => {}
                Below::Leaves(leaves) => self.compare(scene, leaves, collector, &mut found),
            }
            if found.len() >= CHUNK {
                collector.decide(&found, scene.part);
                found.clear();
            }
        }
        collector.decide(&found, scene.part);
        later
    }

    /// A time before which the balls of two nodes are apart; `None` if they are as long as it matters.
    fn first_near(&self, scene: &Scene, pair: Nodes, collector: &impl Collect) -> Option<f64> {
        let spheres = [0, 1].map(|i: usize| self.bodies[i].tree.node(pair[i]).sphere);
        let places = [0, 1].map(|i: usize| scene.placed[i].at_ends(spheres[i].center));
        let time = scene.first_within(places, spheres[0].radius + spheres[1].radius)?;
        (time <= collector.until()).then_some(time)
    }

    /// The next to examine of nodes that come near each other: the larger one is split.
    pub(super) fn below(&self, scene: &Scene, pair: Nodes) -> Below<'a> {
        let [a, b]: [&'a Node; 2] = [0, 1].map(|i: usize| self.bodies[i].tree.node(pair[i]));
        let [first, second] = [a.sphere.radius, b.sphere.radius];
        if scene.is_too_long(first + second) {
            return Below::Later;
        }
        match (&a.parts, &b.parts) {
            (Parts::Leaf(one), Parts::Leaf(other)) => Below::Leaves([one, other]),
            (Parts::Nodes(parts), Parts::Nodes(_)) if first >= second => Below::of_first(parts, pair),
            (Parts::Nodes(parts), Parts::Leaf(_)) => Below::of_first(parts, pair),
            (_, Parts::Nodes(parts)) => Below::Split(parts.map(|part| [pair[0], part])),
        }
    }

    /// Adds the pairs of primitives of two leaves that come near each other.
    fn compare(
        &self,
        scene: &Scene,
        leaves: [&Leaf; 2],
        collector: &impl Collect,
        found: &mut Vec<Candidate>,
    ) {
        let [of_first, of_second] = [0, 1].map(|i: usize| self.bodies[i].tree.primitives(leaves[i]));
        for one in of_first {
            let place = scene.placed[0].at_ends(one.sphere.center);
            for other in of_second {
                let Some((kind, is_swapped)) = one.kind_with(other) else {
                    continue;
                };
                let places = [place, scene.placed[1].at_ends(other.sphere.center)];
                let radius = one.sphere.radius + other.sphere.radius;
                let time = scene.first_within(places, radius);
                let until = collector.until();
                if time.is_none_or(|time| time > until) || self.are_apart(scene, [one, other], until) {
                    continue;
                }
                let order = |pair: [usize; 2]| if is_swapped { [pair[1], pair[0]] } else { pair };
                let [first, second] = order([0, 1]);
                let ids = [one.id, other.id];
                found.push(Candidate {
                    kind,
                    bodies: order(self.ids),
                    primitives: [ids[first], ids[second]],
                    motions: self.relative(first).clone(),
                });
            }
        }
    }

    /// Returns true if planes separate two primitives in the part, up to a time: one in all of it, or one in
    /// each of its quarters, in which the deviation is a sixteenth.
    fn are_apart(&self, scene: &Scene, pair: [&Primitive; 2], until: f64) -> bool {
        if self.has_plane(scene, pair, until) {
            return true;
        }
        let quarters = scene.quarters.get_or_init(|| {
            let halves = scene.part.halves().into_iter().flatten();
            let quarters = halves.filter_map(Part::halves).flatten();
            quarters.map(|part| self.scene(part)).collect()
        });
        let is_apart = |quarter: &Scene| quarter.part.start > until || self.has_plane(quarter, pair, until);
        !quarters.is_empty() && quarters.iter().all(is_apart)
    }

    /// Returns true if a plane separates two primitives in the part, up to a time.
    fn has_plane(&self, scene: &Scene, pair: [&Primitive; 2], until: f64) -> bool {
        let places = self.places(scene, pair);
        let time = (until - scene.part.start) / scene.part.length() + 1e-12;
        let [one, other] = if time < 1.0 {
            places.map(|places| apart::until(&places, time))
        } else {
            places
        };
        apart::are_apart(&one, &other, scene.margin)
    }

    /// The places of the vertices of a primitive of each body.
    pub(super) fn places(&self, scene: &Scene, pair: [&Primitive; 2]) -> [Places; 2] {
        [0, 1].map(|i: usize| {
            let points = pair[i].points(&self.bodies[i].frame).into_iter();
            points.map(|point| scene.placed[i].at_ends(point)).collect()
        })
    }

    /// The motions of both bodies, with the first or the second one first.
    fn relative(&self, first: usize) -> &BodyPair {
        self.relative[first].get_or_init(|| {
            let [one, other] = [first, 1 - first].map(|i| self.given[i].clone());
            BodyPair::new(one, other)
        })
    }
}

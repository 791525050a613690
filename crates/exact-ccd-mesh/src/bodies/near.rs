//! The search of a step: pairs of bodies that come near each other, and their primitives.

use exact_ccd::motion::Chain;
use exact_ccd::{Options, Point, TimeOutOfStep};
use rayon::prelude::*;

use super::Bodies;
use super::collect::Collect;
use super::encounter::Encounter;
use super::error::BodiesError;
use super::part::Part;
use super::placed::Placed;
use super::world::World;
use crate::broad_phase::{Aabb, BoxPairs, Boxes, Bvh, PairCollector};

impl Bodies {
    /// Passes the pairs of primitives that come near each other to a collector.
    pub(super) fn search(
        &self,
        motions: &[Chain],
        options: Options,
        collector: &impl Collect,
    ) -> Result<(), BodiesError> {
        let world = World::new(self, motions, options);
        let encounters = self.encounters(&world, motions, options)?;
        encounters
            .par_iter()
            .for_each(|encounter| encounter.search(collector));
        Ok(())
    }

    /// The pairs of bodies that can collide and whose boxes meet, in increasing order.
    pub(super) fn encounters<'a>(
        &self,
        world: &'a World<'_>,
        motions: &'a [Chain],
        options: Options,
    ) -> Result<Vec<Encounter<'a>>, BodiesError> {
        TimeOutOfStep::check(options.until)?;
        let count = self.bodies.len();
        if motions.len() != count {
            return Err(BodiesError::MotionCount {
                motions: motions.len(),
                bodies: count,
            });
        }
        let pairs = world.near_pairs()?.into_iter();
        let pairs = pairs.map(|pair| pair.map(|id| id as usize));
        let pairs = pairs.filter(|&pair| self.can_collide.allows(pair));
        Ok(pairs.map(|ids| Encounter::new(ids, world, motions)).collect())
    }
}

impl World<'_> {
    /// The pairs of bodies whose boxes meet, in increasing order.
    fn near_pairs(&self) -> Result<Vec<[u32; 2]>, BodiesError> {
        let bodies = self.bodies.par_iter().zip(&*self.motions);
        let boxes: Vec<[Aabb; 1]> = bodies
            .map(|(body, motion)| {
                let Some(root) = body.tree.root() else {
                    return [Aabb::of([0.0; 3])];
                };
                let placed = Placed::new(motion, body.reach, Part::WHOLE);
                let [start, end] = placed.at_ends(root.sphere.center).map(|x: Point| Aabb::of(x));
                let margin = (root.sphere.radius + placed.deviation + placed.error) * (1.0 + 1e-12);
                [start.union(&end).inflated(margin).inflated(self.separation)]
            })
            .collect();
        let too_many = |error| BodiesError::TooManyBodies { error };
        let boxes = Boxes::new(&boxes).map_err(too_many)?;
        let collector = PairCollector::default();
        let _ = Bvh.within(&boxes, &|pairs: &[[u32; 2]]| collector.add(pairs.iter().copied()));
        Ok(collector.into_sorted())
    }
}

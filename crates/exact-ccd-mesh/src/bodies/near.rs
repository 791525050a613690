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
use crate::broad_phase::{Aabb, BoxPairs, Boxes, Bvh, PairCollector};

impl Bodies {
    /// Passes the pairs of primitives that come near each other to a collector.
    pub(super) fn search(
        &self,
        motions: &[Chain],
        options: Options,
        collector: &impl Collect,
    ) -> Result<(), BodiesError> {
        let encounters = self.encounters(motions, options)?;
        encounters
            .par_iter()
            .for_each(|encounter| encounter.search(collector));
        Ok(())
    }

    /// The pairs of bodies that can collide and whose boxes meet, in increasing order.
    pub(super) fn encounters<'a>(
        &'a self,
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
        let pairs = self.near_pairs(motions, options)?.into_iter();
        let pairs = pairs.map(|pair| pair.map(|id| id as usize));
        let pairs = pairs.filter(|&pair| self.can_collide.allows(pair));
        let encounter = |ids: [usize; 2]| {
            let bodies = ids.map(|id| &self.bodies[id]);
            Encounter::new(ids, bodies, ids.map(|id| &motions[id]), options)
        };
        Ok(pairs.map(encounter).collect())
    }

    /// The pairs of bodies whose boxes meet, in increasing order.
    fn near_pairs(&self, motions: &[Chain], options: Options) -> Result<Vec<[u32; 2]>, BodiesError> {
        let d = options.separation.get();
        let bodies = self.bodies.par_iter().zip(motions);
        let boxes: Vec<[Aabb; 1]> = bodies
            .map(|(body, motion)| {
                let Some(root) = body.tree.root() else {
                    return [Aabb::of([0.0; 3])];
                };
                let placed = Placed::new(motion, body.reach, Part::WHOLE);
                let [start, end] = placed.at_ends(root.sphere.center).map(|x: Point| Aabb::of(x));
                let margin = (root.sphere.radius + placed.deviation + placed.error) * (1.0 + 1e-12);
                [start.union(&end).inflated(margin).inflated(d)]
            })
            .collect();
        let too_many = |error| BodiesError::TooManyBodies { error };
        let boxes = Boxes::new(&boxes).map_err(too_many)?;
        let collector = PairCollector::default();
        let _ = Bvh.within(&boxes, &|pairs: &[[u32; 2]]| collector.add(pairs.iter().copied()));
        Ok(collector.into_sorted())
    }
}

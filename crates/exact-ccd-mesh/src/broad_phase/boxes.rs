//! The boxes of many primitives, as the input of a broad phase.

use exact_ccd::Point;
use rayon::prelude::*;

use super::aabb::Aabb;
use super::block::{Block, LANES};
use super::labels::Labels;
use super::moving_box::MovingBox;
use super::order::order;
use super::primitive_count::{TooManyPrimitives, check_primitive_count};

/// The least number of blocks that a thread fills in one task: 50,000 to 100,000 instructions. One
/// thread finishes less work than that before another thread wakes up.
const GRAIN: usize = 128;

/// Boxes that move in straight lines during a step, in blocks of eight that are near each other.
///
/// Each box has an index; the indices of some of a mesh's primitives have gaps. Coordinates are
/// relative to a common origin and rounded to single precision, such that boxes that meet still meet.
///
/// The boxes of a mesh have their vertices as labels. Pairs with a common label are never a contact:
/// the broad phases of this crate pass none of them on, another one may.
#[derive(Clone, Debug)]
pub struct Boxes<const T: usize> {
    /// The indices of the boxes, block by block.
    pub(super) ids: Vec<u32>,
    /// The last block is filled up with empty boxes.
    pub(super) blocks: Vec<Block<T>>,
    /// The box around each block.
    pub(super) around: Vec<MovingBox<T>>,
    /// The labels of the boxes.
    pub(super) labels: Labels,
}

impl<const T: usize> Boxes<T> {
    /// Boxes at t = 0 and at t = 1, or boxes at rest (T = 1). Their indices are those in the slice.
    ///
    /// # Errors
    /// [`TooManyPrimitives`], if indices of 32 bits do not suffice.
    pub fn new(boxes: &[[Aabb; T]]) -> Result<Self, TooManyPrimitives> {
        const { assert!(T == 1 || T == 2, "boxes rest, or move from one place to another") };
        check_primitive_count(boxes.len())?;
        let centers: Vec<Point> = boxes.par_iter().map(center).collect();
        let mut all = Self::in_order(order(&centers, (0..boxes.len() as u32).collect()));
        all.replace(|_| true, |id| MovingBox::new(&boxes[id as usize], &[[0.0; 3]; T]));
        Ok(all)
    }

    /// Empty boxes with these indices, in this order.
    pub(crate) fn in_order(ids: Vec<u32>) -> Self {
        Self::labelled(ids, |_| [])
    }

    /// Empty boxes with these indices, in this order, and their labels.
    pub(crate) fn labelled<const N: usize>(ids: Vec<u32>, labels: impl Fn(u32) -> [u32; N]) -> Self {
        let count = ids.len().div_ceil(LANES);
        Self {
            blocks: vec![Block::EMPTY; count],
            around: vec![MovingBox::EMPTY; count],
            labels: Labels::new(&ids, labels),
            ids,
        }
    }

    /// Sets all boxes of each block that holds a chosen primitive.
    pub(crate) fn replace(
        &mut self,
        is_chosen: impl Fn(u32) -> bool + Sync,
        moving: impl Fn(u32) -> MovingBox<T> + Sync,
    ) {
        let blocks = self.blocks.par_iter_mut().zip(&mut self.around);
        let blocks = blocks.zip(self.ids.par_chunks(LANES)).with_min_len(GRAIN);
        let chosen = blocks.filter(|(_, ids)| ids.iter().any(|&id| is_chosen(id)));
        chosen.for_each(|((block, around), ids)| fill(block, around, ids, |&id| moving(id)));
    }

    /// The boxes of some of the primitives.
    pub(crate) fn only(&self, is_chosen: impl Fn(u32) -> bool) -> Self {
        let places = (0..self.ids.len()).filter(|&place| is_chosen(self.ids[place]));
        let places: Vec<usize> = places.collect();
        let moving = |place: usize| self.blocks[place / LANES].get(place % LANES);
        let count = places.len().div_ceil(LANES);
        let mut only = Self {
            ids: places.iter().map(|&place| self.ids[place]).collect(),
            blocks: vec![Block::EMPTY; count],
            around: vec![MovingBox::EMPTY; count],
            labels: self.labels.only(&places),
        };
        let blocks = only.blocks.iter_mut().zip(&mut only.around);
        for ((block, around), eight) in blocks.zip(places.chunks(LANES)) {
            fill(block, around, eight, |&place| moving(place));
        }
        only
    }

    /// One block in every `stride`.
    pub(crate) fn sample(&self, stride: usize) -> Self {
        let ids = self.ids.chunks(LANES).step_by(stride).flatten();
        Self {
            ids: ids.copied().collect(),
            blocks: self.blocks.iter().step_by(stride).copied().collect(),
            around: self.around.iter().step_by(stride).copied().collect(),
            labels: self.labels.sample(stride),
        }
    }

    /// The number of boxes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Returns true if there are no boxes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// The index of each box, and the box at the start and at the end (T = 2) or at rest (T = 1):
    /// relative to a common origin, and rounded.
    pub fn iter(&self) -> impl Iterator<Item = (u32, [Aabb; T])> {
        let boxes = self
            .blocks
            .iter()
            .flat_map(|block| (0..LANES).map(|lane| block.get(lane)));
        self.ids.iter().copied().zip(boxes.map(|moving| moving.places()))
    }

    /// The indices of the boxes, block by block.
    pub(crate) fn ids(&self) -> &[u32] {
        &self.ids
    }

    /// A bit for each place of a block that holds a box.
    #[inline]
    pub(super) fn filled(&self, block: usize) -> u32 {
        let count = (self.ids.len() - LANES * block).min(LANES);
        (1 << count) - 1
    }
}

/// Sets the first boxes of a block, and the box around them.
#[inline(always)]
fn fill<const T: usize, I>(
    block: &mut Block<T>,
    around: &mut MovingBox<T>,
    ids: &[I],
    moving: impl Fn(&I) -> MovingBox<T>,
) {
    let mut union = MovingBox::EMPTY;
    for (lane, id) in ids.iter().enumerate() {
        let moving = moving(id);
        block.set(lane, &moving);
        union = union.union(&moving);
    }
    *around = union;
}

/// The center of a box at the start; the origin for the empty box, which has none.
fn center<const T: usize>(places: &[Aabb; T]) -> Point {
    let center = places.first().map_or([0.0; 3], Aabb::center);
    center.map(|x| if x.is_finite() { x } else { 0.0 })
}

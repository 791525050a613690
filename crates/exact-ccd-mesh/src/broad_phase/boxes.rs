//! The boxes of many primitives, as the input of a broad phase.

use std::sync::Arc;

use exact_ccd::Point;
use rayon::prelude::*;

use super::aabb::Aabb;
use super::block::{Block, LANES};
use super::members::Members;
use super::moving_box::MovingBox;
use super::order::order;
use super::primitive_count::{TooManyPrimitives, check_primitive_count};
use super::units::Units;

/// The least number of blocks that a thread fills in one task: 50,000 to 100,000 instructions. One
/// thread finishes less work than that before another thread wakes up.
const GRAIN: usize = 128;

/// Boxes that move in straight lines during a step, in blocks of eight that are near each other.
///
/// Each box has an index; the indices of some of a mesh's primitives have gaps. Coordinates are
/// relative to one origin for each time and rounded to single precision, such that boxes that meet still
/// meet. For a mesh whose size is far from 1, they are multiplied by a power of two first.
///
/// The boxes of a mesh have their vertices as labels. Pairs with a common label are never a contact:
/// the broad phases of this crate pass none of them on, another one may.
#[derive(Clone, Debug)]
pub struct Boxes<const T: usize> {
    pub(super) members: Arc<Members>,
    /// The last block is filled up with empty boxes.
    pub(super) blocks: Vec<Block<T>>,
    /// The box around each block.
    pub(super) around: Vec<MovingBox<T>>,
}

impl<const T: usize> Boxes<T> {
    /// Boxes at t = 0 and at t = 1, or boxes at rest (T = 1). The index of a box is its place in the slice.
    /// A side that is not a number counts as unbounded.
    ///
    /// Coordinates are relative to 0: far from there, boxes that do not meet may meet after rounding.
    ///
    /// # Errors
    /// [`TooManyPrimitives`], if indices of 32 bits do not suffice.
    pub fn new(boxes: &[[Aabb; T]]) -> Result<Self, TooManyPrimitives> {
        Self::relative_to(boxes, &[[0.0; 3]; T])
    }

    /// [`new`](Self::new), with coordinates relative to an origin at each time: a place near the boxes. Only
    /// boxes with the same origins can be compared. A coordinate of an origin that is not finite counts as 0.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn relative_to(boxes: &[[Aabb; T]], origins: &[Point; T]) -> Result<Self, TooManyPrimitives> {
        const { assert!(T == 1 || T == 2, "boxes rest, or move from one place to another") };
        check_primitive_count(boxes.len())?;
        let ids = order((0..boxes.len() as u32).collect(), |id| {
            center(&boxes[id as usize])
        });
        let mut all = Self::of(Arc::new(Members::new(ids, |_| [])));
        let places = |id: u32| boxes[id as usize].each_ref().map(Aabb::without_nan);
        let units = Units::relative_to(origins.map(finite));
        all.replace(|_| true, |id| MovingBox::new(&places(id), &units));
        Ok(all)
    }

    /// Empty boxes.
    pub(crate) fn of(members: Arc<Members>) -> Self {
        let count = members.block_count();
        Self {
            blocks: vec![Block::EMPTY; count],
            around: vec![MovingBox::EMPTY; count],
            members,
        }
    }

    /// Sets all boxes of each block that holds a chosen primitive.
    pub(crate) fn replace(
        &mut self,
        is_chosen: impl Fn(u32) -> bool + Sync,
        moving: impl Fn(u32) -> MovingBox<T> + Sync,
    ) {
        let blocks = self.blocks.par_iter_mut().zip(&mut self.around);
        let blocks = blocks
            .zip(self.members.ids().par_chunks(LANES))
            .with_min_len(GRAIN);
        let chosen = blocks.filter(|(_, ids)| ids.iter().any(|&id| is_chosen(id)));
        chosen.for_each(|((block, around), ids)| fill(block, around, ids, |&id| moving(id)));
    }

    /// The boxes of some of the primitives.
    pub(crate) fn only(&self, is_chosen: impl Fn(u32) -> bool) -> Self {
        let ids = self.members.ids();
        self.at((0..ids.len()).filter(|&place| is_chosen(ids[place])).collect())
    }

    /// One block in every `stride`.
    pub(crate) fn sample(&self, stride: usize) -> Self {
        let places = 0..self.members.ids().len();
        self.at(places
            .filter(|place| (place / LANES).is_multiple_of(stride))
            .collect())
    }

    /// The boxes at some places.
    fn at(&self, places: Vec<usize>) -> Self {
        let moving = |place: usize| self.blocks[place / LANES].get(place % LANES);
        let mut only = Self::of(Arc::new(self.members.at(&places)));
        let blocks = only.blocks.iter_mut().zip(&mut only.around);
        for ((block, around), eight) in blocks.zip(places.chunks(LANES)) {
            fill(block, around, eight, |&place| moving(place));
        }
        only
    }

    /// The number of boxes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.members.ids().len()
    }

    /// Returns true if there are no boxes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.members.ids().is_empty()
    }

    /// The index of each box, and the box at the start and at the end (T = 2) or at rest (T = 1):
    /// in the coordinates of these boxes, and rounded.
    pub fn iter(&self) -> impl Iterator<Item = (u32, [Aabb; T])> {
        let boxes = self
            .blocks
            .iter()
            .flat_map(|block| (0..LANES).map(|lane| block.get(lane)));
        self.members
            .ids()
            .iter()
            .copied()
            .zip(boxes.map(|moving| moving.places()))
    }

    /// The indices of the boxes and their labels.
    pub(crate) fn members(&self) -> &Arc<Members> {
        &self.members
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
    finite(places.first().map_or([0.0; 3], Aabb::center))
}

/// The point, with 0 in place of coordinates that are not finite.
fn finite(point: Point) -> Point {
    point.map(|x| if x.is_finite() { x } else { 0.0 })
}

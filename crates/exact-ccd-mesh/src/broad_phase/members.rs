//! The indices of boxes, and their labels: two boxes with a common label are no pair.

use fearless_simd::prelude::*;
use fearless_simd::{mask32x8, u32x8};

use super::block::LANES;

/// The indices of boxes in blocks of eight, and as many labels for each box.
///
/// The labels of a primitive are its vertices. Boxes of neighbours in a mesh always meet, and most pairs
/// that meet on a smooth surface are neighbours.
#[derive(Clone, Debug, Default)]
pub(crate) struct Members {
    /// The indices, block by block.
    ids: Vec<u32>,
    /// The number of labels of each box.
    label_count: usize,
    /// The labels, block by block, and in a block label by label. Places after the last box have no meaning.
    rows: Vec<[u32; LANES]>,
}

/// N labels of each box of a block.
type Rows<const N: usize> = [[u32; LANES]; N];

impl Members {
    /// Boxes with these indices, in this order, and their labels.
    pub(crate) fn new<const N: usize>(ids: Vec<u32>, labels: impl Fn(u32) -> [u32; N]) -> Self {
        let mut rows = Vec::with_capacity(N * ids.len().div_ceil(LANES));
        for eight in ids.chunks(LANES) {
            let mut block = [[0; LANES]; N];
            for (lane, &id) in eight.iter().enumerate() {
                for (row, label) in block.iter_mut().zip(labels(id)) {
                    row[lane] = label;
                }
            }
            rows.extend(block);
        }
        Self {
            ids,
            label_count: N,
            rows,
        }
    }

    /// The indices, block by block.
    pub(crate) fn ids(&self) -> &[u32] {
        &self.ids
    }

    /// The number of blocks.
    pub(super) fn block_count(&self) -> usize {
        self.ids.len().div_ceil(LANES)
    }

    /// A bit for each place of a block that holds a box.
    #[inline]
    pub(super) fn filled(&self, block: usize) -> u32 {
        let count = (self.ids.len() - LANES * block).min(LANES);
        (1 << count) - 1
    }

    /// The number of labels of each box.
    pub(super) fn label_count(&self) -> usize {
        self.label_count
    }

    /// The first N labels of each box of a block.
    #[inline(always)]
    pub(super) fn labels<const N: usize>(&self, block: usize) -> &Rows<N> {
        let rows = &self.rows[self.label_count * block..];
        rows.first_chunk().expect("there are at least N labels")
    }

    /// The boxes at some places.
    pub(super) fn at(&self, places: &[usize]) -> Self {
        let mut rows = Vec::with_capacity(self.label_count * places.len().div_ceil(LANES));
        for eight in places.chunks(LANES) {
            for label in 0..self.label_count {
                let mut row = [0; LANES];
                for (to, &place) in row.iter_mut().zip(eight) {
                    *to = self.rows[self.label_count * (place / LANES) + label][place % LANES];
                }
                rows.push(row);
            }
        }
        Self {
            ids: places.iter().map(|&place| self.ids[place]).collect(),
            rows,
            ..*self
        }
    }
}

/// A bit for each box of a block: set if it has a label in common with the box in a lane of another block.
#[inline(always)]
pub(super) fn common<S: Simd, const M: usize, const N: usize>(
    simd: S,
    rows: &Rows<N>,
    others: &Rows<M>,
    lane: usize,
) -> u32 {
    let mut common = mask32x8::splat(simd, false);
    for other in others {
        let label = u32x8::splat(simd, other[lane % LANES]);
        for row in rows {
            common |= u32x8::from_slice(simd, row).simd_eq(label);
        }
    }
    common.to_bitmask() as u32
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use fastrand::Rng;

    use super::Members;
    use crate::broad_phase::{
        Aabb, AllPairs, BoxPairs, Boxes, Bvh, MovingBox, PairCollector, PairSink, Sweep, Units,
    };

    /// Boxes near each other. Many of their labels are common to two boxes.
    fn boxes<const N: usize>(rng: &mut Rng, count: u32) -> (Boxes<1>, Vec<(Aabb, [u32; N])>) {
        let corner = |rng: &mut Rng| [0, 1, 2].map(|_| f64::from(rng.u8(..8)));
        let all: Vec<(Aabb, [u32; N])> = (0..count)
            .map(|_| {
                let aabb = Aabb::of(corner(rng)).union(&Aabb::of(corner(rng)));
                (aabb, [(); N].map(|()| rng.u32(..24)))
            })
            .collect();
        let mut ids: Vec<u32> = (0..count).collect();
        rng.shuffle(&mut ids);
        let mut boxes = Boxes::of(Arc::new(Members::new(ids, |id| all[id as usize].1)));
        boxes.replace(
            |_| true,
            |id| MovingBox::new(&[all[id as usize].0], &Units::relative_to([[0.0; 3]])),
        );
        (boxes, all)
    }

    fn found(search: impl Fn(&PairSink<'_>) -> ControlFlow<()>) -> Vec<[u32; 2]> {
        let collector = PairCollector::default();
        let _ = search(&|pairs| collector.add(pairs.iter().copied()));
        collector.into_sorted()
    }

    /// The pairs of chosen boxes and others that meet and have no label in common.
    fn apart<const M: usize, const N: usize>(
        a: &[(Aabb, [u32; M])],
        b: &[(Aabb, [u32; N])],
        is_chosen: impl Fn([u32; 2]) -> bool,
    ) -> Vec<[u32; 2]> {
        let mut apart = Vec::new();
        for (i, (aabb, labels)) in (0..).zip(a) {
            for (j, (other, others)) in (0..).zip(b) {
                let are_apart = !labels.iter().any(|label| others.contains(label));
                if is_chosen([i, j]) && aabb.overlaps(other) && are_apart {
                    apart.push([i, j]);
                }
            }
        }
        apart
    }

    fn assert_between<const M: usize, const N: usize>() {
        let mut rng = Rng::with_seed(0);
        for count in [1, 8, 9, 100] {
            let (a, of_a) = boxes::<M>(&mut rng, count);
            let (b, of_b) = boxes::<N>(&mut rng, count + 3);
            let is_in_sample = |id: u32| {
                a.members()
                    .ids()
                    .chunks(8)
                    .step_by(3)
                    .any(|ids| ids.contains(&id))
            };
            for (chosen, expected) in [
                (a.clone(), apart(&of_a, &of_b, |_| true)),
                (a.only(|id| id % 3 == 0), apart(&of_a, &of_b, |[i, _]| i % 3 == 0)),
                (a.sample(3), apart(&of_a, &of_b, |[i, _]| is_in_sample(i))),
            ] {
                assert_eq!(found(|sink| AllPairs.between(&chosen, &b, sink)), expected);
                assert_eq!(found(|sink| Bvh.between(&chosen, &b, sink)), expected);
                assert_eq!(found(|sink| Sweep.between(&chosen, &b, sink)), expected);
            }
        }
    }

    fn assert_within<const N: usize>() {
        let mut rng = Rng::with_seed(1);
        for count in [1, 8, 9, 100] {
            let (boxes, all) = boxes::<N>(&mut rng, count);
            let expected = apart(&all, &all, |[i, j]| i < j);
            assert_eq!(found(|sink| AllPairs.within(&boxes, sink)), expected);
            assert_eq!(found(|sink| Bvh.within(&boxes, sink)), expected);
            assert_eq!(found(|sink| Sweep.within(&boxes, sink)), expected);
        }
    }

    #[test]
    fn boxes_with_a_common_label_are_no_pair() {
        assert_within::<0>();
        assert_within::<1>();
        assert_within::<2>();
        assert_between::<0, 0>();
        assert_between::<1, 1>();
        assert_between::<1, 2>();
        assert_between::<1, 3>();
        assert_between::<2, 2>();
        assert_between::<2, 3>();
    }
}

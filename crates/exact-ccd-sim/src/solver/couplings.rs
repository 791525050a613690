//! The blocks of the elastic elements in the sparsity pattern.

use super::form::Form;
use super::pattern::{Pattern, key};
use super::unknowns::Unknowns;
use crate::carriers::Carriers;
use crate::energies::elasticity::Twist;
use crate::energies::term::{Block, Energy, pairs};
use crate::system::System;

/// The pairs of unknowns that share an elastic element, and the places of the blocks of all elements.
pub(crate) struct Couplings {
    unknowns: Unknowns,
    /// The vertices of the twisted chains.
    chains: Vec<Vec<u32>>,
    /// The pairs that share an element or a twisted chain.
    pub(super) pattern: Pattern,
    /// The places of the blocks of each element, in the order of [`pairs`].
    pub(super) places: Vec<Option<Place>>,
}

/// The place of a block of an element in a sum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    block: u32,
    /// True if the sum has the transposed block.
    is_transposed: bool,
}

/// Adds the keys of the pairs of unknowns on which the same term of a sum depends.
pub(super) fn add_keys(keys: &mut Vec<u64>, unknowns: &Unknowns, carriers: &Carriers, form: &Form<'_>) {
    for vertices in form.terms.iter().map(|term| carriers.unknowns(term.vertices())) {
        for (place, &a) in vertices.iter().enumerate() {
            let Some(a) = unknowns.number(a) else { continue };
            let others = vertices[..place].iter().filter_map(|&b| unknowns.number(b));
            keys.extend(others.map(|b| key(a, b)));
        }
    }
}

impl Couplings {
    /// The couplings of a system.
    pub(super) fn new(system: &System, twists: &[Twist], unknowns: &Unknowns) -> Self {
        let (mut keys, carriers) = (Vec::new(), &system.carriers);
        let elements = Form::elastic(system, 1.0);
        add_keys(&mut keys, unknowns, carriers, &elements);
        add_keys(&mut keys, unknowns, carriers, &Form::of(twists, 1.0));
        let pattern = Pattern::new(unknowns.len(), keys);
        let mut places = Vec::new();
        for element in &elements.terms {
            let vertices = carriers.unknowns(element.vertices());
            let place =
                |[row, column]: [usize; 2]| Place::of(&pattern, unknowns, [vertices[row], vertices[column]]);
            places.extend(pairs(vertices.len()).map(place));
        }
        Self {
            unknowns: unknowns.clone(),
            chains: twists.iter().map(|twist| twist.vertices().to_vec()).collect(),
            pattern,
            places,
        }
    }

    /// The couplings of a system. They are kept while chains and unknowns stay the same.
    pub(super) fn kept<'a>(
        last: &'a mut Option<Self>,
        system: &System,
        twists: &[Twist],
        unknowns: &Unknowns,
    ) -> &'a Self {
        let is_same = |last: &Self| {
            let chains = last.chains.iter().map(Vec::as_slice);
            last.unknowns == *unknowns && chains.eq(twists.iter().map(Energy::vertices))
        };
        let same = last.take().filter(is_same);
        last.insert(same.unwrap_or_else(|| Self::new(system, twists, unknowns)))
    }
}

impl Place {
    /// The place of the block of two vertices. `None` if one of them is not unknown.
    pub(super) fn of(pattern: &Pattern, unknowns: &Unknowns, [row, column]: [u32; 2]) -> Option<Self> {
        let (row, column) = (unknowns.number(row)?, unknowns.number(column)?);
        let block = pattern.place(row, column)? as u32;
        let is_transposed = row < column;
        Some(Self { block, is_transposed })
    }

    /// This block's place after the blocks of the pattern have moved to `places`.
    pub(super) fn among(self, places: &[u32]) -> Option<Self> {
        let block = *places.get(self.block as usize)?;
        Some(Self { block, ..self })
    }

    /// Adds a block, times a factor.
    pub(super) fn add(self, blocks: &mut [Block], block: &Block, factor: f64) {
        let sum = &mut blocks[self.block as usize];
        if self.is_transposed {
            for (place, value) in block.iter().enumerate() {
                sum[3 * (place % 3) + place / 3] += factor * value;
            }
        } else {
            for (sum, value) in sum.iter_mut().zip(block) {
                *sum += factor * value;
            }
        }
    }
}

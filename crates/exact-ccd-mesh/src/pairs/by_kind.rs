//! Values that differ between the kinds of pairs.

use std::ops::{Index, IndexMut};

use exact_ccd::AnyKind;

use super::pair::Pair;

/// One value for each kind of pairs, which is its index.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ByKind<T>([T; AnyKind::ALL.len()]);

/// Numbers of pairs, by their kind.
pub type PairCounts = ByKind<usize>;

impl<T> ByKind<T> {
    /// The values with their kinds, in the order of the kinds.
    pub fn iter(&self) -> impl Iterator<Item = (AnyKind, &T)> {
        AnyKind::ALL.iter().copied().zip(&self.0)
    }

    /// The values of a function.
    pub(crate) fn map<U>(self, f: impl FnMut(T) -> U) -> ByKind<U> {
        ByKind(self.0.map(f))
    }

    /// The values of a function of references.
    pub(crate) fn map_ref<U>(&self, f: impl FnMut(&T) -> U) -> ByKind<U> {
        ByKind(self.0.each_ref().map(f))
    }
}

impl<T> Index<AnyKind> for ByKind<T> {
    type Output = T;

    fn index(&self, kind: AnyKind) -> &T {
        &self.0[kind as usize]
    }
}

impl<T> IndexMut<AnyKind> for ByKind<T> {
    fn index_mut(&mut self, kind: AnyKind) -> &mut T {
        &mut self.0[kind as usize]
    }
}

impl PairCounts {
    /// The number of pairs of all kinds.
    #[must_use]
    pub fn total(&self) -> usize {
        self.0.iter().sum()
    }
}

impl FromIterator<Pair> for PairCounts {
    fn from_iter<I: IntoIterator<Item = Pair>>(pairs: I) -> Self {
        let mut counts = Self::default();
        for pair in pairs {
            counts[pair.kind()] += 1;
        }
        counts
    }
}

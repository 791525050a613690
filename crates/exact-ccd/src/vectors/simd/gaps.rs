//! The gaps of the queries of a batch.

use core::marker::PhantomData;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

use super::planes::LANES;
use crate::filter::{Gap, Touching, Within};
use crate::tables::Tables;
use crate::values::{Separation, Separations};
use crate::vectors::queries::separation_of;

/// The gap of each query of a batch, by its index.
pub(super) trait Gaps: Copy {
    type One: Gap<f64>;
    type Eight<S: Simd>: Gap<f64x8<S>>;

    fn separation(self, index: usize) -> Separation;

    fn of(self, index: usize) -> Self::One;

    /// The gaps of at most eight queries, side by side.
    fn of_eight<S: Simd>(self, simd: S, indices: &[usize]) -> Self::Eight<S>;
}

/// Contact.
impl Gaps for Touching {
    type One = Self;
    type Eight<S: Simd> = Self;

    #[inline(always)]
    fn separation(self, _: usize) -> Separation {
        Separation::ZERO
    }

    #[inline(always)]
    fn of(self, _: usize) -> Self {
        self
    }

    #[inline(always)]
    fn of_eight<S: Simd>(self, _: S, _: &[usize]) -> Self {
        self
    }
}

/// Separations of queries.
pub(super) struct Separated<'a, K, V> {
    queries: &'a [V],
    separations: Separations<'a>,
    kind: PhantomData<K>,
}

impl<'a, K, V> Separated<'a, K, V> {
    pub(super) fn new(queries: &'a [V], separations: Separations<'a>) -> Self {
        Self {
            queries,
            separations,
            kind: PhantomData,
        }
    }
}

impl<K, V> Clone for Separated<'_, K, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<K, V> Copy for Separated<'_, K, V> {}

impl<K: Tables, V: AsRef<[u32]>> Gaps for Separated<'_, K, V> {
    type One = Within<f64>;
    type Eight<S: Simd> = Within<f64x8<S>>;

    #[inline(always)]
    fn separation(self, index: usize) -> Separation {
        separation_of::<K>(self.separations, self.queries[index].as_ref())
    }

    #[inline(always)]
    fn of(self, index: usize) -> Self::One {
        Within(self.separation(index).get())
    }

    #[inline(always)]
    fn of_eight<S: Simd>(self, simd: S, indices: &[usize]) -> Self::Eight<S> {
        let mut d = [0.0; LANES];
        for (d, &index) in d.iter_mut().zip(indices) {
            *d = self.separation(index).get();
        }
        Within(f64x8::from_slice(simd, &d))
    }
}

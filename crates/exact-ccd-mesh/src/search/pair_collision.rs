//! Pairs that come within their minimum distance.

use exact_ccd::{Collision, Kind, Options, Separation};

/// A pair of primitives that come within their minimum distance.
pub(crate) struct PairCollision<'a, K: Kind> {
    /// The collision within the distance for pairs that start beyond it.
    collision: Collision<'a, K>,
    /// The inner distance, if there is one.
    inner: Option<Separation>,
    /// The last time that counts.
    until: f64,
}

impl<'a, K: Kind> PairCollision<'a, K> {
    /// The pair of a collision whose time counts.
    pub(crate) fn new(collision: Collision<'a, K>, inner: Option<Separation>, until: f64) -> Self {
        Self {
            collision,
            inner,
            until,
        }
    }

    /// Returns true if the pair is within its distance at t = 0.
    pub(crate) fn starts_within(&self) -> bool {
        self.collision.time().is_start()
    }

    /// The collision that counts as contact: a pair that starts within its distance may come nearer,
    /// up to the inner one, if that is less.
    pub(crate) fn contact(self) -> Option<Collision<'a, K>> {
        match self.inner {
            Some(inner) if inner < self.collision.separation() && self.starts_within() => {
                let options = Options::within(inner).until(self.until);
                self.collision.query().collision(options)
            }
            _ => Some(self.collision),
        }
    }
}

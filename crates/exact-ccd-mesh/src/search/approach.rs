//! Pairs that come within their minimum distance.

use exact_ccd::{Collision, ContactTime, Kind, Options, Separation};

/// A pair of primitives that come within their minimum distance.
pub(crate) struct Approach<'a, K> {
    /// The collision within the distance for pairs that start beyond it.
    collision: Collision<'a, K>,
    /// The inner distance, if there is one.
    inner: Option<Separation>,
    /// The last time that counts.
    until: f64,
}

/// The times of an approach.
pub(crate) struct Times {
    /// True if the pair is within its distance at t = 0.
    pub(crate) starts_within: bool,
    /// The first time of contact.
    pub(crate) contact: Option<ContactTime>,
}

impl<'a, K: Kind> Approach<'a, K> {
    /// The approach by a collision whose time counts.
    pub(crate) fn new(collision: Collision<'a, K>, inner: Option<Separation>, until: f64) -> Self {
        Self {
            collision,
            inner,
            until,
        }
    }

    /// The collision that counts as contact: a pair that starts within its distance may come nearer,
    /// up to the inner one.
    pub(crate) fn contact(self) -> Option<Collision<'a, K>> {
        match self.nearer() {
            Some(inner) if self.collision.time().is_start() => self.collision.query().collision(inner),
            _ => Some(self.collision),
        }
    }

    /// The times of the approach.
    pub(crate) fn times(&self) -> Times {
        let first = self.collision.time();
        let starts_within = first.is_start();
        let contact = match self.nearer() {
            Some(inner) if starts_within => self
                .collision
                .query()
                .collision(inner)
                .map(|collision| collision.time()),
            _ => Some(first),
        };
        Times {
            starts_within,
            contact,
        }
    }

    /// The contact within the inner distance, if that is less than the other one.
    fn nearer(&self) -> Option<Options> {
        let inner = self.inner.filter(|&inner| inner < self.collision.separation())?;
        Some(Options::within(inner).until(self.until))
    }
}

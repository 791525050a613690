//! A root of a quadratic.

use super::common_root::{Quadratic, raised, vanishes_at_quadratic_root};
use super::dyadic::Dyadic;
use super::length::Volume;
use super::window::{Window, has_one_root, sign_at};
use crate::numbers::cubic::Root;

/// The root of a quadratic in a bracket of a window.
#[derive(Clone, Debug)]
pub(crate) struct QuadraticRoot {
    pub(super) quadratic: Quadratic,
    pub(super) window: Window,
    pub(super) root: Root,
}

impl QuadraticRoot {
    /// Returns true if another quadratic certainly vanishes at this root.
    pub(super) fn is_root_of(&self, other: &Quadratic) -> bool {
        vanishes_at_quadratic_root(other, &self.quadratic, self.bracket())
    }

    /// Returns true if this root is before another one, if that is certain.
    ///
    /// If both are alone in their brackets and where these overlap, and one is a root of the other's quadratic,
    /// they are the same root.
    pub(super) fn is_before(&self, other: &Self) -> Option<bool> {
        let [[low, high], [other_low, other_high]] = [self.bracket(), other.bracket()];
        if high <= other_low || other_high <= low {
            return Some(high <= other_low);
        }
        let overlap = [low.max(other_low), high.min(other_high)];
        let is_inside = |root: &Self| {
            let [low, high] = overlap.map(|time| sign_at(&root.raised(), time));
            low.is_ne() && low.reverse() == high
        };
        let are_same = is_inside(self)
            && is_inside(other)
            && has_one_root(&other.raised(), other.bracket())
            && self.is_root_of(&other.quadratic);
        are_same.then_some(false)
    }

    /// Two times around the root.
    fn bracket(&self) -> [Dyadic; 2] {
        self.window.bracket(&self.root)
    }

    /// The quadratic, raised to a cubic.
    pub(super) fn raised(&self) -> [Volume; 4] {
        raised(&self.quadratic)
    }
}

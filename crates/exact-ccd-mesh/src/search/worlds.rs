//! Searches for many worlds.

use std::fmt;
use std::sync::{Mutex, PoisonError};

use super::detector::Detector;

/// Searches for the steps of many worlds, which have one mesh and positions of their own: a [`Detector`]
/// each, or a type that has one. There are as many as worlds were searched at the same time, and each keeps
/// its memory from world to world.
///
/// ```
/// use exact_ccd::CONTACT;
/// use exact_ccd_mesh::{Detector, TriangleMesh, Worlds};
///
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let at = |z: f64| [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [2.0, 1.0, z]];
/// let (detector, worlds) = (Detector::new(mesh), Worlds::default());
/// let collides = [0.5, -1.0].map(|end| {
///     worlds.search(&detector, |detector| detector.collides(&at(1.0), &at(end), CONTACT))
/// });
/// assert_eq!(collides, [Ok(false), Ok(true)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Worlds<S = Detector> {
    /// The searches that no world uses.
    idle: Mutex<Vec<S>>,
}

impl<S: Clone> Worlds<S> {
    /// The result of a search in one world, on any thread: by one that no other world uses, or by a copy of
    /// `new`. All calls have the same `new`, since a search that is not in use takes its place.
    pub fn search<T>(&self, new: &S, work: impl FnOnce(&mut S) -> T) -> T {
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        // The lock is not held while `new` is copied.
        let taken = idle().pop();
        let mut search = taken.unwrap_or_else(|| new.clone());
        let result = work(&mut search);
        idle().push(search);
        result
    }
}

impl<S> Default for Worlds<S> {
    /// No searches yet.
    fn default() -> Self {
        let idle = Mutex::default();
        Self { idle }
    }
}

impl<S> fmt::Debug for Worlds<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Worlds").finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::Worlds;

    #[test]
    fn searches_are_used_again_when_no_other_world_uses_them() {
        let worlds = Worlds::default();
        let add = |search: &mut Vec<u32>, world| {
            search.push(world);
            search.clone()
        };
        assert_eq!(worlds.search(&vec![0], |search| add(search, 1)), [0, 1]);
        let both = worlds.search(&vec![0], |outer| {
            let inner = worlds.search(&vec![0], |search| add(search, 3));
            (add(outer, 2), inner)
        });
        assert_eq!(both, (vec![0, 1, 2], vec![0, 3]));
    }
}

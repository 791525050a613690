//! Scripted vertices.

use std::sync::Arc;

use exact_ccd_mesh::Point;

use crate::script::{Script, ScriptError};

/// For each axis, true if a condition holds along it.
pub(crate) type Axes = [bool; 3];

/// Vertices, and the script that prescribes some of their coordinates (a Dirichlet condition).
#[derive(Clone, Debug, PartialEq)]
pub struct Scripted {
    /// The vertices.
    pub vertices: Vec<u32>,
    /// The script.
    pub script: Script,
    /// True for each axis along which the script acts. Along the others, vertices with mass move freely, and
    /// vertices of obstacles rest.
    pub axes: [bool; 3],
    /// The time from which the script does not act, in s: vertices with mass move freely then, and vertices
    /// of obstacles rest. `None`: the script always acts.
    pub release: Option<f64>,
}

impl Scripted {
    /// The same vertices, scripted along some of the axes only.
    #[must_use]
    pub fn along(self, axes: [bool; 3]) -> Self {
        Self { axes, ..self }
    }

    /// The same vertices, scripted until a time, in s.
    #[must_use]
    pub fn until(self, release: f64) -> Self {
        let release = Some(release);
        Self { release, ..self }
    }

    /// Checks that the parameters of the script, the axes and the time are in range.
    ///
    /// # Errors
    /// [`ScriptError`] names the first parameter that is out of range.
    pub fn check(&self) -> Result<(), ScriptError> {
        self.script.check()?;
        let error = |field, expected| Err(ScriptError { field, expected });
        if self.axes == [false; 3] {
            return error("axes", "at least one axis");
        }
        if self
            .release
            .is_some_and(|release| release.is_nan() || release < 0.0)
        {
            return error("release", "a number not below 0");
        }
        Ok(())
    }
}

impl Script {
    /// Vertices with this script along all axes, at all times.
    #[must_use]
    pub fn on(self, vertices: impl IntoIterator<Item = u32>) -> Scripted {
        Scripted {
            vertices: vertices.into_iter().collect(),
            script: self,
            axes: [true; 3],
            release: None,
        }
    }
}

/// The scripts of the three coordinates of one vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Coordinates([Option<Arc<Timed>>; 3]);

/// A script with the time at which it ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timed {
    script: Script,
    release: Option<f64>,
}

impl Timed {
    pub(crate) fn new(scripted: &Scripted) -> Arc<Self> {
        Arc::new(Self {
            script: scripted.script.clone(),
            release: scripted.release,
        })
    }
}

impl Coordinates {
    /// Replaces the scripts along some axes.
    pub(crate) fn set(&mut self, axes: Axes, script: &Arc<Timed>) {
        for (slot, _) in self.0.iter_mut().zip(axes).filter(|(_, acts)| *acts) {
            *slot = Some(Arc::clone(script));
        }
    }

    /// True if a script holds every coordinate at all times.
    pub(crate) fn are_held(&self) -> bool {
        let held =
            |script: &Option<Arc<Timed>>| script.as_ref().is_some_and(|script| script.release.is_none());
        self.0.iter().all(held)
    }

    /// True if no script moves a coordinate at any time.
    pub(crate) fn are_fixed(&self) -> bool {
        self.0
            .iter()
            .flatten()
            .all(|script| script.script == Script::Fixed)
    }

    /// The coordinates that scripts hold in a time step that ends at this time, in s.
    pub(crate) fn held(&self, time: f64) -> Axes {
        let acts = |script: &Arc<Timed>| script.release.is_none_or(|release| time <= release);
        [0, 1, 2].map(|axis: usize| self.0[axis].as_ref().is_some_and(acts))
    }

    /// The position at a time of a vertex that is at `start` at time 0, which no force moves.
    pub(crate) fn position(&self, start: Point, time: f64) -> Point {
        let mut position = start;
        let mut last: Option<(&Arc<Timed>, Point)> = None;
        for (axis, script) in self.0.iter().enumerate() {
            let Some(script) = script else { continue };
            let at = match last {
                Some((same, at)) if Arc::ptr_eq(same, script) => at,
                _ => {
                    let end = script.release.unwrap_or(f64::INFINITY);
                    script.script.position(start, time.min(end))
                }
            };
            position[axis] = at[axis];
            last = Some((script, at));
        }
        position
    }
}

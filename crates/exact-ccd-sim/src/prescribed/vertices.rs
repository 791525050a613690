//! Scripted vertices.

use std::sync::Arc;

use exact_ccd_mesh::Point;

use super::motion::Script;
use crate::digest::{Digest, Hash};
use crate::range::{NOT_NEGATIVE, OutOfRange, check, check_not_negative};

/// For each axis, true if a condition holds along it.
pub(crate) type Axes = [bool; 3];

/// Vertices, and the script that prescribes some of their coordinates (a Dirichlet condition).
#[derive(Clone, Debug, PartialEq)]
pub struct ScriptedVertices {
    /// The vertices.
    pub vertices: Vec<u32>,
    /// The script.
    pub script: Script,
    /// True for each axis along which the script acts. Along the others, vertices with mass move freely, and
    /// vertices of obstacles rest.
    pub axes: [bool; 3],
    /// The time at which the script begins, in s, from the position which a vertex then has. A vertex that is
    /// free is held from the start of the time step on in which the script begins. Before, vertices follow
    /// the script that began last; without one, they move freely if they have mass, and rest otherwise.
    pub from: f64,
    /// The time from which the script does not act, in s: vertices with mass move freely then, and vertices
    /// of obstacles rest. `None`: the script does not end.
    pub release: Option<f64>,
}

impl ScriptedVertices {
    /// The same vertices, scripted along some of the axes only.
    #[must_use]
    pub fn along(self, axes: [bool; 3]) -> Self {
        Self { axes, ..self }
    }

    /// The same vertices, scripted from a time on, in s.
    #[must_use]
    pub fn from(self, from: f64) -> Self {
        Self { from, ..self }
    }

    /// The same vertices, scripted until a time, in s.
    #[must_use]
    pub fn until(self, release: f64) -> Self {
        let release = Some(release);
        Self { release, ..self }
    }

    /// Checks that the parameters of the script, the axes and the times are in range.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first parameter that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        self.script.check()?;
        let acts = self.axes != [false; 3];
        check(acts, "axes", "empty", "at least one axis")?;
        check_not_negative("from", self.from)?;
        let release = self.release.unwrap_or(f64::INFINITY);
        let expected = format_args!("{NOT_NEGATIVE} and not below `from`");
        check(release >= self.from, "release", release, expected)?;
        let ends = self.script.until().is_none_or(|until| until >= self.from);
        check(
            ends,
            "from",
            self.from,
            "a number not above the `until` of the motion",
        )
    }
}

impl Script {
    /// Vertices with this script along all axes, at all times.
    #[must_use]
    pub fn on(self, vertices: impl IntoIterator<Item = u32>) -> ScriptedVertices {
        ScriptedVertices {
            vertices: vertices.into_iter().collect(),
            script: self,
            axes: [true; 3],
            from: 0.0,
            release: None,
        }
    }
}

/// The scripts of the three coordinates of one vertex, by the times at which they begin, which differ.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Coordinates([Vec<Arc<Timed>>; 3]);

/// A script with the times at which it begins and ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timed {
    script: Script,
    from: f64,
    release: Option<f64>,
}

impl Timed {
    pub(crate) fn new(scripted: &ScriptedVertices) -> Arc<Self> {
        Arc::new(Self {
            script: scripted.script.clone(),
            from: scripted.from,
            release: scripted.release,
        })
    }

    /// Returns true if no time is between the end of the script and the start of the next one.
    fn lasts_until(&self, next: f64) -> bool {
        self.release.is_none_or(|release| release >= next)
    }
}

impl Coordinates {
    /// Adds a script along some axes. It replaces the one that begins at the same time.
    pub(crate) fn add(&mut self, axes: Axes, script: &Arc<Timed>) {
        for (scripts, _) in self.0.iter_mut().zip(axes).filter(|(_, acts)| *acts) {
            scripts.retain(|other| other.from != script.from);
            let place = scripts.partition_point(|other| other.from < script.from);
            scripts.insert(place, Arc::clone(script));
        }
    }

    /// Returns true if a script holds every coordinate at all times.
    pub(crate) fn are_held(&self) -> bool {
        let held = |scripts: &Vec<Arc<Timed>>| {
            scripts.first().is_some_and(|script| script.from == 0.0)
                && scripts.windows(2).all(|pair| pair[0].lasts_until(pair[1].from))
                && scripts.last().is_some_and(|script| script.release.is_none())
        };
        self.0.iter().all(held)
    }

    /// Returns true if vertices with these scripts keep their distances.
    pub(crate) fn are_rigid(&self) -> bool {
        let [x, y, z] = &self.0;
        x == y && y == z || !self.0.iter().flatten().any(|script| script.script.turns())
    }

    /// Returns true if no script moves a coordinate at any time.
    pub(crate) fn are_fixed(&self) -> bool {
        self.0
            .iter()
            .flatten()
            .all(|script| script.script == Script::Fixed)
    }

    /// The script of an axis that began last before a time, in s.
    fn latest(&self, axis: usize, time: f64) -> Option<&Arc<Timed>> {
        self.0[axis].iter().rev().find(|script| script.from < time)
    }

    /// The coordinates that scripts hold at a time, in s.
    pub(crate) fn held(&self, time: f64) -> Axes {
        let acts = |script: &Arc<Timed>| script.release.is_none_or(|release| time <= release);
        [0, 1, 2].map(|axis| self.latest(axis, time).is_some_and(acts))
    }

    /// For each coordinate, the time at which its script begins, if that is between two times, in s.
    pub(crate) fn beginning(&self, [before, now]: [f64; 2]) -> [Option<f64>; 3] {
        let begin = |axis| self.latest(axis, now).map(|script| script.from);
        [0, 1, 2].map(|axis| begin(axis).filter(|from| *from >= before))
    }

    /// The position at `time` of a vertex that no force moves, by the scripts that began last before
    /// `moment`, both in s. For each axis, `origins` has the position of the vertex where that script began.
    pub(crate) fn position(&self, origins: &[Point; 3], moment: f64, time: f64) -> Point {
        [0, 1, 2].map(|axis: usize| {
            let Some(script) = self.latest(axis, moment) else {
                return origins[axis][axis];
            };
            let end = script.release.unwrap_or(f64::INFINITY);
            let at = script.script.position(origins[axis], script.from, time.min(end));
            at[axis]
        })
    }
}

impl Digest for Timed {
    fn digest(&self, hash: &mut Hash) {
        let Self {
            script,
            from,
            release,
        } = self;
        (script, (from, release)).digest(hash);
    }
}

impl Digest for Coordinates {
    fn digest(&self, hash: &mut Hash) {
        let Self(axes) = self;
        let scripts = axes.each_ref().map(|scripts| scripts.iter().map(Arc::as_ref));
        scripts.map(Iterator::collect::<Vec<&Timed>>).digest(hash);
    }
}

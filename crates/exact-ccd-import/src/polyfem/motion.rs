//! Displacements as functions of place and time.

use exact_ccd_mesh::Point;

use super::entry::{Entry, NOTHING, Rule};
use super::expression;
use super::settings::Time;
use crate::fault::Fault;
use exact_ccd_sim::{KeyFrame, Script};

/// The most time steps of a motion that is not linear in time.
const MOST: f64 = 1e5;

/// A displacement along some axes.
pub(super) struct Held<'a> {
    pub(super) axes: [bool; 3],
    values: Entry<'a>,
    components: [Entry<'a>; 3],
    /// The duration and the length of a time step, in s.
    time: [f64; 2],
}

impl Held<'_> {
    /// Returns true if the displacement differs from place to place.
    pub(super) fn depends_on_place(&self) -> bool {
        let words = |entry: &Entry<'_>| {
            let text = entry.value.as_str().unwrap_or_default();
            let mut words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            words.any(|word| ["x", "y", "z"].contains(&word))
        };
        self.components.iter().any(words)
    }

    /// The script of an obstacle that moves as a whole.
    pub(super) fn script_of_all(&self) -> Result<Script, Fault> {
        if self.depends_on_place() {
            let what = "a displacement of an obstacle that depends on the place";
            return Err(self.values.unsupported(what, "write functions of t"));
        }
        self.script([0.0; 3])
    }

    /// The script of a vertex that starts at a place.
    pub(super) fn script(&self, place: Point) -> Result<Script, Fault> {
        let [x, y, z] = &self.components;
        let displacement =
            |t: f64| -> Result<Point, Fault> { Ok([at(x, place, t)?, at(y, place, t)?, at(z, place, t)?]) };
        motion(&displacement, self.time, &self.values)
    }
}

/// A displacement as a function of place and time.
pub(super) fn held<'a>(entry: &Entry<'a>, time: &Time) -> Result<Held<'a>, Fault> {
    if entry.value.is_string() {
        return Err(entry.unsupported("a file of displacements", "write `id` and `value`"));
    }
    entry.check(&[
        ("id value dimension", Rule::Said),
        ("time_reference interpolation", NOTHING),
    ])?;
    let values = entry.need("value")?;
    let components = values.three(
        |entry| Ok(entry.clone()),
        "three numbers or functions of x, y, z, t",
    )?;
    let axes = entry.get("dimension").map_or(Ok([true; 3]), |dimension| {
        dimension.three(Entry::is_true, "three of true and false")
    })?;
    let held = Held {
        axes,
        values,
        components,
        time: [time.duration, time.step],
    };
    // An error does not depend on the place.
    held.script([0.0; 3])?;
    Ok(held)
}

/// The value of a function at a place and a time.
fn at(entry: &Entry<'_>, place: Point, t: f64) -> Result<f64, Fault> {
    let Some(text) = entry.value.as_str() else {
        return entry.number();
    };
    expression::value(text, place, t).ok_or_else(|| {
        let instead = "write a function of x, y, z, t with + - * / ( ) pi sin cos sqrt abs min max if";
        entry.unsupported("this function", instead)
    })
}

/// The script of a displacement: its values at the ends of time steps.
fn motion(
    displacement: &dyn Fn(f64) -> Result<Point, Fault>,
    [duration, step]: [f64; 2],
    values: &Entry<'_>,
) -> Result<Script, Fault> {
    let count = (duration / step).ceil();
    if !(0.0..=MOST).contains(&count) {
        return Err(values.invalid(&format!("at most {MOST} time steps, of positive length")));
    }
    let frame = |index: f64| -> Result<KeyFrame, Fault> {
        let time = index * step;
        Ok(KeyFrame {
            time,
            translate: displacement(time)?,
            degrees: 0.0,
        })
    };
    let mut frames = vec![frame(0.0)?];
    for index in 1..=count as u64 {
        let next = frame(index as f64)?;
        if let [.., before, last] = &frames[..]
            && is_between(before, last, &next)
        {
            frames.pop();
        }
        frames.push(next);
    }
    if frames.iter().all(|frame| frame.translate == [0.0; 3]) {
        return Ok(Script::Fixed);
    }
    Ok(Script::KeyFrames {
        frames,
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
    })
}

/// Returns true if a key frame is on the line between two others, up to rounding.
fn is_between(before: &KeyFrame, frame: &KeyFrame, after: &KeyFrame) -> bool {
    let share = (frame.time - before.time) / (after.time - before.time);
    (0..3).all(|axis| {
        let (from, to) = (before.translate[axis], after.translate[axis]);
        let expected = from + share * (to - from);
        (expected - frame.translate[axis]).abs() <= 1e-12 * (from.abs() + to.abs())
    })
}

//! Displacements as functions of time.

use exact_ccd_mesh::Point;

use super::super::fault::Fault;
use super::entry::{Entry, Rule};
use super::settings::Time;
use super::{NOTHING, expression};
use exact_ccd_sim::{KeyFrame, Script};

/// The most time steps of a motion that is not linear in time.
const MOST: f64 = 1e5;

/// A motion along some axes.
pub(super) struct Held {
    pub(super) axes: [bool; 3],
    pub(super) motion: Script,
}

/// A displacement as a function of time.
pub(super) fn held(entry: &Entry<'_>, time: &Time) -> Result<Held, Fault> {
    if entry.value.is_string() {
        return Err(entry.unsupported("a file of displacements", "write `id` and `value`"));
    }
    entry.check(&[
        ("id value dimension", Rule::Said),
        ("time_reference interpolation", NOTHING),
    ])?;
    let values = entry.need("value")?;
    let [x, y, z] = values.three(|entry| Ok(entry.clone()), "three numbers or functions of t")?;
    let axes = entry.get("dimension").map_or(Ok([true; 3]), |dimension| {
        dimension.three(Entry::is_true, "three of true and false")
    })?;
    let displacement = |t: f64| -> Result<Point, Fault> { Ok([at(&x, t)?, at(&y, t)?, at(&z, t)?]) };
    let motion = motion(&displacement, time, &values)?;
    Ok(Held { axes, motion })
}

/// The value of a function of time.
fn at(entry: &Entry<'_>, t: f64) -> Result<f64, Fault> {
    let Some(text) = entry.value.as_str() else {
        return entry.number();
    };
    expression::value(text, t).ok_or_else(|| {
        let instead = "write a function of t with + - * / ( ) pi sin cos sqrt abs min max";
        entry.unsupported("this function", instead)
    })
}

/// The script of a displacement: its values at the ends of time steps.
fn motion(
    displacement: &dyn Fn(f64) -> Result<Point, Fault>,
    time: &Time,
    values: &Entry<'_>,
) -> Result<Script, Fault> {
    let count = (time.duration / time.step).ceil();
    if !(0.0..=MOST).contains(&count) {
        return Err(values.invalid(&format!("at most {MOST} time steps, of positive length")));
    }
    let frame = |index: f64| -> Result<KeyFrame, Fault> {
        let time = index * time.step;
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

/// True if a key frame is on the line between two others, up to rounding.
fn is_between(before: &KeyFrame, frame: &KeyFrame, after: &KeyFrame) -> bool {
    let share = (frame.time - before.time) / (after.time - before.time);
    (0..3).all(|axis| {
        let (from, to) = (before.translate[axis], after.translate[axis]);
        let expected = from + share * (to - from);
        (expected - frame.translate[axis]).abs() <= 1e-12 * (from.abs() + to.abs())
    })
}

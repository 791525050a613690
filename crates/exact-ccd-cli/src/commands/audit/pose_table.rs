//! The poses of bodies, frame by frame, in a CSV file.

use std::fs;
use std::path::Path;

use exact_ccd::motion::Pose;

use crate::messages::failure::{Failure, listed};

/// The columns. The scalar of the quaternion comes first.
const HEADER: &str = "frame,body,x,y,z,qw,qx,qy,qz";

/// The poses of all bodies in each frame, in the order of the names.
///
/// # Errors
/// The line and the reason: another header or number of fields, frames that are not numbered 0, 1, 2, … in
/// this order, a body that has another name or no pose or two in a frame, or numbers that are no pose.
pub(super) fn read(file: &Path, names: &[String]) -> Result<Vec<Vec<Pose>>, Failure> {
    let text = fs::read_to_string(file).map_err(|error| Failure::of(file, error))?;
    parse(&text, names).map_err(|reason| Failure::of(file, reason))
}

fn parse(text: &str, names: &[String]) -> Result<Vec<Vec<Pose>>, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (1..).zip(text.lines());
    let header: Vec<&str> = fields(lines.next().map_or("", |(_, line)| line));
    if header != fields(HEADER) {
        return Err(format!("line 1: expected the header {HEADER}"));
    }
    let mut frames: Vec<Vec<Option<Pose>>> = Vec::new();
    for (line, row) in lines.filter(|(_, row)| !row.trim().is_empty()) {
        let (frame, body, pose) = parse_row(row, names).map_err(|reason| format!("line {line}: {reason}"))?;
        if frame == frames.len() {
            check_complete(&frames, names)?;
            frames.push(vec![None; names.len()]);
        } else if frame + 1 != frames.len() {
            let expected = match frames.len() {
                0 => "0".to_owned(),
                count => format!("{} or {count}", count - 1),
            };
            return Err(format!(
                "line {line}: frame {frame}, expected {expected}: number the frames 0, 1, 2, ... and sort the rows by them"
            ));
        }
        let place = &mut frames[frame][body];
        if place.is_some() {
            let name = &names[body];
            return Err(format!(
                "line {line}: a second pose of the body {name} in frame {frame}: leave one out"
            ));
        }
        *place = Some(pose);
    }
    check_complete(&frames, names)?;
    if frames.is_empty() {
        return Err("there is no pose: expected a row for each body in each frame".to_owned());
    }
    Ok(frames
        .into_iter()
        .map(|poses| poses.into_iter().flatten().collect())
        .collect())
}

fn fields(row: &str) -> Vec<&str> {
    row.split(',').map(str::trim).collect()
}

/// The frame, the body and the pose of a row.
fn parse_row(row: &str, names: &[String]) -> Result<(usize, usize, Pose), String> {
    let fields = fields(row);
    let [frame, body, numbers @ ..] = &fields[..] else {
        return Err(format!("1 field, expected 9: {HEADER}"));
    };
    if numbers.len() != 7 {
        return Err(format!("{} fields, expected 9: {HEADER}", fields.len()));
    }
    let frame = frame
        .parse()
        .map_err(|_| format!("the frame is {frame:?}, expected 0, 1, 2, ..."))?;
    let body = names.iter().position(|name| name == body).ok_or_else(|| {
        let known = listed(names.iter().cloned(), 10);
        format!("there is no body {body}; the files are of {known}: a body has the name of its file without the extension")
    })?;
    let mut values = [0.0; 7];
    for ((value, text), column) in values.iter_mut().zip(numbers).zip(HEADER.split(',').skip(2)) {
        *value = text
            .parse()
            .map_err(|_| format!("{column} is {text:?}, expected a number"))?;
    }
    let [x, y, z, qw, qx, qy, qz] = values;
    let pose = Pose::new([qw, qx, qy, qz], [x, y, z]);
    Ok((frame, body, pose.map_err(|error| error.to_string())?))
}

/// Checks that the last frame has a pose of each body.
fn check_complete(frames: &[Vec<Option<Pose>>], names: &[String]) -> Result<(), String> {
    let Some(last) = frames.last() else {
        return Ok(());
    };
    match last.iter().position(Option::is_none) {
        Some(body) => Err(format!(
            "frame {} has no pose of the body {}: add its row, also if it rests",
            frames.len() - 1,
            names[body]
        )),
        None => Ok(()),
    }
}

//! `exact-ccd audit --poses`: rigid bodies that move from pose to pose.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd_mesh::{Bodies, BodiesAudit, BodiesError, BodiesViolation};

use super::pose_table;
use crate::assembly::Assembly;
use crate::contacts::ContactRecord;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::motion::arguments::MeshArguments;
use crate::motion::report::{Report, ReportForm};
use crate::options::distances::Distances;
use crate::text::seconds::Seconds;

/// Examines the poses in a file until the first violation.
pub(super) fn run(files: &[PathBuf], poses: &Path, mesh: &MeshArguments) -> Result<ExitCode, Failure> {
    let mut inputs = files.to_vec();
    inputs.push(poses.to_owned());
    mesh.check_places(&inputs)?;
    let mut clock = Seconds::begin();
    let mut notes = Notes::default();
    let mut scene = Assembly::of_bodies(files, &mesh.scene, &mut notes)?;
    let names = scene.part_names();
    let frames = pose_table::read(poses, &names)?;
    let bodies = Bodies::new(scene.part_frames()?).map_err(|error| Failure::new(named(error, &names)))?;
    clock.end("read");

    let mut report = Report::new(
        ReportForm::Frames,
        &scene,
        notes,
        Distances::new(mesh.min_distance, None),
    )
    .with_frames(frames.len());
    let mut audit = BodiesAudit::new(bodies).with_separation(mesh.min_distance);
    during(progress::bar(frames.len(), "frames"), |progress| {
        for (index, frame) in frames.iter().enumerate() {
            let violation = audit.examine(frame);
            let violation = violation.map_err(|error| {
                let error = named(error, &names);
                Failure::of(poses, format_args!("in the step to frame {index}: {error}"))
            })?;
            report.examined = index + 1;
            if let Some(violation) = violation {
                let record = record(&scene, &violation, mesh.min_distance.get());
                let files = (record.frame..=index).map(|_| poses.display().to_string());
                report.add_in(files.collect(), &record);
                break;
            }
            progress(1);
        }
        Ok::<_, Failure>(())
    })?;
    clock.end("examine");
    report.seconds = Some(clock);
    mesh.finish(report)
}

/// The message of an error, with the name of the body.
fn named(error: BodiesError, names: &[String]) -> String {
    let (body, reason) = match &error {
        BodiesError::Positions { body, error } => (*body, error.to_string()),
        BodiesError::TooManyPrimitives { body, error } => (*body, error.to_string()),
        BodiesError::Motion { body, error } => (*body, error.to_string()),
        error => return error.to_string(),
    };
    format!("body {}: {reason}", names.get(body).map_or("", String::as_str))
}

/// The record of a violation, with the names of the bodies and the ids of their files.
fn record(scene: &Assembly, violation: &BodiesViolation, distance: f64) -> ContactRecord {
    match violation {
        &BodiesViolation::Intersection {
            frame,
            bodies,
            edge,
            face,
        } => {
            let primitives = scene.primitives_of_parts(bodies, [2, 3], [edge, face]);
            scene.in_file(ContactRecord::of_bodies_that_cross(frame, primitives))
        }
        BodiesViolation::Contact { frame, contact } => {
            let primitives =
                scene.primitives_of_parts(contact.bodies, contact.kind.sizes(), contact.primitives);
            scene.in_file(ContactRecord::of_bodies(*frame, primitives, contact, distance))
        }
    }
}

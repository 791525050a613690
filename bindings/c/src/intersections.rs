//! Meshes at rest.

use exact_ccd_mesh::{Bvh, IntersectionOptions, intersections};

use crate::border::call;
use crate::detector::Detector;
use crate::error::Status;
use crate::pointers::{Out, positions, reference};

/// Decides if a mesh at rest passes through itself: if an edge and a face that can collide and have no
/// common vertex have a common point. `edge` and `face` are the first such pair, written only if there
/// is one. Both may be null: then the search ends with any pair. The distance of the detector has no
/// influence.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_has_intersections(
    detector: *const Detector,
    x: *const f64,
    vertex_count: usize,
    has_intersections: *mut bool,
    edge: *mut u32,
    face: *mut u32,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, x, has_intersections, edge, face) = unsafe {
            (
                reference("detector", detector)?,
                positions("x", x, vertex_count)?,
                Out::new("has_intersections", has_intersections)?,
                Out::optional("edge", edge)?,
                Out::optional("face", face)?,
            )
        };
        let (mesh, can_collide) = (detector.inner.mesh(), detector.inner.can_collide());
        let options = IntersectionOptions::default().with_can_collide(can_collide.clone());
        if edge.is_none() && face.is_none() {
            let any = || exact_ccd_mesh::has_intersections(mesh, x, &Bvh, &options, &|_| true);
            has_intersections.write(detector.threads.run(|| Ok(any()?))?);
            return Ok(());
        }
        let found = detector
            .threads
            .run(|| Ok(intersections(mesh, x, &Bvh, &options)?))?;
        has_intersections.write(!found.is_empty());
        if let Some(first) = found.first() {
            if let Some(edge) = edge {
                edge.write(first.edge);
            }
            if let Some(face) = face {
                face.write(first.face);
            }
        }
        Ok(())
    })
}

//! The bodies of a text scene.

use core::f64::consts::PI;

use exact_ccd_mesh::{Aabb, Point};
use exact_ccd_sim::Script;
use nalgebra::Vector3;

use super::file::{File, Obstacle, Script as Motion};
use super::part::Part;
use super::shape;
use crate::fault::{Fault, Problem};
use crate::meshes::Meshes;
use crate::notes::Notes;
use exact_ccd_scene::description::{BodyDescription, ScriptDescription, Selection};
use exact_ccd_scene::description::{Placement, Scale};

/// The angular velocity of the ends in `script twist`, in rad/s.
const TWIST: f64 = 0.4 * PI;

/// The bodies of a file: its shapes, then its obstacles. The number is the diagonal of the box of the
/// solids, in m, 0 without solids.
pub(super) fn bodies(
    file: &File,
    meshes: &mut Meshes,
    notes: &Notes,
) -> Result<(Vec<BodyDescription>, f64), Fault> {
    let parts: Result<Vec<Part<'_>>, Fault> = file
        .shapes
        .iter()
        .map(|shape| Part::new(shape, file, meshes))
        .collect();
    let mut parts = parts?;
    if let Some((place, size)) = &file.size {
        resize(&mut parts, *size).map_err(|problem| problem.at(place))?;
    }
    match file.script {
        Motion::Fall => {
            let shift = Vector3::new(0.0, 0.5 * diagonal(&whole(&parts)), 0.0);
            parts
                .iter_mut()
                .for_each(|part| part.place(part.body.placement().then(1.0, shift)));
        }
        Motion::Twist => twist(&mut parts, file.handle_ratio),
        Motion::BallHitsWall(velocity) => {
            let solids = parts.iter_mut().filter(|part| part.is_solid());
            solids.for_each(|part| part.body.velocity = [velocity, 0.0, 0.0]);
        }
        Motion::Null | Motion::FallNoShift | Motion::HeldSurfaces => {}
    }
    for part in &mut parts {
        part.add_motions(file, notes)?;
    }
    let solids = parts.iter().filter(|part| part.is_solid());
    let size = diagonal(&solids.flat_map(|part| &part.points).copied().collect());
    let obstacles = file.obstacles.iter().map(|described| obstacle(described, meshes));
    let shapes = parts.into_iter().map(|part| Ok(part.body));
    let bodies: Result<_, Fault> = shapes.chain(obstacles).collect();
    Ok((bodies?, size))
}

/// The box of all vertices.
fn whole(parts: &[Part<'_>]) -> Aabb {
    parts.iter().flat_map(|part| &part.points).copied().collect()
}

/// The diagonal of the box of some vertices; 0 without vertices.
fn diagonal(bounds: &Aabb) -> f64 {
    let length = Vector3::from(bounds.sides()).norm();
    if length.is_finite() { length } else { 0.0 }
}

/// Scales the scene to a box with the longest side `size`, and moves its lower corner to the origin.
fn resize(parts: &mut [Part<'_>], size: f64) -> Result<(), Problem> {
    let bounds = whole(parts);
    let factor = factor(size, &bounds, "shapes")?;
    let shift = -Vector3::from(bounds.lower) * factor;
    parts
        .iter_mut()
        .for_each(|part| part.place(part.body.placement().then(factor, shift)));
    Ok(())
}

/// Turns the ends of the scene along x about the axis along x through the center of its box: all vertices
/// within a fraction of the length of the box.
fn twist(parts: &mut [Part<'_>], ratio: f64) {
    let bounds = whole(parts);
    let (center, Aabb { lower, upper }) = (bounds.center(), bounds);
    let margin = (upper[0] - lower[0]) * ratio;
    let rate_at = |point: &Point| {
        if point[0] < lower[0] + margin {
            Some(-TWIST)
        } else if point[0] > upper[0] - margin {
            Some(TWIST)
        } else {
            None
        }
    };
    for part in parts {
        for rate in [-TWIST, TWIST] {
            let points = (0..).zip(&part.points);
            let selected: Vec<u32> = points
                .filter(|(_, point)| rate_at(point) == Some(rate))
                .map(|(vertex, _)| vertex)
                .collect();
            if selected.is_empty() {
                continue;
            }
            let motion = Script::Twisting {
                center,
                axis: [1.0, 0.0, 0.0],
                rate,
                until: None,
            };
            let vertices = Selection::of_vertices(&selected, &part.points);
            part.body.script.push(ScriptDescription::new(vertices, motion));
        }
    }
}

/// The body of `meshCO`: its mesh about the mean of its vertices. The longest side of its box gets the length
/// `scale`.
fn obstacle(described: &Obstacle, meshes: &mut Meshes) -> Result<BodyDescription, Fault> {
    let at_place = |problem: Problem| problem.at(&described.place);
    let (path, mesh) = meshes.find(&described.mesh).map_err(at_place)?;
    let bounds = mesh.points.iter().copied().collect();
    let factor = factor(described.scale, &bounds, "a mesh").map_err(at_place)?;
    let mut placement = Placement {
        scale: Scale([factor; 3]),
        rotate: shape::rotation(described.degrees),
        translate: [0.0; 3],
    };
    let sum: Vector3<f64> = mesh.points.iter().map(|&point| Vector3::from(point)).sum();
    let mean = placement.apply((sum / mesh.points.len() as f64).into());
    placement.translate = (Vector3::from(described.origin) - Vector3::from(mean)).into();
    let body = BodyDescription {
        mesh: Some(path),
        ..BodyDescription::default()
    };
    Ok(body.at(placement))
}

/// The factor that scales a box to a longest side of this length.
fn factor(length: f64, bounds: &Aabb, what: &str) -> Result<f64, Problem> {
    let range = Vector3::from(bounds.sides()).max();
    let factor = length / range;
    if factor.is_normal() && range.is_normal() {
        return Ok(factor);
    }
    let found = format!("{what} with a box of {range} m");
    let expected = format!("{what} with a box that can be scaled to this size");
    Err(Problem::invalid(found, expected))
}

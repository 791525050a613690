//! Pictures of all time steps.

use std::io;

use exact_ccd_files::read_frame;
use exact_ccd_mesh::{Aabb, Frame, MeshError, Point, TriangleMesh};
use exact_ccd_render::{Animation, Marks, View, render_thick};
use exact_ccd_sim::{HalfSpace, Simulation};

use super::folder::{ANIMATION, OutputFolder, PICTURES, make_folder};
use super::steps;
use crate::failure::Failure;
use crate::output::{replace_file, write_file};
use crate::progress::{self, during};

/// Width and height in pixels.
const SIZE: [u16; 2] = [640, 480];

/// Draws all frames up to the current time step, each as a picture, and all as an animation in real time.
/// Rods and particles have the radius of their contact surface.
pub(super) fn draw(folder: &OutputFolder, simulation: &Simulation) -> Result<(), Failure> {
    let steps = folder.frames();
    let mut bounds = Aabb::EMPTY;
    for &step in steps {
        bounds = bounds.union(&read_frame(folder.frame(step))?.bounds());
    }
    let [up, towards] = directions(simulation.settings().gravity);
    let view = View::upright(&bounds, up, towards, SIZE);
    let mut radii = simulation.system().surface_offsets();
    let half_spaces = simulation.system().half_spaces();
    radii.resize(radii.len() + 4 * half_spaces.len(), 0.0);
    // The time steps between two frames, if there are any.
    let interval = steps.windows(2).next().map_or(1, |steps| steps[1] - steps[0]);
    let delay = 1000.0 * simulation.settings().time_step * interval as f64;
    let delay = delay.round().max(1.0) as u16;

    let pictures = folder.file(PICTURES);
    make_folder(&pictures)?;
    let count = u32::try_from(steps.len()).unwrap_or(u32::MAX);
    let motion = folder.file(ANIMATION);
    let failed = |source| Failure::write(&motion, source);
    replace_file(&motion, |writer| {
        during(progress::frames(count as usize), |progress| {
            let mut animation = Animation::new(writer, SIZE, count, delay).map_err(failed)?;
            for &step in steps {
                let mut frame = read_frame(folder.frame(step))?;
                for half_space in half_spaces {
                    frame = with_boundary(frame, half_space, &bounds)
                        .map_err(|error| failed(io::Error::other(error)))?;
                }
                let picture = render_thick(&frame, &view, &Marks::default(), &radii);
                let file = pictures.join(steps::name(step, "png"));
                write_file(&file, |writer| picture.write_png(writer))?;
                animation.add(&picture).map_err(failed)?;
                progress(1);
            }
            animation.finish().map_err(failed)
        })
    })
}

/// A frame with a square of the boundary of a half space, beneath the bounds of the scene.
fn with_boundary(mut frame: Frame, half_space: &HalfSpace, bounds: &Aabb) -> Result<Frame, MeshError> {
    let first = frame.positions.len() as u32;
    frame.positions.extend(half_space.square(bounds));
    let mut faces = frame.mesh.faces().to_vec();
    faces.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    let edges = frame.mesh.loose_edges().to_vec();
    frame.mesh = TriangleMesh::with_edges(frame.positions.len(), faces, &edges)?;
    Ok(frame)
}

/// The upward direction and the direction towards the viewer. Upward is opposite to gravity, or along y
/// without gravity. The viewer is slightly above the scene.
fn directions(gravity: Point) -> [Point; 2] {
    let falls = gravity.iter().any(|&g| g != 0.0);
    let up = if falls {
        gravity.map(|g| -g)
    } else {
        [0.0, 1.0, 0.0]
    };
    let vertical = (0..3).fold(0, |most: usize, axis| {
        if up[axis].abs() > up[most].abs() {
            axis
        } else {
            most
        }
    });
    let mut towards = [0.0; 3];
    towards[vertical] = 0.6_f64.copysign(up[vertical]);
    towards[(vertical + 1) % 3] = 1.0;
    towards[(vertical + 2) % 3] = 0.5;
    [up, towards]
}

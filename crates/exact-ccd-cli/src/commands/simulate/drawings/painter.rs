//! The picture of a frame of a simulation.

use exact_ccd_mesh::vector::{cross, dot, minus};
use exact_ccd_mesh::{Aabb, Frame, HalfSpace, MeshError, Point, TriangleMesh};
use exact_ccd_render::{Camera, Marks, Picture, render_thick};
use exact_ccd_scene::{Rendering, Subject};
use exact_ccd_sim::{Simulation, System};

/// A painter of the frames of a motion.
pub(crate) struct Painter {
    rendering: Rendering,
    camera: Camera,
    /// The radii of the contact surfaces of rods and particles.
    radii: Vec<f64>,
    /// The positions in the first frame.
    start: Vec<Point>,
    /// A flag for each vertex that fills the pictures.
    subject: Vec<bool>,
    half_spaces: Vec<HalfSpace>,
    time_step: f64,
    decimals: usize,
    /// The bounds of all frames so far, and of their subject in the coordinates of the camera.
    bounds: Aabb,
    extent: Aabb,
}

impl Painter {
    pub(crate) fn new(simulation: &Simulation, rendering: Rendering) -> Self {
        let (system, settings) = (simulation.system(), simulation.settings());
        let [up, towards] = directions(&rendering, settings.gravity);
        Self {
            rendering,
            camera: Camera::new(up, towards),
            radii: system.surface_offsets(),
            start: Vec::new(),
            subject: subject(system, rendering.subject),
            half_spaces: system.half_spaces().to_vec(),
            time_step: settings.time_step,
            decimals: decimals(settings.time_step),
            bounds: Aabb::EMPTY,
            extent: Aabb::EMPTY,
        }
    }

    /// Includes a frame in the motion that fills the pictures.
    pub(crate) fn include(&mut self, frame: &Frame) {
        if self.start.is_empty() {
            self.start.clone_from(&frame.positions);
        }
        let places = frame.positions.iter().zip(&self.start);
        for (is_subject, (place, start)) in self.subject.iter_mut().zip(places) {
            *is_subject |= place != start;
        }
        self.bounds = self.bounds.union(&frame.bounds());
        self.extent = self.extent.union(&self.extent_of(frame));
    }

    /// The extent of the subject.
    fn extent_of(&self, frame: &Frame) -> Aabb {
        if let Subject::Box { lower, upper } = self.rendering.subject {
            let corner = |corner: usize| [0, 1, 2].map(|axis| [lower, upper][corner >> axis & 1][axis]);
            return self.camera.extent((0..8).map(|index| (corner(index), 0.0)));
        }
        let is_empty = !self.subject.contains(&true);
        let balls = frame.positions.iter().copied().zip(self.radii.iter().copied());
        let shown = balls
            .zip(&self.subject)
            .filter(|(_, is_subject)| is_empty || **is_subject);
        self.camera.extent(shown.map(|(ball, _)| ball))
    }

    /// The picture of a frame, with its time.
    pub(crate) fn paint(&self, mut frame: Frame, step: u64) -> Result<Picture, MeshError> {
        let extent = if self.rendering.follow {
            self.extent_of(&frame)
        } else {
            self.extent
        };
        for half_space in &self.half_spaces {
            frame = with_boundary(frame, half_space, &self.bounds)?;
        }
        let view = self.camera.view(&extent, self.rendering.size);
        let mut picture = render_thick(&frame, &view, &Marks::default(), &self.radii);
        let (time, decimals) = (step as f64 * self.time_step, self.decimals);
        picture.write(&format!("t = {time:.decimals$} s"));
        Ok(picture)
    }
}

/// A flag for each vertex of the surface that fills the pictures from the start on.
fn subject(system: &System, subject: Subject) -> Vec<bool> {
    let surface = system.surface_vertices().iter();
    surface
        .map(|vertex| subject != Subject::Moving || system.has_mass(*vertex))
        .collect()
}

/// A frame with a square of the boundary of a half space, beneath the bounds of the scene.
fn with_boundary(mut frame: Frame, half_space: &HalfSpace, bounds: &Aabb) -> Result<Frame, MeshError> {
    let first = frame.positions.len() as u32;
    frame.positions.extend(square(half_space, bounds));
    let mut faces = frame.mesh.faces().to_vec();
    faces.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    let edges = frame.mesh.loose_edges().to_vec();
    frame.mesh = TriangleMesh::with_edges(frame.positions.len(), faces, &edges)?;
    Ok(frame)
}

/// A square of the boundary of a half space beneath a box: its corners, counterclockwise for a viewer at whom
/// the normal points. Its sides are longer than the diagonal of the box.
fn square(half_space: &HalfSpace, bounds: &Aabb) -> [Point; 4] {
    let normal = half_space.unit_normal();
    let middle = [0, 1, 2].map(|axis| (bounds.lower[axis] + bounds.upper[axis]) * 0.5);
    let height = dot(normal, minus(middle, half_space.point));
    let mut axes = [0, 1, 2];
    axes.sort_by(|&a: &usize, &b| normal[a].abs().total_cmp(&normal[b].abs()));
    let mut across = [0.0; 3];
    across[axes[0]] = 1.0;
    let side = cross(across, normal);
    let side = side.map(|x| x / length(side));
    let other = cross(normal, side);
    let half = 0.7 * length(minus(bounds.upper, bounds.lower));
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    corners.map(|[a, b]| {
        [0, 1, 2].map(|axis| middle[axis] - normal[axis] * height + side[axis] * a + other[axis] * b)
    })
}

fn length(vector: Point) -> f64 {
    dot(vector, vector).sqrt()
}

/// The upward direction and the direction towards the viewer, who is slightly above the horizon if the
/// direction is not given.
fn directions(rendering: &Rendering, gravity: Point) -> [Point; 2] {
    let up = rendering.upwards(gravity);
    let vertical = (0..3).fold(0, |most: usize, axis| {
        if up[axis].abs() > up[most].abs() {
            axis
        } else {
            most
        }
    });
    let mut above = [0.0; 3];
    above[vertical] = 0.6_f64.copysign(up[vertical]);
    above[(vertical + 1) % 3] = 1.0;
    above[(vertical + 2) % 3] = 0.5;
    [up, rendering.camera.unwrap_or(above)]
}

/// The number of decimals in which all multiples of a time step are exact; if it is more than six, the number
/// of decimals that distinguish them.
fn decimals(time_step: f64) -> usize {
    let is_whole = |decimals: &usize| {
        let scaled = time_step * 10f64.powi(*decimals as i32);
        scaled > 0.5 && (scaled - scaled.round()).abs() < 1e-6 * scaled
    };
    let distinct = || (1.0 - time_step.log10().floor()).clamp(0.0, 12.0) as usize;
    (0..=6).find(is_whole).unwrap_or_else(distinct)
}

#[cfg(test)]
mod tests {
    use super::decimals;

    #[test]
    fn times_have_the_decimals_of_the_time_step() {
        let steps = [1.0, 0.01, 0.025, 0.1, 2.0, 1e-6, 1.0 / 24.0, 1e-9, 1e-300];
        assert_eq!(steps.map(decimals), [0, 2, 3, 1, 0, 6, 3, 10, 12]);
    }
}

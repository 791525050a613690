//! The entries of a text scene.

use exact_ccd_mesh::Point;

use super::super::fault::Place;
use super::shape::Shape;

/// A text scene, with IPC's defaults for all entries that it does not have.
#[derive(Debug)]
pub(super) struct File {
    pub(super) shapes: Vec<Shape>,
    /// Meshes that do not move.
    pub(super) obstacles: Vec<Obstacle>,
    pub(super) planes: Vec<Plane>,
    pub(super) script: Script,
    pub(super) size: Option<(Place, f64)>,
    pub(super) handle_ratio: f64,
    pub(super) density: f64,
    /// Young's modulus and Poisson's ratio.
    pub(super) stiffness: [f64; 2],
    pub(super) duration: f64,
    pub(super) time_step: f64,
    pub(super) gravity: Point,
    /// The friction coefficient between shapes.
    pub(super) friction: f64,
    /// True if the lengths that follow are in m, not in diagonals of the box.
    pub(super) is_absolute: bool,
    pub(super) contact_distance: f64,
    pub(super) static_velocity: f64,
    pub(super) tolerance: f64,
    pub(super) lags: usize,
    pub(super) dirichlet_times: [f64; 2],
    pub(super) neumann_times: [f64; 2],
    pub(super) notes: Vec<(Place, String)>,
}

/// `meshCO`.
#[derive(Debug)]
pub(super) struct Obstacle {
    pub(super) place: Place,
    pub(super) mesh: String,
    pub(super) origin: Point,
    /// The length of the longest side of its box.
    pub(super) scale: f64,
    pub(super) degrees: [f64; 3],
    pub(super) friction: f64,
}

/// `ground` or `halfSpace`.
#[derive(Debug)]
pub(super) struct Plane {
    pub(super) point: Point,
    pub(super) normal: Point,
    pub(super) friction: f64,
}

/// The motion of all shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Script {
    /// Attributes of shapes.
    Null,
    /// Shapes fall from half of the diagonal of their box above their place.
    Fall,
    /// Shapes fall.
    FallNoShift,
    /// Both ends along x turn against each other.
    Twist,
    /// Surfaces are held.
    HeldSurfaces,
    /// Surfaces are held, and solids start with this velocity along x.
    BallHitsWall(f64),
}

impl Default for File {
    /// Config.hpp and Config.cpp of IPC; the tolerance is that of `Optimizer::setRelGL2Tol`.
    fn default() -> Self {
        Self {
            shapes: Vec::new(),
            obstacles: Vec::new(),
            planes: Vec::new(),
            script: Script::Null,
            size: None,
            handle_ratio: 0.01,
            density: 1000.0,
            stiffness: [1e5, 0.4],
            duration: 5.0,
            time_step: 0.025,
            gravity: [0.0, -9.80665, 0.0],
            friction: 0.0,
            is_absolute: false,
            contact_distance: 1e-3,
            static_velocity: 1e-3,
            tolerance: 1e-2,
            lags: 1,
            dirichlet_times: [0.0, f64::INFINITY],
            neumann_times: [0.0, f64::INFINITY],
            notes: Vec::new(),
        }
    }
}

//! The entries of a text scene.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{
    Formulation, Friction, HalfSpace, Integrator, Length, Settings, SolidMaterial, SolidProperties,
};

use super::shape::Shape;
use crate::fault::Place;

/// The most Newton iterations of a time step in IPC (`Optimizer.cpp`).
const MAX_ITERATIONS: usize = 10_000;

/// The tolerance of Newton's method in IPC (`Optimizer::setRelGL2Tol`).
pub(super) const TOLERANCE: f64 = 1e-2;

/// A text scene, with IPC's defaults for all entries that it does not have.
#[derive(Debug)]
pub(super) struct File {
    pub(super) shapes: Vec<Shape>,
    /// Meshes that do not move.
    pub(super) obstacles: Vec<Obstacle>,
    /// The half spaces of `ground` and `halfSpace`, and their friction coefficients.
    pub(super) planes: Vec<(HalfSpace, f64)>,
    pub(super) script: Script,
    pub(super) size: Option<(Place, f64)>,
    pub(super) handle_ratio: f64,
    /// The material of the shapes without one of their own.
    pub(super) material: SolidProperties,
    pub(super) duration: f64,
    /// `dampingStiff` and `dampingRatio`.
    pub(super) damping_stiffness: f64,
    pub(super) damping_ratio: f64,
    /// The settings, with lengths in diagonals of the box.
    pub(super) settings: Settings,
    /// True if lengths are in m.
    pub(super) is_absolute: bool,
    pub(super) dirichlet_times: [f64; 2],
    pub(super) neumann_times: [f64; 2],
}

impl File {
    /// The stiffness damping β, in s. With the time step h, the displacement d in it and the elastic Hessian
    /// K, IPC adds ½ s/h dᵀ K d for `dampingStiff` s to an incremental potential that has ½ β h dᵀ K d here
    /// (`Optimizer::computeDampingMtr`). A `dampingRatio` r stands for s = ¾ r h³ (`Config.cpp`).
    pub(super) fn stiffness_damping(&self) -> f64 {
        let time_step = self.settings.time_step;
        if self.damping_ratio > 0.0 {
            0.75 * self.damping_ratio * time_step
        } else {
            self.damping_stiffness / (time_step * time_step)
        }
    }
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
    /// Config.hpp and Config.cpp of IPC.
    fn default() -> Self {
        Self {
            shapes: Vec::new(),
            obstacles: Vec::new(),
            planes: Vec::new(),
            script: Script::Null,
            size: None,
            handle_ratio: 0.01,
            material: SolidProperties {
                density: 1000.0,
                young: 1e5,
                poisson: 0.4,
                energy: SolidMaterial::NeoHookean,
            },
            duration: 5.0,
            damping_stiffness: 0.0,
            damping_ratio: 0.0,
            settings: Settings {
                time_step: 0.025,
                gravity: [0.0, -9.80665, 0.0],
                integrator: Integrator::ImplicitEuler,
                contact_distance: Length::Relative(1e-3),
                formulation: Formulation::Sum,
                friction: Friction {
                    static_velocity: Length::Relative(1e-3),
                    lags: 1,
                    ..Friction::default()
                },
                tolerance: Length::Relative(TOLERANCE),
                max_iterations: MAX_ITERATIONS,
                ..Settings::default()
            },
            is_absolute: false,
            dirichlet_times: [0.0, f64::INFINITY],
            neumann_times: [0.0, f64::INFINITY],
        }
    }
}

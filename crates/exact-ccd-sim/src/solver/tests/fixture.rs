//! A small system with all kinds of elements, for the tests of sums over them.

use exact_ccd_mesh::{Candidates, Point, Step};
use fastrand::Rng;
use nalgebra::{DMatrix, Vector3};

use crate::energies::anchor::Anchor;
use crate::energies::contact::{Barrier, CollisionSet};
use crate::energies::friction::{FrictionContact, Smoothing};
use crate::energies::term::{Energy, Projection};
use crate::prescribed::Axes;
use crate::settings::Formulation;
use crate::shapes;
use crate::solver::couplings::Couplings;
use crate::solver::pattern::Pattern;
use crate::solver::potential::{Potential, Terms};
use crate::solver::quadratic::Quadratic;
use crate::solver::unknowns::Unknowns;
use crate::system::System;

/// The activation distance of the barrier.
const DISTANCE: f64 = 0.2;

const SMOOTHING: Smoothing = Smoothing { threshold: 0.05 };

/// A cloth between a floor and a box, with a rod and particles above: elements of all kinds, on vertices of
/// all bodies.
pub(super) struct Fixture {
    pub(super) system: System,
    pub(super) terms: Terms,
    pub(super) points: Vec<Point>,
    pub(super) barrier: Barrier,
}

impl Fixture {
    /// The system, stretched by a factor and displaced at random by at most `noise` along each axis.
    pub(super) fn new(stretch: f64, noise: f64) -> Self {
        let mut random = Rng::with_seed(11);
        let floor = shapes::floor([1, 1], [1.3, 1.2]);
        let cloth = shapes::cloth([1, 1], [1.0, 1.1]).placed(|[x, _, z]| [x + 0.2, 0.1, z + 0.1]);
        let solid =
            shapes::solid_box([1, 1, 1], [0.7, 0.6, 0.8]).placed(|[x, y, z]| [x + 0.3, y + 0.2, z + 0.2]);
        let rod = shapes::line(3, 0.9).placed(|[x, _, z]| [x + 0.25, 0.92, z + 0.6]);
        let beads =
            shapes::particles([2, 1, 1], [0.15, 0.0, 0.0]).placed(|[x, _, z]| [x + 0.5, 1.04, z + 0.61]);
        let bodies = [floor, cloth, solid, rod, beads].map(|body| body.with_offset(0.01));
        let system = System::new(&bodies, &[]).unwrap();
        let mut moved = |point: &Point, by: f64| point.map(|x| x + by * (2.0 * random.f64() - 1.0));
        let stretched = |point: &Point| point.map(|x| stretch * x);
        let points: Vec<Point> = system
            .start
            .iter()
            .map(|point| moved(&stretched(point), noise))
            .collect();
        let (duration, held) = (0.1, system.held(0.1));
        let origin: Vec<Point> = points.iter().map(|point| moved(point, 0.04)).collect();
        let free = (0..points.len()).filter(|&vertex| held[vertex] != [true; 3]);
        let inertia = free.map(|vertex| Anchor {
            vertex: vertex as u32,
            target: moved(&points[vertex], 0.3),
            stiffness: Vector3::repeat(system.masses[vertex]),
            force: Vector3::new(0.1, -0.2, 0.3) * system.masses[vertex],
        });
        let terms = Terms {
            duration,
            inertia: inertia.collect(),
            dampers: Vec::new(),
            friction: Vec::new(),
        };
        let mut fixture = Self {
            system,
            terms,
            points,
            barrier: Barrier::new(DISTANCE),
        };
        let collisions = fixture.collisions(&fixture.points);
        let friction = collisions.as_slice().iter().map(|collision| {
            let shortest = collision.shortest_vector(&fixture.points);
            let vertices = collision.vertices().iter().copied().collect();
            FrictionContact::new(vertices, &origin, &shortest, 1e3, SMOOTHING)
        });
        fixture.terms.friction = friction.collect();
        fixture
    }

    pub(super) fn potential(&self) -> Potential<'_> {
        Potential {
            system: &self.system,
            terms: &self.terms,
            stiffness: 1e7,
            twists: &[],
        }
    }

    pub(super) fn collisions(&self, points: &[Point]) -> CollisionSet {
        let step = Step::new(self.system.surface(), points, points).unwrap();
        let candidates = self.system.geometry.near(step, &self.barrier);
        CollisionSet::new(
            self.system.contact_surface(Formulation::default()),
            &candidates,
            points,
            self.barrier,
        )
    }

    /// The empty constraint set.
    pub(super) fn no_collisions(&self) -> CollisionSet {
        let surface = self.system.contact_surface(Formulation::default());
        CollisionSet::new(surface, &Candidates::default(), &self.points, self.barrier)
    }

    /// The known coordinates of each vertex: all of an obstacle and of one vertex of five, two of another
    /// one.
    pub(super) fn known(&self) -> Vec<Axes> {
        let known = |vertex: usize| match vertex % 5 {
            _ if !self.system.is_free(vertex) => [true; 3],
            0 => [true; 3],
            1 => [true, false, true],
            _ => [false; 3],
        };
        (0..self.points.len()).map(known).collect()
    }

    pub(super) fn unknowns(&self) -> Unknowns {
        Unknowns::new(&self.known())
    }

    /// The unknown coordinates: their indices among the coordinates of all vertices, and of the unknown ones.
    pub(super) fn rows(&self) -> [Vec<usize>; 2] {
        let (known, unknowns) = (self.known(), self.unknowns());
        let is_unknown = |&place: &usize| !known[place / 3][place % 3];
        let all: Vec<usize> = (0..3 * known.len()).filter(is_unknown).collect();
        let number = |&place: &usize| 3 * unknowns.number(place as u32 / 3).unwrap() as usize + place % 3;
        let numbered = all.iter().map(number).collect();
        [all, numbered]
    }

    /// The displacements of the coordinates that are not unknown.
    pub(super) fn prescribed(&self) -> Vec<Vector3<f64>> {
        let prescribed = |(vertex, known): (usize, &Axes)| {
            let displacement = Vector3::new(1.0, -2.0, 0.5) * (1.0 + vertex as f64);
            Vector3::from_fn(|axis, _| if known[axis] { displacement[axis] } else { 0.0 })
        };
        self.known().iter().enumerate().map(prescribed).collect()
    }

    pub(super) fn quadratic(&self, collisions: &CollisionSet, unknowns: &Unknowns) -> Quadratic {
        self.quadratic_after(None, collisions, unknowns)
    }

    /// The quadratic model after one with another pattern.
    pub(super) fn quadratic_after(
        &self,
        earlier: Option<&Pattern>,
        collisions: &CollisionSet,
        unknowns: &Unknowns,
    ) -> Quadratic {
        let potential = self.potential();
        let couplings = Couplings::new(&self.system, &[], unknowns);
        potential.quadratic(
            &self.points,
            collisions.as_slice(),
            unknowns,
            &couplings,
            &self.prescribed(),
            earlier,
        )
    }

    /// The projected Hessian with respect to all vertices.
    pub(super) fn dense(&self, collisions: &CollisionSet) -> DMatrix<f64> {
        let points = &self.points;
        let mut dense = DMatrix::zeros(3 * points.len(), 3 * points.len());
        let mut add = |term: &dyn Energy, scale: f64| {
            let hessian = term.hessian(points, Projection::SemiDefinite);
            for (row, &a) in term.vertices().iter().enumerate() {
                for (column, &b) in term.vertices().iter().enumerate() {
                    let mut block = dense.fixed_view_mut::<3, 3>(3 * a as usize, 3 * b as usize);
                    block += hessian.fixed_view::<3, 3>(3 * row, 3 * column) * scale;
                }
            }
        };
        let scale = self.terms.duration * self.terms.duration;
        self.system
            .elastic
            .elements
            .iter()
            .for_each(|element| add(&**element, scale));
        collisions
            .as_slice()
            .iter()
            .for_each(|collision| add(collision, 1e7));
        self.terms.friction.iter().for_each(|contact| add(contact, 1.0));
        self.terms.inertia.iter().for_each(|anchor| add(anchor, 1.0));
        dense
    }
}

//! Generated queries, with the places of their points.

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, InvalidMotion, RigidMotion};
use exact_ccd::{Kind, Point};
use fastrand::Rng;

use crate::places::Place;

/// A query, and the places of its points by the definition.
pub(crate) struct Case<K: Kind> {
    pub(crate) query: CurvedQuery<K>,
    pub(crate) places: Vec<Place>,
}

impl<K: Kind> Case<K> {
    pub(crate) fn of_curves(control: &[K::Points]) -> Self {
        let count = K::Points::default().as_ref().len();
        let curve = |point: usize| -> Vec<Point> { control.iter().map(|set| set.as_ref()[point]).collect() };
        Self {
            query: Bezier::new(control).expect("finite points").into(),
            places: (0..count).map(|point| Place::on_curve(&curve(point))).collect(),
        }
    }

    pub(crate) fn of_bodies(points: K::Points, first: &Chain, second: &Chain) -> Self {
        let place =
            |(i, point): (usize, &Point)| Place::on_body(*point, if i < K::FIRST { first } else { second });
        Self {
            places: points.as_ref().iter().enumerate().map(place).collect(),
            query: CurvedQuery::of_bodies(points, first.clone(), second.clone()).expect("finite points"),
        }
    }
}

/// The numbers that a family draws from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Numbers {
    /// Small integers: coincidences of all kinds are frequent.
    Lattice,
    /// Small integers, with z = 0 and turns about the z axis: coplanar for ever.
    Planar,
    /// Between −1 and 1.
    Uniform,
    /// Powers of ten from −300 to 300.
    Extreme,
}

impl Numbers {
    pub(crate) const ALL: [Self; 4] = [Self::Lattice, Self::Planar, Self::Uniform, Self::Extreme];

    fn number(self, random: &mut Rng) -> f64 {
        match self {
            Self::Lattice | Self::Planar => f64::from(random.i32(-2..=2)),
            Self::Uniform => 2.0 * random.f64() - 1.0,
            Self::Extreme => {
                let power = [1e-300, 1e-20, 1.0, 1e20, 1e300][random.usize(..5)];
                power * f64::from(random.i32(-2..=2))
            }
        }
    }

    pub(crate) fn point(self, random: &mut Rng) -> Point {
        let [x, y, z] = [(); 3].map(|()| self.number(random));
        [x, y, if self == Self::Planar { 0.0 } else { z }]
    }

    pub(crate) fn points<K: Kind>(self, random: &mut Rng) -> K::Points {
        let mut points = K::Points::default();
        points.as_mut().fill_with(|| self.point(random));
        points
    }

    fn quaternion(self, random: &mut Rng) -> [f64; 4] {
        let [a, b, c, d] = [(); 4].map(|()| self.number(random));
        if self == Self::Planar {
            [a, 0.0, 0.0, d]
        } else {
            [a, b, c, d]
        }
    }

    /// Quaternions, one in eight pairs of them almost opposite, and one in eight equal.
    fn quaternions(self, random: &mut Rng) -> [[f64; 4]; 2] {
        let [start, end] = [(); 2].map(|()| self.quaternion(random));
        match random.u32(..8) {
            0 => {
                let mut opposite = start.map(|x| -x);
                opposite[0] += [1e-9, -1e-15][random.usize(..2)];
                [start, opposite]
            }
            1 => [start, start],
            _ => [start, end],
        }
    }

    /// A motion with a place of degree 1, often at rest, or 2.
    pub(crate) fn motion(self, random: &mut Rng) -> RigidMotion {
        loop {
            let quaternions = self.quaternions(random);
            let mut places: Vec<Point> = (0..random.usize(2..=3)).map(|_| self.point(random)).collect();
            if random.u32(..3) == 0 {
                let place = places[0];
                places.fill(place);
            }
            match RigidMotion::new(quaternions, &places) {
                Ok(motion) => return motion,
                Err(InvalidMotion::Zero { .. } | InvalidMotion::Vanishes) => {}
                Err(error) => panic!("{error}"),
            }
        }
    }

    pub(crate) fn chain(self, random: &mut Rng, length: usize) -> Chain {
        Chain::new((0..length).map(|_| self.motion(random))).expect("a short chain")
    }

    pub(crate) fn curves<K: Kind>(self, random: &mut Rng, degree: usize) -> Vec<K::Points> {
        (0..=degree).map(|_| self.points::<K>(random)).collect()
    }
}

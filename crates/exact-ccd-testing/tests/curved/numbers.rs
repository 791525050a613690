//! Generated points and motions, the same on every machine.

use exact_ccd::motion::{Chain, InvalidMotion, RigidMotion};
use exact_ccd::{Kind, Point};
use fastrand::Rng;

/// One of some values. The numbers of `Rng::usize` depend on the machine.
pub(crate) fn one_of<T: Copy>(random: &mut Rng, values: &[T]) -> T {
    values[random.u32(..values.len() as u32) as usize]
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
                let power = one_of(random, &[1e-300, 1e-20, 1.0, 1e20, 1e300]);
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
                opposite[0] += one_of(random, &[1e-9, -1e-15]);
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
            let mut places: Vec<Point> = (0..random.u32(2..=3)).map(|_| self.point(random)).collect();
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

    /// Turns about the z axis, with places on it: all axes coincide.
    pub(crate) fn coaxial(self, random: &mut Rng, length: usize) -> Chain {
        let motions = (0..length).map(|_| {
            let motion = self.motion(random);
            let quaternions = motion.quaternions().map(|[a, b, _, d]| [a, 0.0, 0.0, b + d]);
            let places: Vec<Point> = motion.places().iter().map(|p| [0.0, 0.0, p[2]]).collect();
            RigidMotion::new(quaternions, &places).unwrap_or(motion)
        });
        Chain::new(motions).expect("a short chain")
    }

    /// A turn about the origin, one that undoes it, and perhaps a motion.
    pub(crate) fn undone(self, random: &mut Rng) -> Chain {
        let quaternions = self.motion(random).quaternions();
        let conjugates = quaternions.map(|[a, b, c, d]| [a, -b, -c, -d]);
        let both = [quaternions, conjugates]
            .map(|quaternions| RigidMotion::new(quaternions, &[[0.0; 3]; 2]).expect("a motion"));
        let own = random.bool().then(|| self.motion(random));
        Chain::new(both.into_iter().chain(own)).expect("a short chain")
    }
}

/// A primitive turns about the z axis and touches the plane of the other one at t = 1/2, or misses it, or
/// passes through it, by a little.
pub(crate) fn tangent<K: Kind>(random: &mut Rng) -> (K::Points, Chain) {
    let [c, s] = [(); 2].map(|()| f64::from(random.i32(1..=4)));
    let turn = RigidMotion::new([[c, 0.0, 0.0, -s], [c, 0.0, 0.0, s]], &[[0.0; 3]; 2]);
    let offset = one_of(random, &[0.0, 0.0, 0.0, 1.0, -1.0]) * one_of(random, &[1e-3, 1e-12, f64::EPSILON]);
    let mut points = K::Points::default();
    for (i, point) in points.as_mut().iter_mut().enumerate() {
        let [y, z] = [(); 2].map(|()| f64::from(random.i32(-2..=2)));
        *point = if i < K::FIRST {
            [1.0, 0.0, z]
        } else {
            [1.0 + offset, y, z]
        };
    }
    (points, turn.expect("a motion").into())
}

//! The answers about curved motion: to single queries, by the filters and by integers, and of rigid bodies
//! and curves of vertices.

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, Pose, RigidMotion};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Options, Point, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{Bodies, BodyContact, CurveDetector, Frame, TriangleMesh};

use exact_ccd_testing::hard_cases::digest::Digest;
use exact_ccd_testing::hard_cases::random::Random;

/// The number of queries of each family, and of steps.
const COUNT: usize = 6;

pub(crate) fn digest() -> u64 {
    let mut digest = Digest::default();
    let mut random = Random(1);
    for numbers in [Numbers::Integers, Numbers::Fractions, Numbers::Powers] {
        add_kind::<VertexFace>(&mut digest, &mut random, numbers);
        add_kind::<EdgeEdge>(&mut digest, &mut random, numbers);
        add_kind::<VertexEdge>(&mut digest, &mut random, numbers);
        add_kind::<VertexVertex>(&mut digest, &mut random, numbers);
    }
    for _ in 0..COUNT {
        add_bodies(&mut digest, &mut random);
        add_curves(&mut digest, &mut random);
    }
    digest.0
}

/// The numbers that a family draws from.
#[derive(Clone, Copy)]
enum Numbers {
    /// Small ones: coincidences are frequent.
    Integers,
    Fractions,
    /// Fractions times powers of two that differ much.
    Powers,
}

impl Numbers {
    fn number(self, random: &mut Random) -> f64 {
        match self {
            Self::Integers => random.integer(2),
            Self::Fractions => random.fraction(),
            Self::Powers => {
                let exponent = [-900, -60, 0, 60, 900][random.below(5)];
                random.fraction() * f64::from_bits(((1023 + exponent) as u64) << 52)
            }
        }
    }

    fn point(self, random: &mut Random) -> Point {
        [(); 3].map(|()| self.number(random))
    }

    fn points<K: Kind>(self, random: &mut Random) -> K::Points {
        let mut points = K::Points::default();
        points.as_mut().fill_with(|| self.point(random));
        points
    }

    fn motion(self, random: &mut Random) -> RigidMotion {
        loop {
            let quaternions = [(); 2].map(|()| [(); 4].map(|()| self.number(random)));
            let count = 2 + random.below(3);
            let places: Vec<Point> = (0..count).map(|_| self.point(random)).collect();
            if let Ok(motion) = RigidMotion::new(quaternions, &places) {
                return motion;
            }
        }
    }

    fn chain(self, random: &mut Random, length: usize) -> Chain {
        let motions = (0..length).map(|_| self.motion(random));
        Chain::new(motions).unwrap_or_default()
    }
}

/// Curves of degrees 1 to 4, one body, two bodies, and a chain.
fn add_kind<K: Kind>(digest: &mut Digest, random: &mut Random, numbers: Numbers) {
    for index in 0..COUNT {
        let control: Vec<_> = (0..2 + index % 4).map(|_| numbers.points::<K>(random)).collect();
        if let Ok(curves) = Bezier::<K>::new(&control) {
            add_answers(digest, &curves.into());
        }
        for lengths in [[1, 0], [1, 1], [2, 0]] {
            let points = numbers.points::<K>(random);
            let [first, second] = lengths.map(|length| numbers.chain(random, length));
            if let Ok(query) = CurvedQuery::<K>::of_bodies(points, first, second) {
                add_answers(digest, &query);
            }
        }
    }
}

/// All answers: what the filters prove is the same bits too.
fn add_answers<K: Kind>(digest: &mut Digest, query: &CurvedQuery<K>) {
    let near = Separation::new(0.25).unwrap_or(Separation::ZERO);
    for options in [CONTACT, near.into(), CONTACT.until(0.375)] {
        digest.add(query.collides(options).into());
        let bracket = query.bracket(options);
        digest.add(bracket.is_some().into());
        bracket.iter().flatten().for_each(|&x| digest.add_number(x));
        let first = query.first_time(options);
        digest.add(first.is_some().into());
        first.into_iter().for_each(|time| digest.add_time(time));
    }
    digest.add_intervals(&query.intervals(CONTACT));
    digest.add_impact(query.impact(CONTACT));
}

fn tetrahedron(random: &mut Random) -> Option<Frame> {
    let positions = (0..4).map(|_| Numbers::Fractions.point(random)).collect();
    Frame::new(positions, vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]).ok()
}

fn pose(random: &mut Random) -> Option<Pose> {
    let rotation = [(); 4].map(|()| random.fraction());
    Pose::new(rotation, Numbers::Fractions.point(random).map(|x| 4.0 * x)).ok()
}

/// A step of three bodies.
fn add_bodies(digest: &mut Digest, random: &mut Random) {
    let frames: Option<Vec<_>> = (0..3).map(|_| tetrahedron(random)).collect();
    let poses = [(); 2].map(|()| (0..3).map(|_| pose(random)).collect::<Option<Vec<_>>>());
    let (Some(frames), [Some(start), Some(end)]) = (frames, poses) else {
        digest.add(u64::MAX);
        return;
    };
    let Ok(bodies) = Bodies::new(frames) else {
        digest.add(u64::MAX);
        return;
    };
    for d in [0.0, 0.125] {
        let options = Options::within(Separation::new(d).unwrap_or(Separation::ZERO));
        if let Ok(motions) = bodies.motions(&start, &end) {
            digest.add(bodies.collides(&motions, options).is_ok_and(|found| found).into());
            let first = bodies.collision(&motions, options).unwrap_or_default();
            first.iter().for_each(|contact| add_contact(digest, contact));
            let contacts = bodies.collisions(&motions, options).unwrap_or_default();
            digest.add(contacts.len() as u64);
            contacts.iter().for_each(|contact| add_contact(digest, contact));
        }
        if let Ok(step) = bodies.free_step(&start, &end, 0.75, options) {
            digest.add_number(step.size);
            for pose in &step.poses {
                let numbers = pose.rotation().into_iter().chain(pose.place());
                numbers.for_each(|x| digest.add_number(x));
            }
        }
    }
}

fn add_contact(digest: &mut Digest, contact: &BodyContact) {
    digest.add(contact.kind as u64);
    contact.bodies.iter().for_each(|&body| digest.add(body as u64));
    contact.primitives.iter().for_each(|&id| digest.add(id.into()));
    digest.add_impact(Some(contact.impact));
}

/// A step of a mesh on quadratic curves.
fn add_curves(digest: &mut Digest, random: &mut Random) {
    let Some(Frame { mesh, .. }) = tetrahedron(random) else {
        digest.add(u64::MAX);
        return;
    };
    let faces = mesh
        .faces()
        .iter()
        .flat_map(|face| [*face, face.map(|vertex| vertex + 4)]);
    let Ok(mesh) = TriangleMesh::new(8, faces.collect()) else {
        digest.add(u64::MAX);
        return;
    };
    let mut set = || {
        (0..8)
            .map(|_| Numbers::Fractions.point(random))
            .collect::<Vec<_>>()
    };
    let control = [set(), set(), set()];
    let contacts = CurveDetector::new(mesh).collisions(&[&control[0], &control[1], &control[2]], CONTACT);
    let contacts = contacts.unwrap_or_default();
    digest.add(contacts.len() as u64);
    for contact in contacts {
        contact
            .pair
            .ids()
            .into_iter()
            .for_each(|id| digest.add(id.into()));
        digest.add_impact(Some(contact.impact));
    }
}

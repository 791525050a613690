//! Every search examines only the pairs that can collide.

use exact_ccd::{AnyKind, CONTACT};
use exact_ccd_mesh::{
    BoxKind, Bvh, CanCollide, CandidateOptions, Candidates, Detector, GroupError, GroupMatrix, Pair,
    StepReport, TriangleMesh,
};
use fastrand::Rng;

use super::scene::{PIECES, Scene, contacts};

/// The pairs of vertex lists that a rule allows.
type Allows = dyn Fn(&[u32], &[u32]) -> bool + Sync;

/// A rule, and its definition: the vertices that take part, and the pairs of vertex lists that it allows.
struct Rule {
    can_collide: CanCollide,
    takes_part: Vec<bool>,
    allows: Box<Allows>,
}

impl Rule {
    fn new(can_collide: CanCollide, allows: impl Fn(&[u32], &[u32]) -> bool + Sync + 'static) -> Self {
        let takes_part = vec![true; 4 * PIECES];
        Self {
            can_collide,
            takes_part,
            allows: Box::new(allows),
        }
    }

    /// The same rule among some vertices. Vertices without a flag take part.
    fn among(mut self, parts: &[bool]) -> Self {
        self.can_collide = self.can_collide.among(parts.to_vec());
        self.takes_part[..parts.len()].copy_from_slice(parts);
        self
    }

    fn is_allowed(&self, mesh: &TriangleMesh, pair: Pair) -> bool {
        let vertices = pair.vertices(mesh).unwrap();
        let (a, b) = vertices.split_at(pair.kind().sizes()[0]);
        (self.allows)(a, b)
    }

    /// The pairs of a scene, by definition.
    fn pairs(&self, scene: &Scene) -> Candidates {
        let all = scene.pairs_among(|vertex| self.takes_part[vertex as usize]);
        all.pairs()
            .filter(|&pair| self.is_allowed(&scene.mesh, pair))
            .collect()
    }
}

/// Rules of all kinds for the vertices of a scene of pieces.
fn rules(random: &mut Rng) -> Vec<Rule> {
    let count = 4 * PIECES;
    let flags: Vec<bool> = (0..count).map(|_| random.u8(..3) > 0).collect();
    // Shorter than the number of vertices.
    let groups: Vec<u32> = (0..count - 3).map(|vertex| vertex as u32 / 4 % 2).collect();
    let parts: Vec<bool> = (0..count - 2).map(|_| random.u8(..8) > 0).collect();
    let odd = |a: &[u32], b: &[u32]| (a[0] + b[0]) % 2 == 1;
    let group =
        |groups: &[u32], vertex: u32| groups.get(vertex as usize).map_or(1000 + vertex, |&group| group);
    let obstacles = || {
        let flags = flags.clone();
        Rule::new(CanCollide::not_two_obstacles(flags.clone()), move |a, b| {
            [a, b].concat().iter().any(|&vertex| !flags[vertex as usize])
        })
    };
    vec![
        Rule::new(CanCollide::all(), |_, _| true),
        Rule::new(CanCollide::new(odd), odd),
        Rule::new(CanCollide::any_vertices(|v, w| v + w == 20), |a, b| {
            a.iter().any(|v| b.iter().any(|w| v + w == 20))
        }),
        obstacles(),
        Rule::new(CanCollide::different_groups(groups.clone()), move |a, b| {
            let first = group(&groups, a[0]);
            let mut all = a.iter().chain(b);
            all.any(|&vertex| group(&groups, vertex) != first)
        }),
        by_groups(random),
        obstacles().among(&parts),
        Rule::new(CanCollide::all(), |_, _| true).among(&parts),
        Rule::new(CanCollide::all(), |_, _| true).among(&[false; 4 * PIECES]),
    ]
}

/// A matrix of groups of two pieces each. The last vertices have no group.
fn by_groups(random: &mut Rng) -> Rule {
    let groups: Vec<u32> = (0..4 * PIECES - 3).map(|vertex| vertex as u32 / 8).collect();
    let group_count = PIECES.div_ceil(2);
    let can_collide: Vec<bool> = (0..group_count * group_count).map(|_| random.bool()).collect();
    let can_collide = move |a: usize, b: usize| can_collide[a * group_count + b];
    let matrix = GroupMatrix::from_fn(group_count, &can_collide);
    Rule::new(
        CanCollide::by_groups(groups.clone(), matrix).unwrap(),
        move |a, b| {
            let group = |vertex: &u32| groups.get(*vertex as usize).map(|&group| group as usize);
            a.iter().map(group).any(|a| {
                let can_collide =
                    |b: Option<usize>| a.zip(b).is_none_or(|(a, b)| can_collide(a.min(b), a.max(b)));
                b.iter().map(group).any(can_collide)
            })
        },
    )
}

#[test]
fn contacts_are_those_of_the_pairs_that_can_collide() {
    let mut random = Rng::with_seed(3);
    let (mut found, mut left_out) = (0, 0);
    for _ in 0..60 {
        let (scene, scale) = Scene::pieces(&mut random);
        let step = scene.step();
        let all = contacts(step, &scene.pairs());
        for rule in rules(&mut random) {
            let expected = contacts(step, &rule.pairs(&scene));
            found += expected.len();
            left_out += all.iter().filter(|contact| !expected.contains(contact)).count();
            let can_collide = &rule.can_collide;

            for boxes in [BoxKind::Swept, BoxKind::Moving] {
                let options = CandidateOptions::default()
                    .with_distance(0.1 * scale)
                    .with_boxes(boxes)
                    .with_can_collide(can_collide.clone());
                let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
                assert_eq!(candidates.collisions(step, CONTACT), expected);
                let report = StepReport::with_options(step, &Bvh, &options, &|_| ()).unwrap();
                assert_eq!(report.candidates, candidates.counts());
                assert_eq!(report.colliding.total(), expected.len());
                assert_eq!(report.earliest, expected.first().copied());
            }

            let counts = |pair: Pair| rule.is_allowed(&scene.mesh, pair);
            let mut open = Detector::new(scene.mesh.clone());
            let collides = open.collides_if(&scene.x0, &scene.x1, CONTACT, counts).unwrap();
            assert_eq!(collides, all.iter().any(|contact| counts(contact.pair)));
            let mut detector = Detector::new(scene.mesh.clone()).with_can_collide(can_collide.clone());
            for _ in 0..2 {
                let (x0, x1) = (&scene.x0, &scene.x1);
                assert_eq!(detector.collisions(x0, x1, CONTACT).unwrap(), expected);
                assert_eq!(
                    detector.collision(x0, x1, CONTACT).unwrap(),
                    expected.first().copied()
                );
                assert_eq!(detector.collides(x0, x1, CONTACT).unwrap(), !expected.is_empty());
            }
        }
    }
    assert!(found > 1000 && left_out > 1000, "{found} {left_out}");
}

#[test]
fn candidates_are_those_of_all_pairs_that_can_collide() {
    let mut random = Rng::with_seed(4);
    for _ in 0..40 {
        let (scene, _) = Scene::pieces(&mut random);
        let all = Candidates::new(scene.step(), &Bvh);
        for rule in rules(&mut random) {
            let allowed = rule.pairs(&scene);
            let options = CandidateOptions::default().with_can_collide(rule.can_collide);
            let candidates = Candidates::with_options(scene.step(), &Bvh, &options).unwrap();
            let both = |a: &[[u32; 2]], b: &[[u32; 2]]| -> Vec<[u32; 2]> {
                a.iter().filter(|pair| b.contains(pair)).copied().collect()
            };
            assert_eq!(
                candidates.of_kind(AnyKind::VertexFace),
                both(
                    all.of_kind(AnyKind::VertexFace),
                    allowed.of_kind(AnyKind::VertexFace)
                )
            );
            assert_eq!(
                candidates.of_kind(AnyKind::EdgeEdge),
                both(all.of_kind(AnyKind::EdgeEdge), allowed.of_kind(AnyKind::EdgeEdge))
            );
        }
    }
}

/// Five vertices. The last two have no flag and no group.
#[test]
fn rules_name_the_pairs_that_they_allow() {
    let obstacles = CanCollide::not_two_obstacles(vec![true, false, true]);
    let groups = CanCollide::different_groups(vec![7, 8, 7]);
    let sums = CanCollide::any_vertices(|v, w| v + w == 4);
    let among = CanCollide::all().among(vec![true, false, true]);
    let matrix = GroupMatrix::from_fn(2, |a, b| a == 1 && b == 1);
    let by_groups = CanCollide::by_groups(vec![0, 1, 1], matrix.clone()).unwrap();
    let cases: [(&[u32], &[u32], [bool; 5]); 8] = [
        (&[0], &[2], [false, false, false, true, false]),
        (&[0], &[1], [true, true, false, false, false]),
        (&[1], &[0], [true, true, false, false, false]),
        (&[0], &[2, 1], [true, true, false, false, false]),
        (&[1], &[2], [true, true, false, false, true]),
        (&[0], &[3], [true, true, false, true, true]),
        (&[3], &[4], [true, true, false, true, true]),
        (&[0, 1], &[2, 3], [true, true, true, false, true]),
    ];
    let missing = GroupError::NoSuchGroup {
        vertex: 1,
        group: 2,
        group_count: 2,
    };
    assert_eq!(CanCollide::by_groups(vec![0, 2], matrix).err(), Some(missing));
    for (a, b, expected) in cases {
        let found = [&obstacles, &groups, &sums, &among, &by_groups].map(|rule| rule.allows(a, b));
        assert_eq!(found, expected, "{a:?} {b:?}");
    }
    assert!(CanCollide::all().is_all() && !obstacles.is_all() && !among.is_all());
}

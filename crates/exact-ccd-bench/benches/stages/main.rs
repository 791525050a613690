//! The cost of each stage, from one query to a whole step, on generated input.
//!
//! `cargo bench -p exact-ccd-bench --bench stages [-- NAME...]`
//!
//! A scalar benchmark answers a thousand queries, all settled at one stage: 1 µs is 1 ns a query.
//! Benchmarks of batches, boxes and steps have the throughput in queries, boxes or candidates a
//! second.

mod settled;

use std::fmt;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::sync::LazyLock;

use divan::Bencher;
use divan::counter::ItemsCount;
use exact_ccd::batch::{Instructions, Trajectories};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Point, Query, Stage, VertexFace};
use exact_ccd_mesh::{Aabb, BoxPairs, Boxes, Bvh, Detector, StepReport, Sweep};

use exact_ccd_bench::cloth::{self as of_cloth, Cloth};

fn main() {
    divan::main();
}

/// The number of queries that are answered in turn.
const QUERIES: usize = 1000;

/// The queries, repeated until there are [`QUERIES`] of them.
fn repeated<K: Kind>(queries: &[Query<K>]) -> Vec<Query<K>> {
    assert!(!queries.is_empty(), "no query of this stage");
    queries.iter().cycle().take(QUERIES).cloned().collect()
}

/// The stages that decide contact.
const CONTACT_STAGES: [Stage; 10] = [
    Stage::BoundingBox,
    Stage::Diagonals,
    Stage::Normals,
    Stage::Coplanarity,
    Stage::Roots,
    Stage::Coincident,
    Stage::Direction,
    Stage::Planar,
    Stage::FixedWidth,
    Stage::Exact,
];

#[divan::bench(types = [VertexFace, EdgeEdge], args = CONTACT_STAGES, sample_count = 20)]
fn collides<K: Kind<Points = [Point; 4]> + Sync>(bencher: Bencher<'_, '_>, stage: Stage) {
    let queries = repeated(&settled::decided::<K>(stage));
    bencher.counter(ItemsCount::new(queries.len())).bench(|| {
        queries
            .iter()
            .filter(|query| black_box(*query).collides(CONTACT))
            .count()
    });
}

#[divan::bench(types = [VertexFace, EdgeEdge], args = CONTACT_STAGES, sample_count = 20)]
fn intervals<K: Kind<Points = [Point; 4]> + Sync>(bencher: Bencher<'_, '_>, stage: Stage) {
    let queries = repeated(&settled::timed::<K>(stage));
    bencher.counter(ItemsCount::new(queries.len())).bench(|| {
        for query in &queries {
            black_box(black_box(query).intervals(CONTACT));
        }
    });
}

/// Cloth in contact at the end: some hundred thousand candidates.
static LANDING: LazyLock<Cloth> = LazyLock::new(|| Cloth::new(50, 0.1));
/// Cloth without contact, which is decided only after the last candidate.
static FREE: LazyLock<Cloth> = LazyLock::new(|| Cloth::new(50, 0.45));

/// Vector instructions under their short name.
#[derive(Clone, Copy)]
struct Named(Instructions);

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let long = format!("{:?}", self.0);
        let name = long.split(['(', ')']).nth(1);
        f.write_str(name.unwrap_or(&long))
    }
}

fn instructions() -> impl Iterator<Item = Named> {
    Instructions::available().map(Named)
}

fn count<K: Kind<Vertices = [u32; 4]>>(bencher: Bencher<'_, '_>, instructions: Named, queries: &[[u32; 4]]) {
    let [x0, x1] = LANDING.step().positions();
    let trajectories = Trajectories::new(x0, x1).expect("the positions of a step are sound");
    let trajectories = trajectories.with_instructions(instructions.0);
    bencher.counter(ItemsCount::new(queries.len())).bench(|| {
        let mut colliding = 0;
        let counted = trajectories.collisions::<K>(black_box(queries), CONTACT, |_, _| colliding += 1);
        counted.map(|()| colliding)
    });
}

#[divan::bench(args = instructions())]
fn batch_vertex_face(bencher: Bencher<'_, '_>, instructions: Named) {
    count::<VertexFace>(bencher, instructions, &of_cloth::vertex_face(LANDING.step()));
}

#[divan::bench(args = instructions())]
fn batch_edge_edge(bencher: Bencher<'_, '_>, instructions: Named) {
    count::<EdgeEdge>(bencher, instructions, &of_cloth::edge_edge(LANDING.step()));
}

/// The boxes of the edges at the start and at the end.
fn edge_boxes() -> Vec<[Aabb; 2]> {
    let step = LANDING.step();
    let ends = |edge: &[u32; 2]| {
        step.positions()
            .map(|x| edge.iter().map(|&vertex| x[vertex as usize]).collect())
    };
    step.mesh().edges().iter().map(ends).collect()
}

#[divan::bench]
fn boxes(bencher: Bencher<'_, '_>) {
    let boxes = edge_boxes();
    bencher
        .counter(ItemsCount::new(boxes.len()))
        .bench(|| Boxes::new(black_box(&boxes)));
}

fn within(bencher: Bencher<'_, '_>, broad_phase: impl BoxPairs<2>) {
    let boxes = Boxes::new(&edge_boxes()).expect("the cloth has few edges");
    let visit = |pairs: &[[u32; 2]]| {
        black_box(pairs);
        ControlFlow::Continue(())
    };
    bencher
        .counter(ItemsCount::new(boxes.len()))
        .bench(|| broad_phase.within(black_box(&boxes), &visit));
}

#[divan::bench]
fn bvh(bencher: Bencher<'_, '_>) {
    within(bencher, Bvh);
}

#[divan::bench]
fn sweep(bencher: Bencher<'_, '_>) {
    within(bencher, Sweep);
}

fn candidate_count(cloth: &Cloth) -> ItemsCount {
    ItemsCount::new(StepReport::new(cloth.step(), &Bvh, &|_| ()).candidates.total())
}

#[divan::bench]
fn step_report(bencher: Bencher<'_, '_>) {
    bencher
        .counter(candidate_count(&LANDING))
        .bench(|| StepReport::new(black_box(LANDING.step()), &Bvh, &|_| ()));
}

#[divan::bench]
fn step_collision(bencher: Bencher<'_, '_>) {
    let detector = Detector::new(LANDING.step().mesh().clone());
    let [x0, x1] = LANDING.step().positions();
    bencher
        .counter(candidate_count(&LANDING))
        .bench(|| detector.clone().collision(black_box(x0), x1, CONTACT));
}

#[divan::bench]
fn step_collides(bencher: Bencher<'_, '_>) {
    let detector = Detector::new(FREE.step().mesh().clone());
    let [x0, x1] = FREE.step().positions();
    bencher
        .counter(candidate_count(&FREE))
        .bench(|| detector.clone().collides(black_box(x0), x1, CONTACT));
}

//! The number of instructions of a query, which does not depend on other load on the machine.
//!
//! ```sh
//! apt install valgrind                               # or as the system installs it
//! cargo install --version 0.20.0 gungraun-runner     # the version of `gungraun` in Cargo.lock
//! cargo bench -p exact-ccd-bench --features instructions --bench instructions
//! ```
//!
//! Without the feature this is not compiled, and `cargo bench` needs neither. A second run has the
//! differences to the first.
//!
//! Each benchmark answers a thousand queries, candidates of generated cloth: a thousandth of its
//! instructions is the cost of one. A batch uses the narrowest vector instructions and the widest
//! that valgrind supports, which are not AVX-512.

#![expect(missing_docs, unused_qualifications, reason = "code of the macros")]

use std::hint::black_box;
use std::marker::PhantomData;

use exact_ccd::batch::{Instructions, Trajectories};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Query, VertexFace};
use exact_ccd_mesh::Step;
use gungraun::{library_benchmark, library_benchmark_group, main};

use exact_ccd_bench::cloth::{self as of_cloth, Cloth};

/// The number of queries in each benchmark.
const QUERIES: usize = 1000;

/// Queries of one kind over the vertices of a mesh.
struct Batch<K> {
    trajectories: Trajectories,
    queries: Vec<[u32; 4]>,
    kind: PhantomData<K>,
}

impl<K: Kind<Vertices = [u32; 4]>> Batch<K> {
    fn new(instructions: Instructions, queries: fn(Step<'_>) -> Vec<[u32; 4]>) -> Self {
        // Large enough for a thousand colliding queries of either kind.
        let cloth = Cloth::new(33, 0.1);
        let [x0, x1] = cloth.step().positions();
        let trajectories = Trajectories::new(x0, x1).expect("the positions of a step are sound");
        Self {
            trajectories: trajectories.with_instructions(instructions),
            queries: queries(cloth.step()),
            kind: PhantomData,
        }
    }

    /// A thousand of its queries, evenly spread over the mesh.
    fn sampled(self) -> Self {
        let stride = self.queries.len() / QUERIES;
        Self {
            queries: self.queries.into_iter().step_by(stride).take(QUERIES).collect(),
            ..self
        }
    }

    fn colliding(&self) -> Vec<Query<K>> {
        let mut colliding = Vec::new();
        self.trajectories
            .collisions::<K>(&self.queries, CONTACT, |_, collision| {
                colliding.push(*collision.query());
            })
            .expect("a mesh has the vertices of its primitives");
        let stride = colliding.len() / QUERIES;
        colliding.into_iter().step_by(stride).take(QUERIES).collect()
    }
}

fn vertex_face(instructions: Instructions) -> Batch<VertexFace> {
    Batch::new(instructions, of_cloth::vertex_face).sampled()
}

fn edge_edge(instructions: Instructions) -> Batch<EdgeEdge> {
    Batch::new(instructions, of_cloth::edge_edge).sampled()
}

fn colliding_vertex_face() -> Vec<Query<VertexFace>> {
    Batch::new(Instructions::best(), of_cloth::vertex_face).colliding()
}

fn colliding_edge_edge() -> Vec<Query<EdgeEdge>> {
    Batch::new(Instructions::best(), of_cloth::edge_edge).colliding()
}

fn narrowest() -> Instructions {
    Instructions::available().next().unwrap_or_default()
}

#[library_benchmark]
#[bench::vertex_face_narrowest(vertex_face(narrowest()))]
#[bench::vertex_face_widest(vertex_face(Instructions::best()))]
#[bench::edge_edge_narrowest(edge_edge(narrowest()))]
#[bench::edge_edge_widest(edge_edge(Instructions::best()))]
fn batch<K: Kind<Vertices = [u32; 4]>>(batch: Batch<K>) -> usize {
    let mut colliding = 0;
    let counted = batch
        .trajectories
        .collisions::<K>(&batch.queries, CONTACT, |_, _| colliding += 1);
    counted.map_or(0, |()| black_box(colliding))
}

#[library_benchmark]
#[bench::vertex_face(colliding_vertex_face())]
#[bench::edge_edge(colliding_edge_edge())]
fn collides<K: Kind<Vertices = [u32; 4]>>(queries: Vec<Query<K>>) -> usize {
    queries
        .iter()
        .filter(|query| black_box(*query).collides(CONTACT))
        .count()
}

#[library_benchmark]
#[bench::vertex_face(colliding_vertex_face())]
#[bench::edge_edge(colliding_edge_edge())]
fn intervals<K: Kind<Vertices = [u32; 4]>>(queries: Vec<Query<K>>) -> usize {
    queries
        .iter()
        .filter_map(|query| black_box(query).intervals(CONTACT).count())
        .sum()
}

library_benchmark_group!(name = kernel, benchmarks = [batch, collides, intervals]);

main!(library_benchmark_groups = kernel);

//! A method of one's own against those of this project: `cargo run --release -p exact-ccd-bench --example own_method`.
//!
//! It asks random queries. On a folder of data sets, `Source::all` finds them: see `exact-ccd bench`.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::time::Duration;

use exact_ccd::{EdgeEdge, Point, Query, VertexFace};
use exact_ccd_bench::comparison::{Comparison, Contestant, PeerError, Subject, Subjects};
use exact_ccd_methods::{Answer, Exact, Method, Promise, RootParity, Time};

/// Says that primitives collide if the boxes around their motion overlap.
struct Boxes;

/// Whether the box of the first points, at both times, overlaps that of the others.
fn overlap(points: &[[Point; 4]; 2], first: usize) -> Answer {
    let range = |from: usize, to: usize, axis: usize| {
        let values = points
            .iter()
            .flat_map(|now| &now[from..to])
            .map(|point| point[axis]);
        values.fold([f64::MAX, f64::MIN], |[least, most], x| {
            [least.min(x), most.max(x)]
        })
    };
    let overlap = |axis| {
        let ([a, b], [c, d]) = (range(0, first, axis), range(first, 4, axis));
        a <= d && c <= b
    };
    Answer::from_decision((0..3).all(overlap))
}

impl Method for Boxes {
    fn name(&self) -> &str {
        "boxes"
    }
    fn promise(&self) -> Promise {
        Promise {
            may_miss: false,
            may_invent: true,
            time: Time::Absent,
        }
    }
    fn vertex_face(&self, query: &Query<VertexFace>) -> Answer {
        overlap(query.points(), 1)
    }
    fn edge_edge(&self, query: &Query<EdgeEdge>) -> Answer {
        overlap(query.points(), 2)
    }
}

fn main() -> Result<(), PeerError> {
    let mut random = fastrand::Rng::with_seed(1);
    let mut subjects = Subjects::<VertexFace>::new(2000);
    for _ in 0..10_000 {
        let mut points = || [(); 4].map(|()| [(); 3].map(|()| random.f64()));
        let query = Query::new(points(), points()).expect("random numbers are finite");
        subjects.add(Subject::new(query, None));
    }
    let contestants = [
        Box::new(Exact) as Box<dyn Method>,
        Box::new(RootParity),
        Box::new(Boxes),
    ];
    let contestants = contestants.into_iter().map(Contestant::Method).collect();
    let table = Comparison::new(contestants, Duration::from_secs(10)).run("random", &subjects, &|_| ())?;
    println!("{}", table.markdown());
    Ok(())
}

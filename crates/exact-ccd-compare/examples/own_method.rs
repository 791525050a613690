//! Comparison of a user-defined method with two of this project, on random queries: `cargo run
//! --release -p exact-ccd-compare --example own_method`.
//!
//! `Source::all` finds the data sets in a folder: see `exact-ccd bench`.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::time::Duration;

use exact_ccd::{Ccd, Decide, EdgeEdge, Exact, Guarantees, Point, Query, TimeGuarantee, VertexFace};
use exact_ccd_compare::{Comparison, Contestant, Subject, Subjects};
use exact_ccd_methods::parity::RootParity;

/// Decides that primitives collide if the boxes around their motion overlap.
struct Boxes;

/// True if the boxes of the points before and from index `second` overlap, each at both times.
fn overlap(points: &[[Point; 4]; 2], second: usize) -> bool {
    let range = |from: usize, to: usize, axis: usize| {
        let values = points
            .iter()
            .flat_map(|frame| &frame[from..to])
            .map(|point| point[axis]);
        values.fold([f64::MAX, f64::MIN], |[least, most], x| {
            [least.min(x), most.max(x)]
        })
    };
    (0..3).all(|axis| {
        let ([a, b], [c, d]) = (range(0, second, axis), range(second, 4, axis));
        a <= d && c <= b
    })
}

impl Decide<VertexFace> for Boxes {
    fn collides(&self, query: &Query<VertexFace>) -> bool {
        overlap(query.points(), 1)
    }
}

impl Decide<EdgeEdge> for Boxes {
    fn collides(&self, query: &Query<EdgeEdge>) -> bool {
        overlap(query.points(), 2)
    }
}

impl Ccd for Boxes {
    fn name(&self) -> &'static str {
        "boxes"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: false,
            false_positives: true,
            time: TimeGuarantee::Absent,
        }
    }
}

fn main() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut subjects = Subjects::<VertexFace>::new(2000);
    for _ in 0..10_000 {
        let mut points = || [(); 4].map(|()| [(); 3].map(|()| random.f64()));
        let query = Query::new(points(), points()).expect("random numbers are finite");
        subjects.add(Subject::new(query, None));
    }
    let contestants = [
        Box::new(Exact) as Box<dyn Ccd>,
        Box::new(RootParity::default()),
        Box::new(Boxes),
    ];
    let contestants = contestants.into_iter().map(Contestant::Method).collect();
    let table = Comparison::new(contestants, Duration::from_secs(10)).run("random", &subjects, &|_| ());
    println!("{}", table.markdown());
}

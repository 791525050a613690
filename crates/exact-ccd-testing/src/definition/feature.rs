//! The pairs of features. The distance of the nearest pair is the distance of the primitives.

use std::array::from_fn;
use std::cmp::Ordering::{Equal, Greater, Less};

use dashu_int::IBig;
use exact_ccd::AnyKind;

use super::polynomial::Polynomial;
use super::root::{self, Function, Root};
use super::time::Time;

/// A point: its coordinates at time t.
pub type Vector = [Polynomial; 3];

/// Two features at the distance √(N / M), if their closest points lie inside of both: if M > 0 and all guards
/// are at least 0.
pub(crate) struct Feature {
    /// N − d² M. At d = 0, N is a sum of squares that is at most 0 where all of them vanish: there, this is
    /// their greatest common divisor, which has a lower degree.
    excess: Function,
    is_contact: bool,
    /// M.
    measure: Function,
    guards: Vec<Function>,
}

/// All pairs of features of two primitives.
pub(crate) fn all(kind: AnyKind, p: &[Vector], d: &Polynomial) -> Vec<Feature> {
    let pairs = |vertices: &[[usize; 2]], edges: &[[usize; 3]]| -> Vec<Feature> {
        let vertices = vertices.iter().map(|&[i, j]| vertex_vertex(&p[i], &p[j], d));
        let edges = edges.iter().map(|&[i, j, k]| vertex_edge(&p[i], &p[j], &p[k], d));
        vertices.chain(edges).collect()
    };
    let mut all = match kind {
        AnyKind::VertexFace => pairs(&[[0, 1], [0, 2], [0, 3]], &[[0, 1, 2], [0, 2, 3], [0, 3, 1]]),
        AnyKind::EdgeEdge => pairs(
            &[[0, 2], [0, 3], [1, 2], [1, 3]],
            &[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]],
        ),
        AnyKind::VertexEdge => pairs(&[[0, 1], [0, 2]], &[[0, 1, 2]]),
        AnyKind::VertexVertex => pairs(&[[0, 1]], &[]),
    };
    match kind {
        AnyKind::VertexFace => all.push(vertex_face(&p[0], &p[1], &p[2], &p[3], d)),
        AnyKind::EdgeEdge => all.push(edge_edge(&p[0], &p[1], &p[2], &p[3], d)),
        AnyKind::VertexEdge | AnyKind::VertexVertex => {}
    }
    all
}

fn vertex_vertex(p: &Vector, a: &Vector, d: &Polynomial) -> Feature {
    let one = Polynomial::new(vec![IBig::ONE]);
    Feature::new(minus(p, a).into(), one, vec![], d)
}

fn vertex_edge(p: &Vector, a: &Vector, b: &Vector, d: &Polynomial) -> Feature {
    let (x, e) = (minus(p, a), minus(b, a));
    let (along, measure) = (dot(&e, &x), dot(&e, &e));
    let guards = vec![along.clone(), measure.minus(&along)];
    Feature::new(cross(&e, &x).into(), measure, guards, d)
}

fn vertex_face(p: &Vector, a: &Vector, b: &Vector, c: &Vector, d: &Polynomial) -> Feature {
    let n = cross(&minus(b, a), &minus(c, a));
    let inside = |x: &Vector, y: &Vector| dot(&n, &cross(&minus(y, x), &minus(p, x)));
    let guards = vec![inside(a, b), inside(b, c), inside(c, a)];
    Feature::new(vec![dot(&n, &minus(p, a))], dot(&n, &n), guards, d)
}

fn edge_edge(a: &Vector, b: &Vector, c: &Vector, e: &Vector, d: &Polynomial) -> Feature {
    let (first, second, w) = (minus(b, a), minus(e, c), minus(c, a));
    let n = cross(&first, &second);
    let measure = dot(&n, &n);
    let (u, v) = (dot(&n, &cross(&w, &second)), dot(&n, &cross(&w, &first)));
    let guards = vec![u.clone(), measure.minus(&u), v.clone(), measure.minus(&v)];
    Feature::new(vec![dot(&n, &w)], measure, guards, d)
}

impl Feature {
    /// N is the sum of the squares of the terms.
    fn new(terms: Vec<Polynomial>, measure: Polynomial, guards: Vec<Polynomial>, d: &Polynomial) -> Self {
        let zero = Polynomial::new(vec![]);
        let is_contact = d.is_zero();
        let excess = if is_contact {
            terms.iter().fold(zero, |gcd, term| gcd.gcd(term))
        } else {
            let squares = terms.iter().map(|term| term.times(term));
            let squares = squares.fold(zero, |sum, square| sum.plus(&square));
            squares.minus(&measure.times(&d.times(d)))
        };
        Self {
            excess: Function::new(excess),
            is_contact,
            measure: Function::new(measure),
            guards: guards.into_iter().map(Function::new).collect(),
        }
    }

    /// The functions at whose roots the features can begin or end to be within d.
    pub(crate) fn functions(&self) -> impl Iterator<Item = &Function> {
        self.guards.iter().chain([&self.excess, &self.measure])
    }

    /// True if N / M is at most d² at some time of the step, inside or not.
    pub(crate) fn is_ever_near(&self) -> bool {
        self.is_close_at(&mut Root::at(Time::zero())) || !root::isolate(&self.excess).is_empty()
    }

    fn is_close_at(&self, root: &mut Root) -> bool {
        match root.sign_of(&self.excess) {
            Equal => true,
            Less => !self.is_contact,
            Greater => false,
        }
    }

    /// True if the features are within d at a time, with closest points inside of both.
    pub(crate) fn is_near_at(&self, root: &mut Root) -> bool {
        self.is_close_at(root)
            && root.sign_of(&self.measure) == Greater
            && self.guards.iter().all(|guard| root.sign_of(guard) != Less)
    }
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    from_fn(|axis| a[axis].minus(&b[axis]))
}

fn dot(a: &Vector, b: &Vector) -> Polynomial {
    (0..3).fold(Polynomial::new(vec![]), |sum, axis| {
        sum.plus(&a[axis].times(&b[axis]))
    })
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    from_fn(|axis| {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        a[i].times(&b[j]).minus(&a[j].times(&b[i]))
    })
}

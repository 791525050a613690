//! The contacts of a step in integer arithmetic.

use exact_ccd::{CONTACT, EdgeEdge, Impact, Kind, Query, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{Motion, Pair, PairCounts, Point};

/// The contacts of a step in integer arithmetic, for every pair without a common vertex.
#[derive(Default)]
pub(crate) struct Truth {
    pub(crate) vertex_face: Vec<[u32; 2]>,
    pub(crate) edge_edge: Vec<[u32; 2]>,
    pub(crate) vertex_edge: Vec<[u32; 2]>,
    pub(crate) vertex_vertex: Vec<[u32; 2]>,
    pub(crate) colliding: PairCounts,
    pub(crate) touching: PairCounts,
    pub(crate) earliest: Option<(Pair, Impact)>,
}

impl Truth {
    pub(crate) fn of(motion: &Motion) -> Self {
        let mut truth = Self::default();
        let at = |vertices| [&motion.x0, &motion.x1].map(|x| gather(x, vertices));
        for vertex in 0..motion.x0.len() as u32 {
            for (face, &[a, b, c]) in (0..).zip(motion.mesh.faces()) {
                if [a, b, c].contains(&vertex) {
                    continue;
                }
                let [t0, t1] = at([vertex, a, b, c]);
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    truth.vertex_face.push([vertex, face]);
                }
                let pair = Pair::VertexFace { vertex, face };
                truth.count(pair, Query::<VertexFace>::new(t0, t1).unwrap());
            }
        }
        let edges = motion.mesh.edges();
        for (b, &[b0, b1]) in (0..).zip(edges) {
            for (a, &[a0, a1]) in (0..).zip(&edges[..b as usize]) {
                if [a0, a1].iter().any(|vertex| [b0, b1].contains(vertex)) {
                    continue;
                }
                let [t0, t1] = at([a0, a1, b0, b1]);
                if boxes_meet([&t0[..2], &t1[..2]], [&t0[2..], &t1[2..]]) {
                    truth.edge_edge.push([a, b]);
                }
                truth.count(Pair::EdgeEdge { a, b }, Query::<EdgeEdge>::new(t0, t1).unwrap());
            }
        }
        truth.edge_edge.sort_unstable();
        truth.count_loose(motion);
        truth
    }

    /// Counts the pairs of vertices with loose edges, and of loose vertices with each other, if no edge of a
    /// vertex is apart from the other primitive.
    fn count_loose(&mut self, motion: &Motion) {
        let points: Vec<u32> = motion.mesh.loose_vertices().collect();
        let rods = motion.mesh.loose_edges();
        let first_rod = (motion.mesh.edges().len() - rods.len()) as u32;
        for p in 0..motion.mesh.vertex_count() as u32 {
            for (edge, &[a, b]) in (first_rod..).zip(rods) {
                let of_p = motion.mesh.edges().iter().filter(|edge| edge.contains(&p));
                let mut apart = of_p.filter(|edge| !edge.contains(&a) && !edge.contains(&b));
                if [a, b].contains(&p) || apart.next().is_some() {
                    continue;
                }
                let [t0, t1] = [&motion.x0, &motion.x1].map(|x| gather(x, [p, a, b]));
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    self.vertex_edge.push([p, edge]);
                }
                let pair = Pair::VertexEdge { vertex: p, edge };
                self.count(pair, Query::<VertexEdge>::new(t0, t1).unwrap());
            }
        }
        for (i, &p) in points.iter().enumerate() {
            for &q in &points[i + 1..] {
                let [t0, t1] = [&motion.x0, &motion.x1].map(|x| gather(x, [p, q]));
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    self.vertex_vertex.push([p, q]);
                }
                let pair = Pair::VertexVertex { a: p, b: q };
                self.count(pair, Query::<VertexVertex>::new(t0, t1).unwrap());
            }
        }
    }

    /// Counts a pair if it collides, and if it touches at t = 0. Keeps the earliest contact.
    fn count<K: Kind>(&mut self, pair: Pair, query: Query<K>) {
        let Some(time) = query.exactly().intervals(CONTACT).first_time() else {
            return;
        };
        let impact = query.impact(CONTACT).unwrap();
        assert_eq!(impact.time, time);
        let key =
            |(pair, impact): &(Pair, Impact)| (impact.time.lower().to_bits(), !impact.time.is_exact(), *pair);
        let earlier = self
            .earliest
            .is_none_or(|earliest| key(&(pair, impact)) < key(&earliest));
        if earlier {
            self.earliest = Some((pair, impact));
        }
        self.colliding[pair.kind()] += 1;
        self.touching[pair.kind()] += usize::from(time.is_exact() && time.lower() == 0.0);
    }
}

fn gather<const N: usize>(x: &[Point], vertices: [u32; N]) -> [Point; N] {
    vertices.map(|vertex| x[vertex as usize])
}

/// True unless an axis separates the boxes around two primitives at both ends of the step, in the same order.
fn boxes_meet(a: [&[Point]; 2], b: [&[Point]; 2]) -> bool {
    (0..3).all(|axis| {
        let coordinates = |points: &[Point]| points.iter().map(|point| point[axis]).collect::<Vec<_>>();
        let lower = |points: &[Point]| coordinates(points).into_iter().fold(f64::INFINITY, f64::min);
        let upper = |points: &[Point]| coordinates(points).into_iter().fold(f64::NEG_INFINITY, f64::max);
        let is_below =
            |a: [&[Point]; 2], b: [&[Point]; 2]| (0..2).all(|time| upper(a[time]) < lower(b[time]));
        !is_below(a, b) && !is_below(b, a)
    })
}

//! Random scenes and their pairs, by definition.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{CanCollide, Candidates, Contact, Pair, PairKind, Point, Step, TriangleMesh};
use fastrand::Rng;

pub(crate) struct Scene {
    pub(crate) mesh: TriangleMesh,
    pub(crate) x0: Vec<Point>,
    pub(crate) x1: Vec<Point>,
}

/// The number of pieces of a scene, each of two triangles.
pub(crate) const PIECES: usize = 5;

impl Scene {
    /// Pieces of random shape in random motion, at scales between a nanometre and a metre, near the
    /// origin or far from it.
    pub(crate) fn pieces(random: &mut Rng) -> (Self, f64) {
        let mut choose = |choices: &[f64]| choices[random.usize(..choices.len())];
        let scale = choose(&[1.0, 1e-3, 1e-9]);
        let offset = [0, 1, 2].map(|_| choose(&[0.0, 0.0, 1.0, -1e6]));
        // Far from the origin, the shortest motions are shorter than the distance of two f64.
        let motion = scale * choose(&[0.0, 1e-15, 1e-3, 0.3, 3.0]);
        // On a grid, many pieces touch in corners and along edges.
        let grid = choose(&[0.0, 0.25, 0.5]);
        let mut coordinate = |centre: f64| {
            let x = centre + random.f64() - 0.5;
            if grid > 0.0 { grid * (x / grid).round() } else { x }
        };
        let (mut x0, mut x1, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for piece in 0..PIECES as u32 {
            faces.extend([[0, 1, 2], [3, 2, 1]].map(|face| face.map(|corner| 4 * piece + corner)));
            let centre = [0; 3].map(|_| 2.0 * coordinate(0.0));
            let drift = [0; 3].map(|_| coordinate(0.0));
            for _ in 0..4 {
                let at = centre.map(&mut coordinate);
                let by = drift.map(|drift| drift + 0.2 * coordinate(0.0));
                x0.push([0, 1, 2].map(|axis: usize| offset[axis] + scale * at[axis]));
                x1.push([0, 1, 2].map(|axis: usize| offset[axis] + (scale * at[axis] + motion * by[axis])));
            }
        }
        let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
        (Self { mesh, x0, x1 }, scale)
    }

    /// Sheets of 2 n² faces above each other, a little uneven, whose vertices all move at random:
    /// they crumple.
    pub(crate) fn sheets(random: &mut Rng, n: u32, offset: f64, motion: f64) -> Self {
        let row = n + 1;
        let (mut x0, mut faces) = (Vec::new(), Vec::new());
        for height in [0.0, 0.5] {
            let first = x0.len() as u32;
            for vertex in 0..row * row {
                let place = [f64::from(vertex % row), f64::from(vertex / row), height];
                x0.push(place.map(|x| offset + x + 0.2 * (random.f64() - 0.5)));
            }
            let corners = (0..n * n).map(|square| first + square / n * row + square % n);
            faces.extend(corners.flat_map(|v| [[v, v + 1, v + row], [v + 1, v + row + 1, v + row]]));
        }
        let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
        let x1 = moved(random, &x0, motion);
        Self { mesh, x0, x1 }
    }

    pub(crate) fn step(&self) -> Step<'_> {
        Step::new(&self.mesh, &self.x0, &self.x1).unwrap()
    }

    /// All pairs without a common vertex that can collide.
    pub(crate) fn pairs(&self, can_collide: &CanCollide) -> Candidates {
        let ids = |count: usize| 0..count as u32;
        let [vertices, faces, edges] = [
            self.mesh.vertex_count(),
            self.mesh.faces().len(),
            self.mesh.edges().len(),
        ]
        .map(ids);
        let vertex_face = vertices.flat_map(|vertex| faces.clone().map(move |face| [vertex, face]));
        let edge_edge = edges.clone().flat_map(|a| (0..a).map(move |b| [b, a]));
        Candidates::from_ids(
            vertex_face
                .filter(|&ids| self.is_pair::<VertexFace>(ids, can_collide))
                .collect(),
            edge_edge
                .filter(|&ids| self.is_pair::<EdgeEdge>(ids, can_collide))
                .collect(),
        )
    }

    fn is_pair<K: PairKind>(&self, ids: [u32; 2], can_collide: &CanCollide) -> bool {
        let four = K::vertices(&self.mesh, ids).unwrap();
        let (a, b) = four.split_at(K::FIRST);
        a.iter().all(|vertex| !b.contains(vertex)) && can_collide.allows(a, b)
    }
}

/// Positions that are off by a random displacement each.
pub(crate) fn moved(random: &mut Rng, x: &[Point], by: f64) -> Vec<Point> {
    x.iter()
        .map(|point| point.map(|x| x + by * (random.f64() - 0.5)))
        .collect()
}

/// The contacts of a step among some pairs, one query at a time, the earliest first.
pub(crate) fn contacts(step: Step<'_>, pairs: &Candidates) -> Vec<Contact> {
    let faces = pairs.vertex_face().iter().filter_map(|&[vertex, face]| {
        let impact = step.vertex_face(vertex, face).unwrap().impact()?;
        let pair = Pair::VertexFace { vertex, face };
        Some(Contact { pair, impact })
    });
    let edges = pairs.edge_edge().iter().filter_map(|&[a, b]| {
        let impact = step.edge_edge(a, b).unwrap().impact()?;
        let pair = Pair::EdgeEdge { a, b };
        Some(Contact { pair, impact })
    });
    let mut contacts: Vec<Contact> = faces.chain(edges).collect();
    contacts.sort_by(|a, b| {
        let times = a.impact.time.partial_cmp(&b.impact.time).unwrap();
        times.then(a.pair.cmp(&b.pair))
    });
    contacts
}

/// The result on a pool of some threads.
pub(crate) fn on_threads<T: Send>(threads: usize, task: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(task)
}

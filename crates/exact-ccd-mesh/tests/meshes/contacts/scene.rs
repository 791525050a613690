//! Random scenes and their pairs, by definition.

use exact_ccd::{DistanceBounds, EdgeEdge, Separation, VertexEdge, VertexFace, VertexVertex, with_kind};
use exact_ccd_mesh::{Candidates, Contact, MinDistance, Pair, PairKind, Point, Step, TriangleMesh};
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
        let mut coordinate = |center: f64| {
            let x = center + random.f64() - 0.5;
            if grid > 0.0 { grid * (x / grid).round() } else { x }
        };
        let (mut x0, mut x1, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for piece in 0..PIECES as u32 {
            faces.extend([[0, 1, 2], [3, 2, 1]].map(|face| face.map(|corner| 4 * piece + corner)));
            let center = [0; 3].map(|_| 2.0 * coordinate(0.0));
            let drift = [0; 3].map(|_| coordinate(0.0));
            for _ in 0..4 {
                let at = center.map(&mut coordinate);
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

    /// Two pairs of faces, two rods of three vertices and eight points, in motion, and their scale. Of the
    /// points, one is a face, and two are the ends of another. On a grid, many distances equal the distances
    /// that are drawn for queries.
    pub(crate) fn mixed(random: &mut Rng) -> (Self, f64) {
        let scale = [1.0, 1e-6][random.usize(..2)];
        let motion = [0.0, 0.2, 1.0][random.usize(..3)];
        let grid = [0.0, 0.125][random.usize(..2)];
        let mut ids: Vec<u32> = (0..22).collect();
        random.shuffle(&mut ids);
        let at = |vertex: usize| ids[vertex];
        let sheets = [[0, 1, 2], [3, 2, 1], [4, 5, 6], [7, 6, 5]];
        let flat = [[14, 14, 14], [15, 15, 16]];
        let faces = [&sheets[..], &flat].concat();
        let faces = faces.into_iter().map(|face| face.map(at)).collect();
        let rods = [[8, 9], [9, 10], [11, 12], [12, 13]].map(|edge| edge.map(at));
        let mesh = TriangleMesh::with_edges(22, faces, &rods).unwrap();
        let mut coordinate = |size: f64| {
            let x = size * (random.f64() - 0.5);
            scale * if grid > 0.0 { grid * (x / grid).round() } else { x }
        };
        let x0: Vec<Point> = (0..22).map(|_| [0; 3].map(|_| coordinate(2.0))).collect();
        let by = |x: &Point| x.map(|x| x + coordinate(motion));
        let x1 = x0.iter().map(by).collect();
        (Self { mesh, x0, x1 }, scale)
    }

    pub(crate) fn step(&self) -> Step<'_> {
        Step::new(&self.mesh, &self.x0, &self.x1).unwrap()
    }

    /// All pairs without a common vertex.
    pub(crate) fn pairs(&self) -> Candidates {
        self.pairs_among(|_| true)
    }

    /// All pairs without a common vertex among the primitives whose vertices take part. A vertex and an
    /// edge are one if no face that takes part has the edge, and no edge of the vertex is apart from it;
    /// two vertices, if neither has an edge.
    pub(crate) fn pairs_among(&self, takes_part: impl Fn(u32) -> bool) -> Candidates {
        let mesh = &self.mesh;
        let is_in = |vertices: &[u32]| vertices.iter().all(|&vertex| takes_part(vertex));
        let vertices: Vec<u32> = (0..mesh.vertex_count() as u32)
            .filter(|&v| takes_part(v))
            .collect();
        let faces: Vec<u32> = ids(mesh.faces(), &is_in);
        let edges: Vec<u32> = ids(mesh.edges(), &is_in);
        let ends = |edge: u32| mesh.edges()[edge as usize];
        let has_face = |edge: u32| {
            let contains = |face: u32| {
                let corners = mesh.faces()[face as usize];
                ends(edge).iter().all(|end| corners.contains(end))
            };
            faces.iter().any(|&face| contains(face))
        };
        let mut rods = edges.clone();
        rods.retain(|&edge| !has_face(edge));
        let mut points = vertices.clone();
        points.retain(|vertex| !edges.iter().any(|&edge| ends(edge).contains(vertex)));
        let kind = |a: &[u32], b: &[u32]| -> Vec<[u32; 2]> {
            let with = |&first: &u32| b.iter().map(move |&second| [first, second]);
            a.iter().flat_map(with).collect()
        };
        let mut with_rods: Vec<[u32; 2]> = kind(&vertices, &rods);
        with_rods.retain(|&[vertex, rod]| {
            let mut of_vertex = edges.iter().filter(|&&edge| ends(edge).contains(&vertex));
            of_vertex.all(|&edge| ends(edge).iter().any(|end| ends(rod).contains(end)))
        });

        let increasing = |mut pairs: Vec<[u32; 2]>| {
            pairs.retain(|[a, b]| a < b);
            pairs
        };
        self.apart::<VertexFace>(kind(&vertices, &faces))
            .chain(self.apart::<EdgeEdge>(increasing(kind(&edges, &edges))))
            .chain(self.apart::<VertexEdge>(with_rods))
            .chain(self.apart::<VertexVertex>(increasing(kind(&points, &points))))
            .collect()
    }

    /// The pairs without a common vertex.
    fn apart<K: PairKind>(&self, ids: Vec<[u32; 2]>) -> impl Iterator<Item = Pair> {
        ids.into_iter()
            .filter(|&ids| {
                let vertices = K::vertices(&self.mesh, ids).unwrap();
                let (a, b) = vertices.as_ref().split_at(K::FIRST);
                a.iter().all(|vertex| !b.contains(vertex))
            })
            .map(|ids| Pair::new(K::KIND, ids))
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
    contacts_within(step, pairs, &MinDistance::default())
}

/// The same for a minimum distance.
pub(crate) fn contacts_within(
    step: Step<'_>,
    pairs: &Candidates,
    min_distance: &MinDistance,
) -> Vec<Contact> {
    let contact = |pair: Pair| with_kind!(pair.kind(), K => contact::<K>(step, pair.ids(), min_distance));
    let mut contacts: Vec<Contact> = pairs.pairs().filter_map(contact).collect();
    contacts.sort_by(|a, b| {
        let times = a.impact.time.partial_cmp(&b.impact.time).unwrap();
        times.then(a.pair.cmp(&b.pair))
    });
    contacts
}

fn contact<K: PairKind>(step: Step<'_>, ids: [u32; 2], min_distance: &MinDistance) -> Option<Contact> {
    let query = step.query::<K>(ids).unwrap();
    let d = allowed::<K>(step, ids, min_distance);
    let impact = query.impact(d)?;
    let distance = if impact.touching_at_start() && !d.is_zero() {
        query.distance_at(0.0).unwrap()
    } else {
        let (lower, upper) = (d.get(), d.get());
        DistanceBounds { lower, upper }
    };
    Some(Contact {
        pair: Pair::new(K::KIND, ids),
        impact,
        distance,
    })
}

/// The pairs that are within their distance at t = 0.
pub(crate) fn touching(
    step: Step<'_>,
    pairs: &Candidates,
    min_distance: &MinDistance,
) -> impl Iterator<Item = Pair> {
    pairs.pairs().filter(move |&pair| match pair {
        Pair::VertexFace { vertex, face } => touches::<VertexFace>(step, [vertex, face], min_distance),
        Pair::EdgeEdge { a, b } => touches::<EdgeEdge>(step, [a, b], min_distance),
        Pair::VertexEdge { vertex, edge } => touches::<VertexEdge>(step, [vertex, edge], min_distance),
        Pair::VertexVertex { a, b } => touches::<VertexVertex>(step, [a, b], min_distance),
    })
}

fn touches<K: PairKind>(step: Step<'_>, ids: [u32; 2], min_distance: &MinDistance) -> bool {
    let distance = step.query::<K>(ids).unwrap().distance_at(0.0).unwrap();
    distance.upper <= outer::<K>(step, ids, min_distance).get()
}

/// The distance that a pair must not come within if it starts beyond it.
fn outer<K: PairKind>(step: Step<'_>, ids: [u32; 2], min_distance: &MinDistance) -> Separation {
    let vertices = K::vertices(step.mesh(), ids).unwrap();
    let (a, b) = vertices.as_ref().split_at(K::FIRST);
    let connects = |edge: &[u32; 2]| edge.contains(&a[0]) && b.iter().any(|end| edge.contains(end));
    if a.len() == 1 && b.len() == 2 && step.mesh().edges().iter().any(connects) {
        return Separation::default();
    }
    min_distance.separations().between(a, b)
}

/// The distance that a pair must not come within.
pub(crate) fn allowed<K: PairKind>(step: Step<'_>, ids: [u32; 2], min_distance: &MinDistance) -> Separation {
    let d = outer::<K>(step, ids, min_distance);
    match min_distance.inner() {
        Some(inner) if touches::<K>(step, ids, min_distance) && inner < d => inner,
        _ => d,
    }
}

/// The result on a pool of some threads.
pub(crate) fn on_threads<T: Send>(threads: usize, task: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(task)
}

/// The indices of the primitives that take part.
fn ids<const N: usize>(primitives: &[[u32; N]], takes_part: &impl Fn(&[u32]) -> bool) -> Vec<u32> {
    let of = (0..).zip(primitives);
    of.filter(|(_, vertices)| takes_part(*vertices))
        .map(|(id, _)| id)
        .collect()
}

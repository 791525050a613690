//! The step for every vertex, first contacts and clearances through C have the same bits as through Rust.

use core::{ptr, slice};

use exact_ccd::{CONTACT, Point, Separation, Thickness};
use exact_ccd_c::{
    Kind, Status, exact_ccd_contacts_data, exact_ccd_contacts_free, exact_ccd_detector_clearances,
    exact_ccd_detector_first_contacts, exact_ccd_detector_free, exact_ccd_detector_free_steps,
    exact_ccd_detector_new, exact_ccd_detector_set_min_distance, exact_ccd_detector_set_thickness,
    exact_ccd_mesh_free, exact_ccd_mesh_new, exact_ccd_pairs_data, exact_ccd_pairs_free,
};
use exact_ccd_mesh::{Detector, FreeStepOptions, FreeSteps, MinDistance, Pair, TriangleMesh};

const VERTICES: usize = 60;

/// Triangles, a rod and loose vertices.
fn connectivity() -> (Vec<[u32; 3]>, Vec<[u32; 2]>) {
    let faces = (0..16).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    (faces, vec![[48, 49], [49, 50], [51, 52]])
}

/// The distance at which primitives touch.
enum Distance {
    Uniform(f64),
    OfVertices(Vec<f64>),
}

#[test]
fn the_bits_are_those_of_rust() {
    let mut random = Random(1);
    let (mut in_contact, mut blocked, mut repeated) = (0, 0, 0);
    for round in 0..60 {
        let x0: Vec<Point> = (0..VERTICES)
            .map(|_| [0; 3].map(|_| 4.0 * random.unit()))
            .collect();
        let x1: Vec<Point> = x0.iter().map(|x| x.map(|x| x + random.unit())).collect();
        let distance = match round % 3 {
            0 => Distance::Uniform(0.0),
            1 => Distance::Uniform(0.01),
            _ => Distance::OfVertices((0..VERTICES).map(|_| 0.01 * random.unit()).collect()),
        };
        let pinned: &[u32] = if round % 2 == 0 { &[] } else { &[0, 1, 2, 48, 55] };
        let keep = [0.9, 0.5, 1.0][round / 2 % 3];
        let by_rust = through_rust(&x0, &x1, pinned, keep, &distance);
        let by_c = through_c(&x0, &x1, pinned, keep, &distance);
        assert_eq!(bits(&by_c), bits(&by_rust), "round {round}");
        let cut_off = [0.0, 0.1, 1.0][round % 3];
        let (of_rust, of_c) = (
            vertices_through_rust(&x0, &x1, cut_off),
            vertices_through_c(&x0, &x1, cut_off),
        );
        assert_eq!(of_c, of_rust, "round {round}");
        in_contact += usize::from(by_rust.sizes.iter().any(|&size| size < 1.0));
        blocked += by_rust.blocked.len();
        repeated += usize::from(by_rust.rounds > 2);
    }
    // The test has steps with contact, with blocked pairs and with several rounds.
    assert!(
        in_contact > 40 && blocked > 10 && repeated > 20,
        "{in_contact} {blocked} {repeated}"
    );
}

fn bits(steps: &FreeSteps) -> (Vec<u64>, Vec<[u64; 3]>, &[Pair], usize) {
    let sizes = steps.sizes.iter().map(|size| size.to_bits()).collect();
    let positions = steps.positions.iter().map(|x| x.map(f64::to_bits)).collect();
    (sizes, positions, &steps.blocked, steps.rounds)
}

fn through_rust(x0: &[Point], x1: &[Point], pinned: &[u32], keep: f64, distance: &Distance) -> FreeSteps {
    let (faces, edges) = connectivity();
    let mesh = TriangleMesh::with_edges(VERTICES, faces, &edges).expect("the vertices exist");
    let min_distance = match distance {
        Distance::Uniform(d) => MinDistance::uniform(Separation::new(*d).expect("a distance")),
        Distance::OfVertices(values) => MinDistance::thickness(Thickness::new(values).expect("distances")),
    };
    let options = FreeStepOptions::default().with_keep(keep);
    Detector::new(mesh)
        .free_steps(x0, x1, pinned, &options.with_min_distance(min_distance))
        .expect("a step of the mesh")
}

/// A detector of the mesh, which outlives the handle of the mesh.
fn new_detector() -> *mut exact_ccd_c::Detector {
    let (faces, edges) = connectivity();
    let (mut mesh, mut detector) = (ptr::null_mut(), ptr::null_mut());
    // SAFETY: the arrays have the lengths that are passed on, and the handle is freed once.
    unsafe {
        let statuses = [
            exact_ccd_mesh_new(
                VERTICES,
                faces.as_ptr().cast(),
                faces.len(),
                edges.as_ptr().cast(),
                edges.len(),
                &raw mut mesh,
            ),
            exact_ccd_detector_new(mesh, &raw mut detector),
        ];
        assert_eq!(statuses, [Status::Ok; 2]);
        exact_ccd_mesh_free(mesh);
    }
    detector
}

fn through_c(x0: &[Point], x1: &[Point], pinned: &[u32], keep: f64, distance: &Distance) -> FreeSteps {
    let detector = new_detector();
    let mut list = ptr::null_mut();
    let (mut data, mut count, mut rounds) = (ptr::null(), 0, 0);
    let mut sizes = vec![0.0; VERTICES];
    let mut positions = vec![[0.0; 3]; VERTICES];
    // SAFETY: the arrays have the lengths that are passed on, and handles are freed once.
    unsafe {
        let statuses = [
            match distance {
                Distance::Uniform(d) => exact_ccd_detector_set_min_distance(detector, *d),
                Distance::OfVertices(values) => {
                    exact_ccd_detector_set_thickness(detector, values.as_ptr(), VERTICES)
                }
            },
            exact_ccd_detector_free_steps(
                detector,
                x0.as_ptr().cast(),
                x1.as_ptr().cast(),
                VERTICES,
                pinned.as_ptr(),
                pinned.len(),
                keep,
                sizes.as_mut_ptr(),
                positions.as_mut_ptr().cast(),
                &raw mut rounds,
                &raw mut list,
            ),
            exact_ccd_pairs_data(list, &raw mut data, &raw mut count),
        ];
        assert_eq!(statuses, [Status::Ok; 3]);
        let pairs = slice::from_raw_parts(data, count);
        let blocked = pairs
            .iter()
            .map(|pair| of_kind(pair.kind, pair.first, pair.second));
        let blocked = blocked.collect();
        exact_ccd_pairs_free(list);
        exact_ccd_detector_free(detector);
        FreeSteps {
            sizes,
            positions,
            blocked,
            rounds,
        }
    }
}

/// Contacts, the first of each vertex with its time, and clearances, in bits.
type OfVertices = (usize, Vec<usize>, Vec<u64>, Vec<u64>);

fn vertices_through_rust(x0: &[Point], x1: &[Point], cut_off: f64) -> OfVertices {
    let (faces, edges) = connectivity();
    let mesh = TriangleMesh::with_edges(VERTICES, faces, &edges).expect("the vertices exist");
    let mut detector = Detector::new(mesh);
    let first = detector
        .first_contacts(x0, x1, CONTACT)
        .expect("a step of the mesh");
    let cut_off = Separation::new(cut_off).expect("a distance");
    let clearances = detector.clearances(x0, cut_off).expect("positions of the mesh");
    let count = first.contacts.len();
    let of_vertices = first.of_vertices.iter().map(|first| first.unwrap_or(count));
    (
        count,
        of_vertices.collect(),
        first.times().into_iter().map(f64::to_bits).collect(),
        clearances.into_iter().map(f64::to_bits).collect(),
    )
}

fn vertices_through_c(x0: &[Point], x1: &[Point], cut_off: f64) -> OfVertices {
    let detector = new_detector();
    let mut list = ptr::null_mut();
    let (mut data, mut count) = (ptr::null(), 0);
    let mut first = vec![0; VERTICES];
    let (mut times, mut clearances) = (vec![0.0; VERTICES], vec![0.0; VERTICES]);
    // SAFETY: the arrays have the lengths that are passed on, and handles are freed once.
    unsafe {
        let statuses = [
            exact_ccd_detector_first_contacts(
                detector,
                x0.as_ptr().cast(),
                x1.as_ptr().cast(),
                VERTICES,
                1.0,
                first.as_mut_ptr(),
                times.as_mut_ptr(),
                &raw mut list,
            ),
            exact_ccd_contacts_data(list, &raw mut data, &raw mut count),
            exact_ccd_detector_clearances(
                detector,
                x0.as_ptr().cast(),
                VERTICES,
                cut_off,
                clearances.as_mut_ptr(),
            ),
        ];
        assert_eq!(statuses, [Status::Ok; 3]);
        exact_ccd_contacts_free(list);
        exact_ccd_detector_free(detector);
    }
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect();
    (count, first, bits(times), bits(clearances))
}

fn of_kind(kind: u32, first: u32, second: u32) -> Pair {
    const VERTEX_FACE: u32 = Kind::VertexFace as u32;
    const EDGE_EDGE: u32 = Kind::EdgeEdge as u32;
    const VERTEX_EDGE: u32 = Kind::VertexEdge as u32;
    const VERTEX_VERTEX: u32 = Kind::VertexVertex as u32;
    match kind {
        VERTEX_FACE => Pair::VertexFace {
            vertex: first,
            face: second,
        },
        EDGE_EDGE => Pair::EdgeEdge { a: first, b: second },
        VERTEX_EDGE => Pair::VertexEdge {
            vertex: first,
            edge: second,
        },
        VERTEX_VERTEX => Pair::VertexVertex { a: first, b: second },
        other => panic!("kind {other} is no pair"),
    }
}

/// Marsaglia's xorshift generator.
struct Random(u64);

impl Random {
    /// A number in [0, 1).
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

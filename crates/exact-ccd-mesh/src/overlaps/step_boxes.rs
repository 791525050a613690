//! The boxes of a mesh's primitives during a step.

use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd::Point;
use rayon::prelude::*;

use super::margin::Margin;
use super::path::{between, until};
use super::primitives::Primitives;
use crate::broad_phase::{BoxPairs, Boxes, MovingBox, PairSink, Units};
use crate::mesh::TriangleMesh;
use crate::pairs::{PrimitiveSet, Searched};
use crate::steps::Step;

/// The boxes of the primitives in successive steps of one mesh: boxes that move (T = 2), or boxes at rest,
/// each around the whole path of a primitive, relative to a vertex (T = 1).
///
/// A box contains its primitive until the time for which it is placed, and in a motion to rounded positions
/// before that (`path.rs`).
#[derive(Clone, Debug)]
pub(crate) struct StepBoxes<const T: usize> {
    /// The boxes of each [`PrimitiveSet`].
    sets: [Boxes<T>; PrimitiveSet::COUNT],
    /// The primitives, in the order of their boxes.
    primitives: Primitives,
    /// The boxes of the vertices, in the order of the mesh.
    moving: Vec<MovingBox<T>>,
    /// The amounts by which boxes are larger on each side.
    margin: Margin,
    /// The amounts for each vertex, if they differ.
    margins: Vec<f64>,
    /// True if coordinates at the end are relative to a vertex's place at the end; else, to its place at the
    /// start.
    follows: bool,
    /// Coordinates are relative to the places of this vertex, or to its place at the start, and have a
    /// scale for the size of the mesh, when all boxes were placed last: so single precision is fine,
    /// however far away all vertices are, and however large the mesh is.
    units: Units<2>,
    /// The time until which the boxes of `moving` hold, or NaN.
    time: f64,
    /// True if the boxes belong to the current step.
    has_begun: bool,
}

impl<const T: usize> Default for StepBoxes<T> {
    /// No boxes yet.
    fn default() -> Self {
        Self {
            sets: [(); PrimitiveSet::COUNT].map(|()| Boxes::of(Arc::default())),
            primitives: Primitives::default(),
            moving: Vec::new(),
            margin: Margin::default(),
            margins: Vec::new(),
            follows: true,
            units: Units::relative_to([[0.0; 3]; 2]),
            time: f64::NAN,
            has_begun: false,
        }
    }
}

impl StepBoxes<1> {
    /// Boxes around the whole path, not relative to a vertex that moves.
    pub(crate) fn around_paths() -> Self {
        Self {
            follows: false,
            ..Self::default()
        }
    }
}

impl<const T: usize> StepBoxes<T> {
    /// Ends the current step. The next one is of the same mesh, with the same predicate, and with this
    /// margin.
    pub(crate) fn end(&mut self, margin: &Margin) {
        self.has_begun = false;
        if self.margin != *margin {
            self.margin.clone_from(margin);
            self.margins.clear();
        }
    }

    /// Takes the primitives of a new step, if it has not begun; places no boxes.
    fn begin(&mut self, step: &Step<'_>, primitives: &Primitives) {
        if self.has_begun {
            return;
        }
        (self.has_begun, self.time) = (true, f64::NAN);
        self.primitives.clone_from(primitives);
        for (set, boxes) in PrimitiveSet::ALL.into_iter().zip(&mut self.sets) {
            if !Arc::ptr_eq(boxes.members(), primitives.get(set)) {
                *boxes = Boxes::of(primitives.get(set).clone());
            }
        }
        if self.margin.uniform().is_none() && self.margins.len() != step.mesh().vertex_count() {
            self.margins = self.margin.largest(step.mesh());
        }
    }

    pub(crate) fn get(&self, set: PrimitiveSet) -> &Boxes<T> {
        &self.sets[set as usize]
    }

    /// Places the boxes of all primitives of a kind of pairs for the step until `time`.
    pub(crate) fn place<K: Searched>(&mut self, step: &Step<'_>, primitives: &Primitives, time: f64) {
        self.place_sets(step, primitives, time, K::SETS);
    }

    /// Places the boxes of all primitives of two sets for the step until `time`.
    pub(crate) fn place_sets(
        &mut self,
        step: &Step<'_>,
        primitives: &Primitives,
        time: f64,
        sets: [PrimitiveSet; 2],
    ) {
        self.begin(step, primitives);
        self.move_vertices(step, time);
        self.place_chosen(step.mesh(), sets, |_| true);
    }

    /// Places the boxes of the primitives of two sets that have a chosen vertex.
    fn place_chosen(
        &mut self,
        mesh: &TriangleMesh,
        [first, second]: [PrimitiveSet; 2],
        is_chosen: impl Fn(u32) -> bool + Sync,
    ) {
        self.place_some(mesh, first, &is_chosen);
        if second != first {
            self.place_some(mesh, second, &is_chosen);
        }
    }

    /// Places the boxes of the primitives of a set that have a chosen vertex.
    fn place_some(&mut self, mesh: &TriangleMesh, set: PrimitiveSet, is_chosen: impl Fn(u32) -> bool + Sync) {
        let (moving, boxes) = (&self.moving, &mut self.sets[set as usize]);
        let any = |vertices: &[u32]| vertices.iter().any(|&vertex| is_chosen(vertex));
        match set {
            PrimitiveSet::Vertices | PrimitiveSet::LooseVertices | PrimitiveSet::Ends => {
                boxes.replace(&is_chosen, |id| moving[id as usize]);
            }
            PrimitiveSet::Faces => {
                let faces = mesh.faces();
                boxes.replace(
                    |id| any(&faces[id as usize]),
                    |id| around(moving, &faces[id as usize]),
                );
            }
            PrimitiveSet::Edges | PrimitiveSet::LooseEdges => {
                let edges = mesh.edges();
                boxes.replace(
                    |id| any(&edges[id as usize]),
                    |id| around(moving, &edges[id as usize]),
                );
            }
        }
    }

    /// Places the boxes of all primitives of a kind of pairs in a step that differs from the one before in
    /// the ends of the marked vertices, which [`move_marked`](Self::move_marked) has taken.
    pub(crate) fn place_marked<K: Searched>(&mut self, mesh: &TriangleMesh, is_marked: &[bool]) {
        self.place_chosen(mesh, K::SETS, |vertex| is_marked[vertex as usize]);
    }

    /// Takes the ends of marked vertices. Returns false if the boxes hold for a part of the step only.
    pub(crate) fn move_marked(&mut self, step: &Step<'_>, is_marked: &[bool]) -> bool {
        if !self.has_begun || self.time != 1.0 {
            return false;
        }
        let [x0, x1] = step.positions();
        for vertex in (0..is_marked.len()).filter(|&vertex| is_marked[vertex]) {
            let margin = self.margin.uniform().unwrap_or_else(|| self.margins[vertex]);
            let places = until(1.0, x0[vertex], x1[vertex]).map(|aabb| aabb.inflated(margin));
            self.moving[vertex] = MovingBox::of_path(&places, &self.units);
        }
        true
    }

    /// Finds the pairs of a kind that have a marked vertex and boxes that meet, in any order. A pair of two
    /// marked primitives is found twice, and passed on once. Of two primitives of one set, the smaller index
    /// comes first.
    pub(crate) fn pairs_of_marked<K: Searched>(
        &self,
        mesh: &TriangleMesh,
        broad_phase: &dyn BoxPairs<T>,
        marked: &[bool],
        sink: &PairSink<'_>,
    ) -> ControlFlow<()> {
        let uncovered = self.uncovered::<K>(mesh, sink);
        let [first, second] = K::SETS;
        let is_marked = |vertex: &u32| marked.get(*vertex as usize).is_some_and(|&is| is);
        let any = |vertices: &[u32]| vertices.iter().any(is_marked);
        // Another broad phase may pass on other pairs, also of indices that do not exist.
        let is_marked = |set: PrimitiveSet, id: u32| match set {
            PrimitiveSet::Vertices | PrimitiveSet::LooseVertices | PrimitiveSet::Ends => any(&[id]),
            PrimitiveSet::Faces => mesh.faces().get(id as usize).is_some_and(|face| any(face)),
            PrimitiveSet::Edges | PrimitiveSet::LooseEdges => {
                mesh.edges().get(id as usize).is_some_and(|edge| any(edge))
            }
        };
        let only = |set: PrimitiveSet| self.get(set).only(|id| is_marked(set, id));
        if first == second {
            return broad_phase.between(&only(first), self.get(first), &|pairs| {
                let once = pairs.iter().filter(|&&[a, b]| a < b || !is_marked(first, b));
                let sorted = once.map(|&[a, b]| [a.min(b), a.max(b)]);
                uncovered(&sorted.collect::<Vec<_>>())
            });
        }
        broad_phase.between(&only(first), self.get(second), &uncovered)?;
        broad_phase.between(self.get(first), &only(second), &|pairs| {
            let once = pairs.iter().copied().filter(|&[a, _]| !is_marked(first, a));
            uncovered(&once.collect::<Vec<_>>())
        })
    }

    /// Passes on the pairs of a kind that no pair of edges covers.
    fn uncovered<'a, K: Searched>(
        &'a self,
        mesh: &'a TriangleMesh,
        sink: &'a PairSink<'a>,
    ) -> impl Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync + 'a {
        let ends = self.primitives.other_ends();
        move |pairs: &[[u32; 2]]| {
            let Some(is_covered) = K::IS_COVERED else {
                return sink(pairs);
            };
            let is_left =
                |&ids: &[u32; 2]| K::vertices(mesh, ids).is_some_and(|vertices| !is_covered(ends, &vertices));
            let pairs: Vec<_> = pairs.iter().copied().filter(is_left).collect();
            sink(&pairs)
        }
    }

    /// Finds the pairs of a kind whose boxes meet; of a sample of the first primitives, if there is a stride.
    /// Of two primitives of one set, the smaller index comes first.
    pub(crate) fn pairs<K: Searched>(
        &self,
        mesh: &TriangleMesh,
        broad_phase: &dyn BoxPairs<T>,
        sample: Option<usize>,
        sink: &PairSink<'_>,
    ) -> ControlFlow<()> {
        let sink = &self.uncovered::<K>(mesh, sink);
        let [first, second] = K::SETS;
        match sample {
            Some(stride) if first == second => {
                broad_phase.between(&self.get(first).sample(stride), self.get(second), &|pairs| {
                    let sorted = pairs.iter().map(|&[a, b]| [a.min(b), a.max(b)]);
                    sink(&sorted.collect::<Vec<_>>())
                })
            }
            Some(stride) => broad_phase.between(&self.get(first).sample(stride), self.get(second), sink),
            None if first == second => broad_phase.within(self.get(first), sink),
            None => broad_phase.between(self.get(first), self.get(second), sink),
        }
    }

    fn move_vertices(&mut self, step: &Step<'_>, time: f64) {
        if self.time == time {
            return;
        }
        self.time = time;
        let [x0, x1] = step.positions();
        let origins = self.primitives.origin().map_or([[0.0; 3]; 2], |vertex| {
            let [start, end] = [x0, x1].map(|x| x[vertex as usize]);
            let place = between(time, start, end);
            [start, if self.follows { place } else { start }]
        });
        self.units = Units::relative_to(origins).for_size(self.primitives.size());
        let units = &self.units;
        let ends = x0.par_iter().zip(x1).with_min_len(512);
        let moving = &mut self.moving;
        let inflated = |margin: f64, x0: Point, x1: Point| {
            let places = until(time, x0, x1).map(|aabb| aabb.inflated(margin));
            MovingBox::of_path(&places, units)
        };
        // Copies of the loop: the usual one does not inflate.
        match self.margin.uniform() {
            Some(0.0) => ends
                .map(|(&x0, &x1)| MovingBox::of_path(&until(time, x0, x1), units))
                .collect_into_vec(moving),
            Some(margin) => ends
                .map(|(&x0, &x1)| inflated(margin, x0, x1))
                .collect_into_vec(moving),
            None => ends
                .zip(&self.margins)
                .map(|((&x0, &x1), &margin)| inflated(margin, x0, x1))
                .collect_into_vec(moving),
        }
    }
}

#[inline(always)]
fn around<const T: usize, const N: usize>(boxes: &[MovingBox<T>], vertices: &[u32; N]) -> MovingBox<T> {
    vertices.iter().fold(MovingBox::EMPTY, |all, &vertex| {
        all.union(&boxes[vertex as usize])
    })
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use exact_ccd::{EdgeEdge, Thickness, VertexEdge, VertexFace, VertexVertex};
    use fastrand::Rng;

    use super::*;
    use crate::broad_phase::{Aabb, Bvh, PairCollector};
    use crate::pairs::{CanCollide, MinDistance};

    /// Faces and loose edges, near each other.
    fn mesh(rng: &mut Rng) -> TriangleMesh {
        let mut any = |first: u32, count: u32| first + rng.u32(..count);
        let faces = (0..20)
            .map(|i| [3 * (i % 10), any(30, 10), any(40, 10)])
            .collect();
        let edges: Vec<[u32; 2]> = (0..10).map(|_| [any(50, 5), any(55, 5)]).collect();
        TriangleMesh::with_edges(64, faces, &edges).expect("the vertices exist")
    }

    fn points(rng: &mut Rng) -> Vec<Point> {
        (0..64).map(|_| [0, 1, 2].map(|_| 4.0 * rng.f64())).collect()
    }

    /// The pairs that are passed on; a pair that is passed on twice is in the list twice.
    fn found(search: impl Fn(&PairSink<'_>) -> ControlFlow<()>) -> Vec<[u32; 2]> {
        let collector = PairCollector::default();
        let _ = search(&|pairs| collector.add(pairs.iter().copied()));
        collector.into_sorted()
    }

    #[test]
    fn pairs_of_marked_vertices_are_passed_on_once() {
        fn assert_once<K: Searched>(boxes: &StepBoxes<2>, mesh: &TriangleMesh, marked: &[bool]) -> usize {
            let mut expected = found(|sink| boxes.pairs::<K>(mesh, &Bvh, None, sink));
            expected.retain(|&ids| {
                let vertices = K::vertices(mesh, ids).expect("the mesh has the pair");
                vertices.as_ref().iter().any(|&vertex| marked[vertex as usize])
            });
            let pairs = found(|sink| boxes.pairs_of_marked::<K>(mesh, &Bvh, marked, sink));
            assert_eq!(pairs, expected);
            pairs.len()
        }
        let mut rng = Rng::with_seed(0);
        let mut counts = [0; 4];
        for _ in 0..100 {
            let (mesh, x0, x1) = (mesh(&mut rng), points(&mut rng), points(&mut rng));
            let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            let mut primitives = Primitives::default();
            primitives.begin(&step, &CanCollide::all());
            let mut boxes = StepBoxes::<2>::default();
            boxes.place::<VertexFace>(&step, &primitives, 1.0);
            boxes.place::<EdgeEdge>(&step, &primitives, 1.0);
            boxes.place::<VertexEdge>(&step, &primitives, 1.0);
            boxes.place::<VertexVertex>(&step, &primitives, 1.0);
            let marked: Vec<bool> = (0..64).map(|_| rng.u8(..4) == 0).collect();
            counts[0] += assert_once::<VertexFace>(&boxes, &mesh, &marked);
            counts[1] += assert_once::<EdgeEdge>(&boxes, &mesh, &marked);
            counts[2] += assert_once::<VertexEdge>(&boxes, &mesh, &marked);
            counts[3] += assert_once::<VertexVertex>(&boxes, &mesh, &marked);
        }
        assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
    }

    /// The sides of a box are the least and largest coordinates of its vertices, relative to the origins, off
    /// by the margin and by the roundings to single precision, of numbers below 16.
    #[test]
    fn boxes_are_around_their_primitives_with_their_margins() {
        fn assert_around<const T: usize>(mut boxes: StepBoxes<T>, far: f64, rng: &mut Rng) {
            let mesh = mesh(rng);
            let far_away =
                |x: Vec<Point>| -> Vec<Point> { x.into_iter().map(|point| point.map(|x| x + far)).collect() };
            let (x0, x1) = (far_away(points(rng)), points(rng));
            let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            let mut primitives = Primitives::default();
            primitives.begin(&step, &CanCollide::all());
            let (time, margin) = (rng.f64(), rng.f64());
            boxes.end(&Margin::new(Default::default(), margin));
            boxes.place::<VertexFace>(&step, &primitives, time);
            boxes.place::<EdgeEdge>(&step, &primitives, time);
            let at = |vertex: u32, end: usize| -> Point {
                let vertex = vertex as usize;
                let place = [x0[vertex], between(time, x0[vertex], x1[vertex])][end];
                let [x, y, z, _] = boxes.units.of(end, place);
                [x, y, z]
            };
            let vertices = |set: PrimitiveSet, id: u32| match set {
                PrimitiveSet::Faces => mesh.faces()[id as usize].to_vec(),
                PrimitiveSet::Edges => mesh.edges()[id as usize].to_vec(),
                _ => vec![id],
            };
            for set in [PrimitiveSet::Vertices, PrimitiveSet::Faces, PrimitiveSet::Edges] {
                let mut count = 0;
                for (id, places) in boxes.get(set).iter() {
                    let of_ends = [0, 1].map(|end| vertices(set, id).into_iter().map(move |v| (v, end)));
                    let mut ends = of_ends.map(|places| places.map(|(v, end)| at(v, end)).collect::<Aabb>());
                    if T == 1 {
                        ends[0] = ends[0].union(&ends[1]);
                    }
                    for (place, tight) in places.iter().zip(ends) {
                        for axis in 0..3 {
                            let gaps = [
                                tight.lower[axis] - place.lower[axis],
                                place.upper[axis] - tight.upper[axis],
                            ];
                            let slack = gaps.map(|gap| gap - margin);
                            assert!(slack.iter().all(|slack| slack.abs() < 4e-6), "{slack:?}");
                        }
                    }
                    count += 1;
                }
                assert!(count > 10, "{count}");
            }
        }
        let mut rng = Rng::with_seed(0);
        for _ in 0..50 {
            assert_around(StepBoxes::<2>::default(), 0.0, &mut rng);
            assert_around(StepBoxes::<2>::default(), 1e6, &mut rng);
            assert_around(StepBoxes::<1>::around_paths(), 0.0, &mut rng);
            assert_around(StepBoxes::<1>::default(), 0.0, &mut rng);
        }
    }

    /// A step that differs in the ends of marked vertices has the boxes of a step from the beginning.
    #[test]
    fn boxes_of_marked_vertices_are_placed_anew() {
        fn place_all<const T: usize>(
            boxes: &mut StepBoxes<T>,
            step: &Step<'_>,
            primitives: &Primitives,
            time: f64,
        ) {
            boxes.place::<VertexFace>(step, primitives, time);
            boxes.place::<EdgeEdge>(step, primitives, time);
            boxes.place::<VertexEdge>(step, primitives, time);
        }
        fn assert_anew<const T: usize>(mut boxes: StepBoxes<T>, margin: &Margin, rng: &mut Rng) {
            let (mesh, x0, x1, others) = (mesh(rng), points(rng), points(rng), points(rng));
            let before = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            let mut primitives = Primitives::default();
            primitives.begin(&before, &CanCollide::all());
            let mut marked: Vec<bool> = (0..64).map(|_| rng.u8(..4) == 0).collect();
            // Coordinates are relative to this vertex.
            marked[primitives.origin().expect("there are vertices") as usize] = false;
            let x2: Vec<Point> = (0..64)
                .map(|vertex| {
                    if marked[vertex] {
                        others[vertex]
                    } else {
                        x1[vertex]
                    }
                })
                .collect();
            let after = Step::new(&mesh, &x0, &x2).expect("all positions are finite");
            boxes.end(margin);
            let mut expected = boxes.clone();
            place_all(&mut expected, &after, &primitives, 1.0);

            // Boxes before any step, in a part of a step, and after a step has ended.
            assert!(!boxes.move_marked(&after, &marked));
            place_all(&mut boxes, &before, &primitives, 0.5);
            assert!(!boxes.move_marked(&after, &marked));
            place_all(&mut boxes, &before, &primitives, 1.0);
            let mut ended = boxes.clone();
            ended.end(margin);
            assert!(!ended.move_marked(&after, &marked));

            assert!(boxes.move_marked(&after, &marked));
            boxes.place_marked::<VertexFace>(&mesh, &marked);
            boxes.place_marked::<EdgeEdge>(&mesh, &marked);
            boxes.place_marked::<VertexEdge>(&mesh, &marked);
            for set in PrimitiveSet::ALL {
                let of = |boxes: &StepBoxes<T>| boxes.get(set).iter().collect::<Vec<_>>();
                assert_eq!(of(&boxes), of(&expected), "{set:?}");
            }
        }
        let mut rng = Rng::with_seed(0);
        for _ in 0..20 {
            let thicknesses: Vec<f64> = (0..64).map(|_| rng.f64()).collect();
            let thickness = Thickness::new(&thicknesses).expect("none is negative");
            for min_distance in [MinDistance::default(), MinDistance::thickness(thickness)] {
                let margin = Margin::new(min_distance, 0.125);
                assert_anew(StepBoxes::<2>::default(), &margin, &mut rng);
                assert_anew(StepBoxes::<1>::default(), &margin, &mut rng);
                assert_anew(StepBoxes::<1>::around_paths(), &margin, &mut rng);
            }
        }
    }
}

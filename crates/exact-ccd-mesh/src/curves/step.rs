//! One step of a mesh whose vertices move on Bézier curves.

use exact_ccd::motion::{Bezier, CurvedQuery};
use exact_ccd::{
    ContactTime, DistanceBounds, Kind, Options, Point, Query, Separation, TimeOutOfStep, with_kind,
};

use super::error::{CurvesError, MOST};
use crate::broad_phase::{Bvh, check_primitive_count};
use crate::mesh::{TriangleMesh, check_positions};
use crate::overlaps::{BoxKind, CandidateOptions};
use crate::pairs::{CanCollide, Pair, PairKind};
use crate::search::{Candidates, Contact};
use crate::steps::Step;

/// A mesh whose vertices move on Bézier curves, and the distance at which primitives touch.
pub(super) struct CurvedStep<'a> {
    mesh: &'a TriangleMesh,
    /// The control points of the vertices: all sets have one position for each.
    control: &'a [&'a [Point]],
    pub(super) options: Options,
}

impl<'a> CurvedStep<'a> {
    pub(super) fn new(
        mesh: &'a TriangleMesh,
        control: &'a [&'a [Point]],
        options: Options,
    ) -> Result<Self, CurvesError> {
        TimeOutOfStep::check(options.until)?;
        let count = control.len();
        if !(2..=MOST).contains(&count) {
            return Err(CurvesError::Degree { count });
        }
        for count in [mesh.vertex_count(), mesh.edges().len(), mesh.faces().len()] {
            check_primitive_count(count)?;
        }
        for (control, positions) in control.iter().enumerate() {
            let refused = |error| CurvesError::Positions { control, error };
            check_positions(mesh.vertex_count(), positions).map_err(refused)?;
        }
        Ok(Self {
            mesh,
            control,
            options,
        })
    }

    /// The pairs whose boxes come within the distance.
    ///
    /// A curve lies in the hull of its control points, and so in their box. Its least and greatest corners
    /// are the ends of a straight path in the same box, so that the boxes around the paths of that step are
    /// the boxes of the curves.
    pub(super) fn candidates(&self, can_collide: &CanCollide) -> Candidates {
        let corner = |choose: fn(f64, f64) -> f64| -> Vec<Point> {
            let vertices = 0..self.mesh.vertex_count();
            let of_vertex = |vertex: usize| {
                let points = self.control.iter().map(|set| set[vertex]);
                let both = |a: Point, b: Point| [0, 1, 2].map(|axis: usize| choose(a[axis], b[axis]));
                points.reduce(both).unwrap_or_default()
            };
            vertices.map(of_vertex).collect()
        };
        let (least, greatest) = (corner(f64::min), corner(f64::max));
        let options = CandidateOptions::default()
            .with_distance(self.options.separation.get())
            .with_boxes(BoxKind::Swept)
            .with_can_collide(can_collide.clone());
        let step = Step::new(self.mesh, &least, &greatest).ok();
        let candidates = step.and_then(|step| Candidates::with_options(step, &Bvh, &options).ok());
        // Not reached: all positions were checked, and a separation is not negative.
        candidates.unwrap_or_default()
    }

    pub(super) fn collides(&self, pair: Pair) -> bool {
        with_kind!(pair.kind(), K => {
            let query = self.query::<K>(pair);
            query.is_some_and(|(query, d)| query.collides(self.options(d, self.options.until)))
        })
    }

    /// The first time until which a pair touches.
    pub(super) fn first_time(&self, pair: Pair, until: f64) -> Option<ContactTime> {
        with_kind!(pair.kind(), K => {
            let (query, d) = self.query::<K>(pair)?;
            query.first_time(self.options(d, until))
        })
    }

    /// The contact of a pair, if it touches.
    pub(super) fn contact(&self, pair: Pair) -> Option<Contact> {
        with_kind!(pair.kind(), K => {
            let (query, d) = self.query::<K>(pair)?;
            let impact = query.impact(self.options(d, self.options.until))?;
            let distance = if impact.time.is_start() {
                let start = self.points::<K>(pair, 0)?;
                Query::<K>::new(start, start).ok()?.distance_at(0.0).ok()?
            } else {
                DistanceBounds { lower: d.get(), upper: d.get() }
            };
            Some(Contact { pair, impact, distance })
        })
    }

    fn options(&self, separation: Separation, until: f64) -> Options {
        Options::within(separation).until(until)
    }

    /// The query of a pair of the mesh, and the distance at which it touches: 0 for connected primitives, as
    /// [`Pair`] says.
    fn query<K: PairKind>(&self, pair: Pair) -> Option<(CurvedQuery<K>, Separation)> {
        let sets = 0..self.control.len();
        let control: Option<Vec<_>> = sets.map(|set| self.points::<K>(pair, set)).collect();
        let vertices = K::vertices(self.mesh, pair.ids())?;
        let d = if K::are_connected(self.mesh, &vertices) {
            Separation::ZERO
        } else {
            self.options.separation
        };
        Some((Bezier::new(&control?).ok()?.into(), d))
    }

    /// The control points of a pair in a set.
    fn points<K: PairKind>(&self, pair: Pair, set: usize) -> Option<<K as Kind>::Points> {
        let mut points = K::Points::default();
        let vertices = K::vertices(self.mesh, pair.ids())?;
        for (point, &vertex) in points.as_mut().iter_mut().zip(vertices.as_ref()) {
            *point = self.control[set][vertex as usize];
        }
        Some(points)
    }
}

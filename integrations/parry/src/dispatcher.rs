//! The dispatcher for one precision of parry: the module above names the crate and its numbers.

use exact_ccd::{Point, Separation};
use exact_ccd_curved::RigidMotion;

use super::Real;
use super::parry::math::{Pose, Vector};
use super::parry::query::details::NormalConstraints;
use super::parry::query::{
    ClosestPoints, Contact, ContactManifold, ContactManifoldsWorkspace, NonlinearRigidMotion,
    PersistentQueryDispatcher, QueryDispatcher, ShapeCastHit, ShapeCastOptions, ShapeCastStatus,
    ShapeDistance, ShapeIntersection, Unsupported,
};
use super::parry::shape::{Shape, TypedShape};
use crate::motion::Hit;
use crate::surfaces::{Failure, Surface, Surfaces};

/// Exact queries of surfaces. The [documentation of the crate](crate) lists the queries that it answers.
#[derive(Clone, Copy, Debug, Default)]
pub struct ExactDispatcher;

/// The surface of a shape at a pose, if the shape is one.
fn surface(shape: &dyn Shape, pose: &Pose) -> Result<Surface, Unsupported> {
    let point = |&vertex: &Vector| exactly(*pose * vertex);
    let (vertices, faces, edges): (&[Vector], &[[u32; 3]], &[[u32; 2]]) = match shape.as_typed_shape() {
        TypedShape::TriMesh(mesh) => (mesh.vertices(), mesh.indices(), &[]),
        TypedShape::Triangle(triangle) => (triangle.vertices(), &[[0, 1, 2]], &[]),
        TypedShape::Polyline(line) => (line.vertices(), &[], line.indices()),
        TypedShape::Segment(segment) => (&[segment.a, segment.b], &[], &[[0, 1]]),
        _ => return Err(Unsupported),
    };
    Ok(Surface {
        points: vertices.iter().map(point).collect(),
        faces: faces.to_vec(),
        edges: edges.to_vec(),
    })
}

/// Two shapes at their poses.
fn surfaces(poses: [&Pose; 2], shapes: [&dyn Shape; 2]) -> Result<Surfaces, Unsupported> {
    let [first, second] = [0, 1].map(|i| surface(shapes[i], poses[i]));
    supported(Surfaces::new(first?, second?))
}

/// Numbers that are not finite, and indices that do not exist, are for the next dispatcher.
fn supported<T>(answer: Result<T, Failure>) -> Result<T, Unsupported> {
    answer.map_err(|_| Unsupported)
}

fn exactly(vector: Vector) -> Point {
    [vector.x, vector.y, vector.z].map(f64::from)
}

fn rounded(point: Point) -> Vector {
    let [x, y, z] = point.map(|x| x as Real);
    Vector::new(x, y, z)
}

/// The largest number not above a time.
fn below(time: f64) -> Real {
    let nearest = time as Real;
    if f64::from(nearest) > time {
        nearest.next_down()
    } else {
        nearest
    }
}

/// The hit in the frames of both shapes, which have these poses at that time in the frame of the surfaces.
fn in_frames(hit: Hit, poses: [Pose; 2]) -> ShapeCastHit {
    let Hit {
        place,
        time,
        is_converged,
    } = hit;
    let normal = place.normal.map_or(Vector::ZERO, rounded);
    let [p, q] = place.points.map(rounded);
    let [to_first, to_second] = poses.map(|pose| pose.inverse());
    ShapeCastHit {
        time_of_impact: below(time),
        witness1: to_first * p,
        witness2: to_second * q,
        normal1: to_first.rotation * normal,
        normal2: to_second.rotation * -normal,
        status: if time == 0.0 {
            ShapeCastStatus::PenetratingOrWithinTargetDist
        } else if is_converged {
            ShapeCastStatus::Converged
        } else {
            ShapeCastStatus::OutOfIterations
        },
        subshape1: place.parts[0],
        subshape2: place.parts[1],
    }
}

/// The motion of a body from a time on, for a duration.
fn rigid(motion: &NonlinearRigidMotion, start: Real, duration: Real) -> Result<RigidMotion, Failure> {
    let center = motion.start * motion.local_center + motion.linvel * start;
    let angle = f64::from(motion.angvel.length()) * f64::from(duration);
    let displacement = exactly(motion.linvel).map(|speed| speed * f64::from(duration));
    Ok(RigidMotion::new(
        exactly(center),
        exactly(motion.angvel),
        angle,
        displacement,
    )?)
}

impl QueryDispatcher for ExactDispatcher {
    fn intersection_test(
        &self,
        pos12: &Pose,
        g1: &dyn Shape,
        g2: &dyn Shape,
    ) -> Result<ShapeIntersection, Unsupported> {
        let parts = supported(surfaces([&Pose::IDENTITY, pos12], [g1, g2])?.meet())?;
        Ok(parts.map_or(ShapeIntersection::new(false), |[a, b]| {
            ShapeIntersection::new(true).with_subshapes(a, b)
        }))
    }

    fn distance(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape) -> Result<ShapeDistance, Unsupported> {
        Err(Unsupported)
    }

    fn contact(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Real,
    ) -> Result<Option<Contact>, Unsupported> {
        Err(Unsupported)
    }

    fn closest_points(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Real,
    ) -> Result<ClosestPoints, Unsupported> {
        Err(Unsupported)
    }

    fn cast_shapes(
        &self,
        pos12: &Pose,
        local_vel12: Vector,
        g1: &dyn Shape,
        g2: &dyn Shape,
        options: ShapeCastOptions,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        let until = f64::from(options.max_time_of_impact);
        let distance = Separation::new(f64::from(options.target_distance)).map_err(|_| Unsupported)?;
        if !options.stop_at_penetration || until.is_nan() || until < 0.0 {
            return Err(Unsupported);
        }
        let surfaces = surfaces([&Pose::IDENTITY, pos12], [g1, g2])?;
        let hit = supported(surfaces.cast(exactly(local_vel12), until, distance))?;
        Ok(hit.map(|hit| {
            let shift = Pose::from_translation(local_vel12 * below(hit.time));
            in_frames(hit, [Pose::IDENTITY, shift * *pos12])
        }))
    }

    fn cast_shapes_nonlinear(
        &self,
        motion1: &NonlinearRigidMotion,
        g1: &dyn Shape,
        motion2: &NonlinearRigidMotion,
        g2: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        let duration = end_time - start_time;
        if !stop_at_penetration || duration.is_nan() || duration < 0.0 {
            return Err(Unsupported);
        }
        let poses = [motion1, motion2].map(|motion| motion.position_at_time(start_time));
        let surfaces = surfaces([&poses[0], &poses[1]], [g1, g2])?;
        let [first, second] = [motion1, motion2].map(|motion| supported(rigid(motion, start_time, duration)));
        let hit = supported(surfaces.cast_rigid([first?, second?], f64::from(duration)))?;
        Ok(hit.map(|hit| {
            let time = below(f64::from(start_time) + hit.time);
            let poses = [motion1, motion2].map(|motion| motion.position_at_time(time));
            ShapeCastHit {
                time_of_impact: time,
                ..in_frames(hit, poses)
            }
        }))
    }
}

impl<ManifoldData, ContactData> PersistentQueryDispatcher<ManifoldData, ContactData> for ExactDispatcher {
    fn contact_manifolds(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Real,
        _: &mut Vec<ContactManifold<ManifoldData, ContactData>>,
        _: &mut Option<ContactManifoldsWorkspace>,
    ) -> Result<(), Unsupported> {
        Err(Unsupported)
    }

    fn contact_manifold_convex_convex(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Option<&dyn NormalConstraints>,
        _: Option<&dyn NormalConstraints>,
        _: Real,
        _: &mut ContactManifold<ManifoldData, ContactData>,
    ) -> Result<(), Unsupported> {
        Err(Unsupported)
    }
}

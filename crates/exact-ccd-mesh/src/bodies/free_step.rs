//! The step of bodies that a solver can take: certified to be free of contact.

use exact_ccd::Options;
use exact_ccd::motion::Pose;

use super::Bodies;
use super::contact::BodyContact;
use super::error::BodiesError;
use crate::steps::place;

/// A step of bodies that is free of contact.
///
/// Unless `size` is 0, the motion from the start to `poses`, as they are after rounding, has been checked
/// exactly to be free of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct FreePoses {
    /// The part of the full step that is taken, from 0 to 1. It is 1 if the full step is free of contact. It
    /// is 0 if none of the sizes that are tried is certified: bodies touch at the start, or are nearer to
    /// each other there than rounded poses are to the path.
    pub size: f64,
    /// The poses at its end: the start if the size is 0, and the end of the full step if it is 1.
    pub poses: Vec<Pose>,
    /// The earliest contact of the full step, or `None` if the full step is free of contact.
    pub contact: Option<BodyContact>,
}

impl Bodies {
    /// A step from poses at t = 0 towards poses at t = 1 that is certified to be free of contact.
    ///
    /// The size is 1 if the full step is free, otherwise `keep` times the largest f64 not above its time of
    /// impact, the product rounded to nearest. The quaternions and places there are rounded, and the motion
    /// from the start to these poses is decided exactly. If it is not free, the f64 1, 2, 4, … places below
    /// the first size are tried, until one is free or the size is 0. A body at rest keeps its pose.
    ///
    /// ```
    /// use exact_ccd::CONTACT;
    /// use exact_ccd::motion::Pose;
    /// use exact_ccd_mesh::{Bodies, Frame};
    ///
    /// let point = || Frame::with_edges(vec![[0.0; 3]], Vec::new(), &[]);
    /// let bodies = Bodies::new([point()?, point()?])?;
    /// let at = |x: f64| Pose::new([1.0, 0.0, 0.0, 0.0], [x, 0.0, 0.0]);
    /// let (start, end) = ([at(0.0)?, at(1.0)?], [at(2.0)?, at(1.0)?]);
    /// let step = bodies.free_step(&start, &end, 0.5, CONTACT)?;
    /// assert_eq!((step.size, step.poses), (0.25, vec![at(0.5)?, at(1.0)?]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`motions`](Self::motions); [`BodiesError::Keep`] for a fraction that is not above 0 and at most 1.
    pub fn free_step(
        &self,
        poses0: &[Pose],
        poses1: &[Pose],
        keep: f64,
        options: impl Into<Options>,
    ) -> Result<FreePoses, BodiesError> {
        // The last time that counts is the end of the step that is taken.
        let options = options.into().until(1.0);
        if !(keep > 0.0 && keep <= 1.0) {
            return Err(BodiesError::Keep(keep));
        }
        let motions = self.motions(poses0, poses1)?;
        let contact = self.collision(&motions, options)?;
        let free = |size, poses: Vec<Pose>| FreePoses { size, poses, contact };
        let Some(first) = contact.map(|contact| keep * contact.impact.time.lower()) else {
            return Ok(free(1.0, poses1.to_vec()));
        };
        let (mut size, mut retreat) = (first, 1);
        // By its bits: a comparison may read a subnormal number as zero.
        while size.to_bits() > 0 {
            if let Some(poses) = between(poses0, poses1, size)
                && let Ok(motions) = self.motions(poses0, &poses)
                && !self.collides(&motions, options)?
            {
                return Ok(free(size, poses));
            }
            size = f64::from_bits(first.to_bits().saturating_sub(retreat));
            retreat *= 2;
        }
        Ok(free(0.0, poses0.to_vec()))
    }
}

/// The poses at a time between two others, rounded; `None` if one is not a pose, after underflow.
fn between(poses0: &[Pose], poses1: &[Pose], time: f64) -> Option<Vec<Pose>> {
    let pairs = poses0.iter().zip(poses1);
    let poses = pairs.map(|(start, end)| {
        let [q, r] = [start.rotation(), end.rotation()];
        let vector = |q: [f64; 4]| [q[1], q[2], q[3]];
        let [a, _, _] = place([q[0], 0.0, 0.0], [r[0], 0.0, 0.0], time);
        let [b, c, d] = place(vector(q), vector(r), time);
        Pose::new([a, b, c, d], place(start.place(), end.place(), time)).ok()
    });
    poses.collect()
}

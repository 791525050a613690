//! Shifts of whole meshes after which all differences of coordinates are exact (section 4.2 of the
//! paper on [parity](exact_ccd::parity)).

use exact_ccd::parity::{Displacement, RoundingError};
use exact_ccd::{Axis, Point};

use crate::aabb::Aabb;
use crate::frame::Frame;
use crate::motion::Motion;

impl Aabb {
    /// The displacement after which the difference of any two points of the box is exact. For the
    /// empty box it is zero.
    #[must_use]
    pub fn displacement(&self) -> Displacement {
        if *self == Self::EMPTY {
            Displacement::default()
        } else {
            Displacement::of_box(self.lower, self.upper)
        }
    }
}

impl Frame {
    /// The box around all vertices.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.positions.iter().copied().collect()
    }

    /// The frame, with each vertex shifted and rounded.
    ///
    /// The displacement of the box around all frames of a simulation serves every one of them:
    ///
    /// ```
    /// use exact_ccd_mesh::{Aabb, Frame};
    ///
    /// let frame = |x: f64| Frame::new(vec![[0.0, 1.0, 0.1], [x, 1.0, 0.1]], vec![]);
    /// let frames = [frame(0.1)?, frame(0.2)?, frame(0.3)?];
    /// let bounds = frames.iter().map(Frame::bounds).fold(Aabb::EMPTY, |a, b| a.union(&b));
    /// let displacement = bounds.displacement();
    /// assert_eq!(displacement.along_axes(), [0.3, 0.0, 0.0]);
    /// assert_eq!(frames[0].shifted(displacement)?.positions, [[0.3, 1.0, 0.1], [0.4, 1.0, 0.1]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RoundingError::OutOfRange`] names the axis along which a shifted coordinate would not be
    /// finite.
    pub fn shifted(&self, displacement: Displacement) -> Result<Self, RoundingError> {
        let positions = shifted(&self.positions, displacement)?;
        let mesh = self.mesh.clone();
        Ok(Self { mesh, positions })
    }
}

impl Motion {
    /// The displacement of the box around both frames, after which the corner differences of all
    /// queries of the step are exact. See [`Motion::shifted`].
    #[must_use]
    pub fn displacement(&self) -> Displacement {
        let bounds: Aabb = self.x0.iter().chain(&self.x1).copied().collect();
        bounds.displacement()
    }

    /// The motion, with each vertex shifted and rounded at both times.
    ///
    /// ```
    /// use exact_ccd_mesh::{Frame, Motion};
    /// use exact_ccd::parity::Rounded;
    ///
    /// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let frame = |x: f64| Frame::new([&[[x, 0.7, 0.3]], &corners[..]].concat(), vec![[1, 2, 3]]);
    /// let motion = Motion::new(frame(0.1)?, frame(1e-9)?)?;
    /// assert!(Rounded::check(motion.step()?.vertex_face(0, 0).expect("both are there")).is_err());
    ///
    /// let shifted = motion.shifted(motion.displacement())?;
    /// assert!(Rounded::check(shifted.step()?.vertex_face(0, 0).expect("both are there")).is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RoundingError::OutOfRange`] names the axis along which a shifted coordinate would not be
    /// finite.
    pub fn shifted(&self, displacement: Displacement) -> Result<Self, RoundingError> {
        Ok(Self {
            mesh: self.mesh.clone(),
            x0: shifted(&self.x0, displacement)?,
            x1: shifted(&self.x1, displacement)?,
        })
    }
}

fn shifted(positions: &[Point], displacement: Displacement) -> Result<Vec<Point>, RoundingError> {
    let shift = |&point: &Point| {
        let shifted = displacement.apply(point);
        match shifted.iter().position(|x| !x.is_finite()) {
            None => Ok(shifted),
            Some(axis) => Err(RoundingError::OutOfRange {
                axis: Axis::ALL[axis],
            }),
        }
    };
    positions.iter().map(shift).collect()
}

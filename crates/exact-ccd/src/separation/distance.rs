//! Distances: the threshold of a query, and bounds of the distance at one time.

/// A distance d below which two primitives count as close: a finite f64, at least 0, in the unit of
/// the coordinates.
///
/// It is taken exactly. −0.0 is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Separation(f64);

/// A separation is negative, infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("separation {value} is not a finite number of at least 0")]
pub struct InvalidSeparation {
    /// The separation.
    pub value: f64,
}

impl Separation {
    /// The separation d.
    ///
    /// # Errors
    /// [`InvalidSeparation`], if d is negative, infinite or not a number.
    pub fn new(d: f64) -> Result<Self, InvalidSeparation> {
        let magnitude = d.abs();
        // By its sign, because a comparison may read a subnormal number as zero.
        if d.is_finite() && (d.is_sign_positive() || magnitude.to_bits() == 0) {
            Ok(Self(magnitude))
        } else {
            Err(InvalidSeparation { value: d })
        }
    }

    /// The separation as an f64.
    #[must_use]
    #[inline]
    pub fn get(self) -> f64 {
        self.0
    }

    /// Returns true for 0. By its bits, because a comparison may read a subnormal number as zero.
    #[inline]
    pub(super) fn is_zero(self) -> bool {
        self.0.to_bits() == 0
    }
}

impl TryFrom<f64> for Separation {
    type Error = InvalidSeparation;

    fn try_from(d: f64) -> Result<Self, InvalidSeparation> {
        Self::new(d)
    }
}

/// The distance of two primitives at one time, between two f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBounds {
    /// The largest f64 that is not above the distance.
    pub lower: f64,
    /// The smallest f64 that is not below the distance; infinite if the distance is above all of
    /// them.
    pub upper: f64,
}

/// A time is not in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("time {time} is not in the step, from 0 to 1")]
pub struct TimeOutOfStep {
    /// The time.
    pub time: f64,
}

impl TimeOutOfStep {
    /// Checks that a time is in [0, 1].
    pub(crate) fn check(time: f64) -> Result<(), Self> {
        if (0.0..=1.0).contains(&time) {
            Ok(())
        } else {
            Err(Self { time })
        }
    }
}

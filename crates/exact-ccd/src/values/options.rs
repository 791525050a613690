//! The distance at which primitives touch, and the last time that counts.

use super::distance::Separation;
use super::thickness::{Separations, Thickness};

/// Contact in the whole step: the distance 0, which is the default of [`Options`].
pub const CONTACT: Options = Options::within(Separation::ZERO);

/// The distance at which primitives *touch*, and the last time that counts.
///
/// Two primitives touch at a time if their distance then is at most the separation d. Contact is d = 0,
/// [`CONTACT`]; what is said about contact holds for any d. A separation converts into options, so that
/// all functions that take options take a separation too. For a batch, D is [`Separations`]: one for
/// all pairs, or by the thickness of the vertices.
///
/// ```
/// use exact_ccd::{CONTACT, Options, Query, Separation, VertexVertex};
///
/// // Two vertices fly past each other at a distance of 3.
/// let query = Query::<VertexVertex>::new([[-8.0, 3.0, 0.0], [0.0; 3]], [[8.0, 3.0, 0.0], [0.0; 3]])?;
/// let d = Separation::new(5.0)?;
/// assert!(!query.collides(CONTACT));
/// assert_eq!(query.time_of_impact(d), Some(0.25));
/// assert!(!query.collides(Options::within(d).until(0.125)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<D = Separation> {
    /// The distance at which primitives touch.
    pub separation: D,
    /// The last time that counts: primitives that first touch later do not collide. None collide if it
    /// is negative or NaN.
    pub until: f64,
}

impl<D> Options<D> {
    /// A distance, and the whole step.
    #[must_use]
    pub const fn within(separation: D) -> Self {
        Self {
            separation,
            until: 1.0,
        }
    }

    /// The same distance with another last time that counts. With a separation above 0, an earlier time makes
    /// a batch cheaper.
    #[must_use]
    pub fn until(self, until: f64) -> Self {
        Self { until, ..self }
    }
}

impl<D: Default> Default for Options<D> {
    fn default() -> Self {
        Self::within(D::default())
    }
}

impl<D> From<D> for Options<D> {
    fn from(separation: D) -> Self {
        Self::within(separation)
    }
}

impl From<Separation> for Options<Separations<'_>> {
    fn from(separation: Separation) -> Self {
        Self::within(separation.into())
    }
}

impl From<Options> for Options<Separations<'_>> {
    fn from(Options { separation, until }: Options) -> Self {
        Self::within(separation.into()).until(until)
    }
}

impl<'a> From<&'a Thickness> for Options<Separations<'a>> {
    fn from(thickness: &'a Thickness) -> Self {
        Self::within(thickness.into())
    }
}

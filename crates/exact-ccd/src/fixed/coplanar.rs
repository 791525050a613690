//! Contact of primitives that are coplanar at all times: the cubic is zero, and the signs of quadratics decide.
//!
//! Contact is the same at all times between two successive roots of these quadratics. So the first contact
//! after the start is at one of their roots. There, the signs of all of them are computed: a sign that is not
//! certain from roundings is zero if the quadratics have this root in common, which their resultant decides.

use arrayvec::ArrayVec;

use super::common_root::{Quadratic, vanishes_at_quadratic_root};
use super::dyadic::Dyadic;
use super::exact_cubic::ExactCubic;
use super::fraction::Fraction;
use super::lattice::Integers;
use super::length::Volume;
use super::moment::Moment;
use super::window::{Window, sign_at};
use super::zeros::{narrowed, order_of_root, zeros};
use crate::numbers::cubic::Root;
use crate::tables::Tables;
use crate::values::ContactTime;

/// The quadratics that decide contact and are not zero: at most one for each of three axes and a scalar product, for four sides.
pub(super) type Quadratics = ArrayVec<Quadratic, 16>;

/// The root of a quadratic in a bracket of a window.
#[derive(Clone, Debug)]
pub(crate) struct QuadraticRoot {
    quadratic: Quadratic,
    pub(super) window: Window,
    pub(super) root: Root,
}

impl QuadraticRoot {
    /// Returns true if another quadratic certainly vanishes at this root.
    pub(super) fn is_root_of(&self, other: &Quadratic) -> bool {
        vanishes_at_quadratic_root(other, &self.quadratic, self.bracket())
    }

    /// Returns true if this root is before another one, if that is certain.
    ///
    /// If both are where their brackets overlap and have a quadratic in common, they are the same root.
    fn is_before(&self, other: &Self) -> Option<bool> {
        let [[low, high], [other_low, other_high]] = [self.bracket(), other.bracket()];
        if high <= other_low || other_high <= low {
            return Some(high <= other_low);
        }
        let overlap = [low.max(other_low), high.min(other_high)];
        let is_inside = |root: &Self| {
            let [low, high] = overlap.map(|time| sign_at(&raised(&root.quadratic), time));
            low.is_ne() && low.reverse() == high
        };
        let are_same = is_inside(self) && is_inside(other) && self.is_root_of(&other.quadratic);
        are_same.then_some(false)
    }

    /// Two times around the root.
    fn bracket(&self) -> [Dyadic; 2] {
        self.window.bracket(&self.root)
    }

    /// The time, if it is certain.
    pub(super) fn time(&self) -> Option<ContactTime> {
        ExactCubic::new(raised(&self.quadratic)).time(&Moment::Root(self.window, self.root))
    }

    /// The same root in a narrower window, or as a time with few digits.
    fn narrowed(&self) -> Option<Moment> {
        let narrow = narrowed(&raised(&self.quadratic), &self.window, &self.root)?;
        Some(of_quadratic(&self.quadratic, narrow))
    }
}

/// A moment at which the raised quadratic vanishes, as one of the quadratic.
fn of_quadratic(quadratic: &Quadratic, moment: Moment) -> Moment {
    match moment {
        Moment::Root(window, root) => Moment::QuadraticRoot(QuadraticRoot {
            quadratic: *quadratic,
            window,
            root,
        }),
        moment => moment,
    }
}

/// The quadratic, times (1−t) + t.
fn raised([q0, q1, q2]: &Quadratic) -> [Volume; 4] {
    let [q0, q1, q2] = [q0, q1, q2].map(|q| q.widened());
    [q0, q0 + q1, q1 + q2, q2]
}

/// The first moment of contact after the start of primitives that are coplanar at all times and do not touch at
/// the start; `Some(None)` if there certainly is no contact, `None` if that is unknown.
pub(super) fn first<K: Tables>(integers: &Integers<K>) -> Option<Option<Moment>> {
    let mut first = None;
    for quadratic in integers.quadratics() {
        for moment in zeros(&raised(&quadratic))? {
            let moment = of_quadratic(&quadratic, moment);
            if matches!(moment, Moment::At(time) if time == Fraction::START) {
                continue;
            }
            let is_earlier = match &first {
                Some(first) => match is_before(&moment, first) {
                    Some(is_before) => is_before,
                    None => is_before(&narrow(&moment)?, &narrow(first)?)?,
                },
                None => true,
            };
            if is_earlier && let (moment, true) = decided(integers, moment)? {
                first = Some(moment);
            }
        }
    }
    Some(first)
}

/// A moment, in a narrower window if that is necessary, and true if the primitives touch then.
fn decided<K: Tables>(integers: &Integers<K>, moment: Moment) -> Option<(Moment, bool)> {
    if let Some(touches) = integers.touches(&moment) {
        return Some((moment, touches));
    }
    let narrow = narrow(&moment)?;
    let touches = integers.touches(&narrow)?;
    Some((narrow, touches))
}

/// The same moment, in a narrower window if it is a root.
fn narrow(moment: &Moment) -> Option<Moment> {
    match moment {
        Moment::QuadraticRoot(root) => root.narrowed(),
        moment => Some(moment.clone()),
    }
}

/// Returns true if a moment is before another one, if that is certain.
fn is_before(a: &Moment, b: &Moment) -> Option<bool> {
    match (a, b) {
        (Moment::QuadraticRoot(a), Moment::At(time)) => {
            Some(order_of_root(&a.window, &a.root, &raised(&a.quadratic), *time)?.is_lt())
        }
        (Moment::At(time), Moment::QuadraticRoot(b)) => {
            Some(order_of_root(&b.window, &b.root, &raised(&b.quadratic), *time)?.is_gt())
        }
        (Moment::At(a), Moment::At(b)) => Some(a < b),
        (Moment::QuadraticRoot(a), Moment::QuadraticRoot(b)) => a.is_before(b),
        _ => None,
    }
}

//! Contact of primitives that are coplanar at all times: the cubic is zero, and the signs of quadratics
//! decide.
//!
//! Contact is the same at all times between two successive roots of these quadratics. So the first contact
//! after the start is at one of their roots. There, the signs of all of them are computed: a sign that is not
//! certain from roundings is zero if the quadratics have this root in common, which their resultant decides.

use super::common_root::{Quadratic, raised};
use super::fraction::Fraction;
use super::lattice::Integers;
use super::moment::Moment;
use super::quadratic_root::QuadraticRoot;
use super::zeros::{narrowed, order_of_root, zeros};
use crate::tables::Tables;

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

/// The first moment of contact after the start of primitives that are coplanar at all times and do not touch
/// at the start; `Some(None)` if there certainly is no contact, `None` if that is unknown.
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
                    None => is_before(&narrower(&moment)?, &narrower(first)?)?,
                },
                None => true,
            };
            if is_earlier && let (moment, true) = integers.decided(moment, narrower)? {
                first = Some(moment);
            }
        }
    }
    Some(first)
}

/// The same moment, in a narrower window if it is a root.
fn narrower(moment: &Moment) -> Option<Moment> {
    match moment {
        Moment::QuadraticRoot(of) => {
            let narrow = narrowed(&of.raised(), &of.window, &of.root)?;
            Some(of_quadratic(&of.quadratic, narrow))
        }
        moment => Some(moment.clone()),
    }
}

/// Returns true if a moment is before another one, if that is certain.
fn is_before(a: &Moment, b: &Moment) -> Option<bool> {
    match (a, b) {
        (Moment::QuadraticRoot(a), Moment::At(time)) => {
            Some(order_of_root(&a.window, &a.root, &a.raised(), *time)?.is_lt())
        }
        (Moment::At(time), Moment::QuadraticRoot(b)) => {
            Some(order_of_root(&b.window, &b.root, &b.raised(), *time)?.is_gt())
        }
        (Moment::At(a), Moment::At(b)) => Some(a < b),
        (Moment::QuadraticRoot(a), Moment::QuadraticRoot(b)) => a.is_before(b),
        _ => None,
    }
}

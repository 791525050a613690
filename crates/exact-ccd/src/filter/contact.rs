//! A contact that the filters have proved, and the further answers that follow from the proof.

use arrayvec::ArrayVec;

use super::coincident::{self, Coincidence};
use super::coplanarity;
use super::impact::parameters_and_normal;
use super::planar::{Event, Planar};
use super::position::{self, Position};
use crate::fixed;
use crate::fixed::exact_cubic::ExactCubic;
use crate::fixed::moment::Moment;
use crate::numbers::cubic::Root;
use crate::tables::{Points, Tables};
use crate::values::{ContactTime, Impact, Interval, Intervals, Stage};

/// A proved contact, with the intermediate results of the proof.
#[derive(Clone, Debug)]
pub(crate) enum Contact {
    /// The primitives are coplanar exactly at some roots, and touch at one of them.
    AtRoot(AtRoot),
    /// The primitives first touch at this time, the last one that counts.
    At(f64),
    /// The primitives are coplanar at all times, and in contact for an interval that begins like
    /// this.
    Sliding(Event),
    /// The primitives touch because coordinates are equal.
    Coincident(Coincidence),
    /// The primitives first touch at this moment.
    AtMoment(Moment),
}

/// Contact at one of some roots.
#[derive(Clone, Debug)]
pub(crate) struct AtRoot {
    /// All roots of the coplanarity cubic in the step, in increasing order.
    roots: ArrayVec<Root, 3>,
    /// The index of the first root at which the primitives certainly touch.
    touching: usize,
    /// True if they certainly do not touch at any root before that one.
    is_first: bool,
}

impl AtRoot {
    /// The root of the earliest contact and those after it, if it is certain.
    fn since_first(&self) -> Option<(&Root, &[Root])> {
        self.roots
            .get(self.touching..)
            .filter(|_| self.is_first)?
            .split_first()
    }
}

impl Contact {
    /// The contact at one of the roots; `Some(None)` if there certainly is none, `None` if that is not known.
    #[inline]
    pub(super) fn at_roots<K: Tables>(
        points: &Points<f64>,
        roots: ArrayVec<Root, 3>,
    ) -> Option<Option<Self>> {
        let mut is_first = true;
        for (index, root) in roots.iter().enumerate() {
            match position::at::<K>(points, root) {
                Some(Position::Inside) => {
                    return Some(Some(Self::AtRoot(AtRoot {
                        touching: index,
                        is_first,
                        roots,
                    })));
                }
                Some(Position::Outside) => {}
                None => is_first = false,
            }
        }
        is_first.then_some(None)
    }

    /// The stage that proved the contact.
    #[inline]
    pub(crate) fn stage(&self) -> Stage {
        match self {
            Self::AtRoot(_) | Self::At(_) => Stage::Roots,
            Self::Sliding(_) => Stage::Planar,
            Self::Coincident(_) => Stage::Coincident,
            Self::AtMoment(_) => Stage::FixedWidth,
        }
    }

    /// The earliest contact time, if the filters determine it.
    pub(crate) fn first<K: Tables>(&self, points: &Points<f64>) -> Option<ContactTime> {
        let by_roundoff = match self {
            Self::AtRoot(at_root) => match at_root.since_first() {
                Some((root, _)) => return times_of_roots::<K>(points)(root),
                None => None,
            },
            Self::At(time) => return Some(ContactTime::exactly(*time)),
            Self::Sliding(beginning) => Planar::new(points).and_then(|planar| planar.round(beginning)),
            Self::Coincident(coincidence) => coincidence.first,
            Self::AtMoment(moment) => return fixed::time::<K>(points, moment),
        };
        by_roundoff.or_else(|| fixed::first::<K>(points))
    }

    /// Two times between which the earliest contact certainly is.
    #[inline]
    pub(crate) fn bracket(&self) -> Option<[f64; 2]> {
        match self {
            Self::AtRoot(at_root) => at_root.since_first().map(|(root, _)| [root.low, root.high]),
            Self::At(_) | Self::Sliding(_) | Self::Coincident(_) | Self::AtMoment(_) => None,
        }
    }

    /// All intervals of contact, if the filters determine them.
    pub(crate) fn intervals<K: Tables>(&self, points: &Points<f64>) -> Option<Intervals> {
        let by_roundoff = match self {
            Self::AtRoot(at_root) => at_root
                .since_first()
                .and_then(|roots| moments::<K>(points, roots)),
            Self::Sliding(_) => Planar::new(points).and_then(|planar| planar.intervals::<K>()),
            Self::Coincident(coincidence) => coincidence.intervals(),
            Self::At(_) | Self::AtMoment(_) => None,
        };
        by_roundoff.or_else(|| fixed::moments::<K>(points))
    }

    /// The earliest contact, if the filters determine it.
    pub(crate) fn impact<K: Tables>(&self, points: &Points<f64>) -> Option<Impact> {
        let root = match self {
            Self::AtRoot(at_root) => at_root.since_first()?.0,
            Self::Coincident(_) => return coincident::impact::<K>(points),
            Self::Sliding(beginning) => return Planar::new(points)?.impact::<K>(beginning),
            Self::At(_) | Self::AtMoment(_) => return None,
        };
        let time = self.first::<K>(points)?;
        let (parameters, normal) = parameters_and_normal::<K>(points, &root.at(time))?;
        let normal = Some(normal);
        Some(Impact {
            time,
            parameters,
            normal,
        })
    }
}

/// The moments of contact at a root, and at those after it at which the primitives touch.
fn moments<K: Tables>(points: &Points<f64>, (first, later): (&Root, &[Root])) -> Option<Intervals> {
    let time = times_of_roots::<K>(points);
    let moment = |root: &Root| time(root).map(Interval::moment);
    let of_later = later
        .iter()
        .filter_map(|root| match position::at::<K>(points, root) {
            Some(Position::Inside) => Some(moment(root)),
            Some(Position::Outside) => None,
            None => Some(None),
        });
    [moment(first)].into_iter().chain(of_later).collect()
}

/// The times of roots of the coplanarity cubic, where they are certain.
fn times_of_roots<K: Tables>(points: &Points<f64>) -> impl Fn(&Root) -> Option<ContactTime> {
    let cubic = ExactCubic::of::<K>(points).ok_or_else(|| coplanarity::precise::<K>(points));
    move |root| match &cubic {
        Ok(exact) => exact.time_of_root(root),
        Err(precise) => precise.round(root),
    }
}

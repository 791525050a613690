//! A contact that the filters have proved, and the further answers that follow from the proof.

use arrayvec::ArrayVec;

use super::coincident::{self, Coincidence};
use super::coplanarity;
use super::cubic::Root;
use super::fixed_width;
use super::impact::parameters_and_normal;
use super::moment::Moment;
use super::planar::{Event, Planar};
use super::position::{self, Position};
use crate::impact::Impact;
use crate::interval::{Interval, Intervals};
use crate::kind::Kind;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTime;

/// A proved contact, with the intermediate results of the proof.
#[derive(Clone, Debug)]
pub(crate) enum Contact {
    /// The primitives are coplanar exactly at some roots, and touch at one of them.
    AtRoot {
        /// All roots of the coplanarity cubic in the step, in increasing order.
        roots: ArrayVec<Root, 3>,
        /// The index of the first root at which the primitives certainly touch.
        touching: usize,
        /// True if they certainly do not touch at any root before that one.
        is_first: bool,
    },
    /// The primitives are coplanar at all times, and in contact for an interval that begins like
    /// this.
    Sliding(Event),
    /// The primitives touch because coordinates are equal.
    Coincident(Coincidence),
    /// The primitives first touch at this moment.
    AtMoment(Moment),
}

impl Contact {
    /// The contact at one of the roots; `Ok(None)` if there certainly is none, `Err` if that is not
    /// known.
    #[inline]
    pub(super) fn at_roots<K: Kind>(
        query: &Query<K>,
        roots: ArrayVec<Root, 3>,
    ) -> Result<Option<Self>, Unknown> {
        let mut is_first = true;
        for (index, root) in roots.iter().enumerate() {
            match position::at(query, root) {
                Some(Position::Inside) => {
                    return Ok(Some(Self::AtRoot {
                        touching: index,
                        is_first,
                        roots,
                    }));
                }
                Some(Position::Outside) => {}
                None => is_first = false,
            }
        }
        if is_first { Ok(None) } else { Err(Unknown) }
    }

    /// The stage that proved the contact.
    #[inline]
    pub(crate) fn stage(&self) -> Stage {
        match self {
            Self::AtRoot { .. } => Stage::Roots,
            Self::Sliding(_) => Stage::Planar,
            Self::Coincident(_) => Stage::Coincident,
            Self::AtMoment(_) => Stage::FixedWidth,
        }
    }

    /// The earliest contact time, if the filters determine it.
    pub(crate) fn first<K: Kind>(&self, query: &Query<K>) -> Option<ContactTime> {
        if let Self::AtMoment(moment) = self {
            return fixed_width::time(query, moment);
        }
        self.first_by_roundoff(query).or_else(|| match self {
            Self::AtRoot {
                roots,
                touching,
                is_first: true,
            } => fixed_width::round(query, &roots[*touching]),
            _ => fixed_width::first(query),
        })
    }

    /// The same without integers of fixed width.
    fn first_by_roundoff<K: Kind>(&self, query: &Query<K>) -> Option<ContactTime> {
        match self {
            Self::AtRoot {
                roots,
                touching,
                is_first: true,
            } => {
                let root = &roots[*touching];
                fixed_width::dyadic(query, root).or_else(|| coplanarity::precise(query).round(root))
            }
            Self::AtRoot { is_first: false, .. } => None,
            Self::Sliding(beginning) => Planar::new(query)?.round(beginning),
            Self::Coincident(coincidence) => coincidence.first(),
            Self::AtMoment(_) => None,
        }
    }

    /// All intervals of contact, if the filters determine them.
    pub(crate) fn intervals<K: Kind>(&self, query: &Query<K>) -> Option<Intervals> {
        self.intervals_by_roundoff(query)
            .or_else(|| fixed_width::moments(query))
    }

    /// The same without integers of fixed width.
    fn intervals_by_roundoff<K: Kind>(&self, query: &Query<K>) -> Option<Intervals> {
        match self {
            Self::AtRoot {
                roots,
                touching,
                is_first: true,
            } => {
                let (first, later) = roots.get(*touching..)?.split_first()?;
                let precise = coplanarity::precise(query);
                let moment = |root: &Root| {
                    let dyadic = fixed_width::dyadic(query, root);
                    dyadic.or_else(|| precise.round(root)).map(Interval::moment)
                };
                let of_later = later.iter().filter_map(|root| match position::at(query, root) {
                    Some(Position::Inside) => Some(moment(root)),
                    Some(Position::Outside) => None,
                    None => Some(None),
                });
                [moment(first)].into_iter().chain(of_later).collect()
            }
            Self::AtRoot { is_first: false, .. } => None,
            Self::Sliding(_) => {
                let planar = Planar::new(query)?;
                let interval = |[beginning, end]: &[Event; 2]| {
                    Some(Interval {
                        start: planar.round(beginning)?,
                        end: planar.round(end)?,
                        is_moment: false,
                    })
                };
                planar.stretches()?.iter().map(interval).collect()
            }
            Self::Coincident(coincidence) => coincidence.intervals(),
            Self::AtMoment(_) => None,
        }
    }

    /// The earliest contact, if the filters determine it.
    pub(crate) fn impact<K: Kind>(&self, query: &Query<K>) -> Option<Impact> {
        let (roots, touching) = match self {
            Self::AtRoot {
                roots,
                touching,
                is_first: true,
            } => (roots, touching),
            Self::AtRoot { is_first: false, .. } | Self::Sliding(_) | Self::AtMoment(_) => return None,
            Self::Coincident(_) => return coincident::impact(query),
        };
        let time = self.first(query)?;
        let (parameters, normal) = parameters_and_normal(query, &roots[*touching].at(time))?;
        Some(Impact {
            time,
            parameters,
            normal: Some(normal),
        })
    }
}

/// The filters do not determine the answer.
pub(super) struct Unknown;

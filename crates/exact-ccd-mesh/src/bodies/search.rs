//! The search for the earliest contact.

use std::sync::{Mutex, PoisonError};

use exact_ccd::{ContactTime, Options};
use rayon::prelude::*;

use super::Bodies;
use super::candidate::{Candidate, Key};
use super::contact::BodyContact;

/// The earliest contact among candidates.
///
/// The filters bracket the first time of each, in floating point. None that begins after the end of another
/// bracket, or after a time that was found, is the earliest. So few times are computed to the last bit.
pub(super) fn earliest(bodies: &Bodies, candidates: &[Candidate], options: Options) -> Option<BodyContact> {
    let brackets = candidates.par_iter().filter_map(|candidate| {
        let bracket = candidate.bracket(bodies, options)?;
        Some((bracket, candidate))
    });
    let mut open: Vec<_> = brackets.collect();
    let until = open
        .iter()
        .fold(options.until, |until, ([_, end], _)| until.min(*end));
    open.retain(|([start, _], _)| *start <= until);
    open.par_sort_by(|([a, _], one), ([b, _], other)| {
        a.total_cmp(b).then_with(|| one.key().cmp(&other.key()))
    });
    let first: Mutex<Option<(ContactTime, Key, &Candidate)>> = Mutex::new(None);
    let lock = || first.lock().unwrap_or_else(PoisonError::into_inner);
    open.par_iter().for_each(|([start, _], candidate)| {
        let until = lock()
            .as_ref()
            .map_or(until, |(time, ..)| until.min(time.upper()));
        if *start > until {
            return;
        }
        let Some(time) = candidate.first_time(bodies, options.until(until)) else {
            return;
        };
        let mut first = lock();
        let is_earlier = first
            .as_ref()
            .is_none_or(|(before, key, _)| (time, candidate.key()) < (*before, *key));
        if is_earlier {
            *first = Some((time, candidate.key(), candidate));
        }
    });
    let (_, _, candidate) = first.into_inner().unwrap_or_else(PoisonError::into_inner)?;
    candidate.contact(bodies, options)
}

//! The answers to queries of curved motion, by the filters and by integers.

use exact_ccd::motion::{Bezier, BodyPair, Chain, CurvedQuery};
use exact_ccd::{AnyKind, CONTACT, Kind, Separation, with_kind};
use fastrand::Rng;

use crate::hard_cases::digest::Digest;
use crate::kernel::add_intervals;
use crate::numbers::{Numbers, one_of, tangent};

/// The number of queries of each family, kind and sort of numbers.
const COUNT: usize = 6;

pub(crate) fn digest() -> u64 {
    let mut digest = Digest::default();
    for &kind in AnyKind::ALL {
        with_kind!(kind, K => add_kind::<K>(&mut digest));
    }
    digest.0
}

fn add_kind<K: Kind>(digest: &mut Digest) {
    let mut random = Rng::with_seed(5);
    let random = &mut random;
    for numbers in Numbers::ALL {
        for _ in 0..COUNT {
            let degree = one_of(random, &[1, 2, 3, 5]);
            if let Ok(motion) = Bezier::<K>::new(&numbers.curves::<K>(random, degree)) {
                add_query(digest, &motion.into());
            }
            for lengths in [[1, 0], [0, 1], [1, 1], [2, 0]] {
                let [first, second] = lengths.map(|length| numbers.chain(random, length));
                add_bodies::<K>(digest, numbers.points::<K>(random), first, second);
            }
            let (points, chain) = tangent::<K>(random);
            add_bodies::<K>(digest, points, chain, Chain::default());
        }
    }
}

fn add_bodies<K: Kind>(digest: &mut Digest, points: K::Points, first: Chain, second: Chain) {
    let pair = BodyPair::new(first, second);
    for &point in points.as_ref() {
        let bounds = pair.bounds(point);
        bounds.as_flattened().iter().for_each(|&x| digest.add_number(x));
    }
    if let Ok(query) = pair.query::<K>(points) {
        add_query(digest, &query);
    }
}

/// All answers to a query, and what the filters prove.
fn add_query<K: Kind>(digest: &mut Digest, query: &CurvedQuery<K>) {
    let within = Separation::new(0.75).unwrap_or(Separation::ZERO);
    for options in [CONTACT, within.into(), CONTACT.until(0.5)] {
        let bracket = query.bracket(options);
        digest.add(bracket.is_some().into());
        bracket.iter().flatten().for_each(|&x| digest.add_number(x));
        digest.add(query.collides(options).into());
        let time = query.first_time(options);
        digest.add(time.is_some().into());
        time.into_iter().for_each(|time| digest.add_time(time));
        add_intervals(digest, &query.intervals(options));
        digest.add_impact(query.impact(options));
    }
    digest.add(query.exactly().collides(CONTACT).into());
}

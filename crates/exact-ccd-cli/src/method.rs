//! The methods that answer queries.

use std::fmt;

use exact_ccd::parity::{self, Parity, Rounded, RoundingError};
use exact_ccd::{ContactTime, ContactTimes, Kind, Query};

use crate::shortest::shortest;

/// What a query is asked.
#[derive(Clone, Copy, clap::ValueEnum)]
pub(crate) enum Method {
    /// The contact times, exactly.
    Exact,
    /// The parity of the number of contacts, after each query was shifted and rounded by itself.
    Parity,
    /// The parity of the number of contacts, in integers, without rounding.
    ParityRational,
}

/// What a method says of a query.
pub(crate) enum Answer {
    Times(ContactTimes),
    Parity(Parity),
}

impl Method {
    pub(crate) fn answer<K: Kind>(self, query: &Query<K>) -> Result<Answer, RoundingError> {
        Ok(match self {
            Self::Exact => Answer::Times(query.contact_times()),
            Self::Parity => Answer::Parity(Rounded::shift(query)?.parity()),
            Self::ParityRational => Answer::Parity(parity::rational(query)),
        })
    }
}

impl Answer {
    pub(crate) fn is_contact(&self) -> bool {
        match self {
            Self::Times(times) => times.first().is_some(),
            Self::Parity(parity) => parity.is_collision(),
        }
    }
}

/// The columns `contact`, `count` and `toi`.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},", u8::from(self.is_contact()))?;
        match self {
            Self::Times(times) => {
                let count = times.count().map_or("-1".to_owned(), |count| count.to_string());
                let toi = times.first().map(ContactTime::lower);
                write!(f, "{count},{}", toi.map_or(String::new(), shortest))
            }
            Self::Parity(Parity::Even) => write!(f, "even,"),
            Self::Parity(Parity::Odd) => write!(f, "odd,"),
            Self::Parity(Parity::Boundary) => write!(f, "boundary,"),
        }
    }
}

//! The methods of `exact-ccd queries`.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use exact_ccd::{
    AnyKind, Ccd, ContactTime, Decide, Intervals, Kind, Point, Query, Separation, TimeGuarantee,
};
use exact_ccd_data::Record;
use exact_ccd_methods::parity::{self, Parity, Rounded, RoundingError};
use exact_ccd_methods::{UnknownMethod, by_name};
use serde::Serialize;

use crate::messages::failure::Failure;
use crate::text::numbers::shortest;

/// A registered method, or the parity in integers. Methods that count contacts have variants of their own.
#[derive(Clone)]
pub(crate) enum Method {
    Exact,
    Parity,
    ParityRational,
    Other(Arc<dyn Ccd>),
}

/// The name of [`Method::ParityRational`]. It is not a registered method, but the parity without rounding.
const PARITY_RATIONAL: &str = "parity-rational";

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Self, UnknownMethod> {
        match name.to_ascii_lowercase().as_str() {
            "exact" => Ok(Self::Exact),
            "parity" => Ok(Self::Parity),
            PARITY_RATIONAL => Ok(Self::ParityRational),
            _ => by_name(name)
                .map(|method| Self::Other(method.into()))
                .map_err(|unknown| UnknownMethod {
                    known: Self::names(),
                    ..unknown
                }),
        }
    }
}

impl Method {
    /// The names of all methods.
    fn names() -> Vec<String> {
        let mut names = exact_ccd_methods::names();
        names.push(PARITY_RATIONAL.to_owned());
        names
    }

    /// The help of `--method`.
    pub(crate) fn help() -> String {
        format!("The method, in upper or lower case: {}", Self::names().join(", "))
    }

    fn name(&self) -> &str {
        match self {
            Self::Exact => "exact",
            Self::Parity => "parity",
            Self::ParityRational => PARITY_RATIONAL,
            Self::Other(method) => method.name(),
        }
    }

    /// Checks that the method has queries of a kind, and, if the distance is not 0, times within a
    /// distance. The exact method has both.
    pub(crate) fn check(&self, kind: AnyKind, d: Separation) -> Result<(), Failure> {
        let method = self.name();
        match (self, kind) {
            (Self::Exact, _) => Ok(()),
            (_, AnyKind::VertexFace | AnyKind::EdgeEdge) if d.is_zero() => Ok(()),
            (_, AnyKind::VertexFace | AnyKind::EdgeEdge) => Err(Failure::new(format_args!(
                "--min-distance above 0 needs --method exact: the method {method} decides contact"
            ))),
            _ => Err(Failure::new(format_args!(
                "--kind {} needs --method exact: the method {method} has the kinds vf and ee",
                kind.short()
            ))),
        }
    }

    /// The answer to a query within a distance, which [`check`](Self::check) accepts.
    pub(crate) fn answer<K: Kind<Points = [Point; 4]>>(
        &self,
        query: &Query<K>,
        d: Separation,
    ) -> Result<Answer, RoundingError>
    where
        dyn Ccd: Decide<K>,
    {
        Ok(match self {
            Self::Exact => Answer::exact(query, d),
            Self::Parity => Rounded::shift(query)?.parity().into(),
            Self::ParityRational => parity::rational(query).into(),
            Self::Other(method) => {
                let time = method.time_of_impact(query);
                let has_times = method.guarantees().time != TimeGuarantee::Absent;
                Answer {
                    collides: time.is_some(),
                    count: None,
                    toi: time.filter(|_| has_times),
                }
            }
        })
    }
}

/// The answer of a method to a query.
pub(crate) struct Answer {
    pub(crate) collides: bool,
    /// None from a method that does not count.
    pub(crate) count: Option<Count>,
    pub(crate) toi: Option<f64>,
}

/// A count of contacts. JSON has the number, or the parity as text.
#[derive(Clone, Copy, Serialize)]
#[serde(untagged)]
pub(crate) enum Count {
    /// The number of contacts, -1 for infinitely many, or of intervals of times within a distance.
    Number(i64),
    Parity(&'static str),
}

impl Answer {
    /// The answer of the exact method: contact, or the times within a distance above 0.
    pub(crate) fn exact<K: Kind>(query: &Query<K>, d: Separation) -> Self {
        Self::of_intervals(&query.intervals(d), d)
    }

    /// The answer with these times.
    pub(crate) fn of_intervals(intervals: &Intervals, d: Separation) -> Self {
        let (count, toi) = count_and_time(intervals, d);
        Self {
            collides: toi.is_some(),
            count: Some(Count::Number(count)),
            toi,
        }
    }
}

/// The number of contact times, -1 for infinitely many, and the first one. If the distance is above 0, the
/// number of maximal intervals of times within it, and the first such time.
pub(crate) fn count_and_time(intervals: &Intervals, d: Separation) -> (i64, Option<f64>) {
    let count = if d.is_zero() {
        intervals.count()
    } else {
        Some(intervals.len())
    };
    // At most some dozens.
    let count = count.map_or(-1, |count| count as i64);
    (count, intervals.first_time().map(ContactTime::lower))
}

/// A record with the answers of the exact method in place of its own.
pub(crate) fn answered<K: Kind>(record: Record<K>, d: Separation) -> Record<K> {
    let (count, toi) = count_and_time(&record.sample.query.intervals(d), d);
    let count = Some(count);
    Record { count, toi, ..record }
}

impl From<Parity> for Answer {
    fn from(parity: Parity) -> Self {
        let count = match parity {
            Parity::Even => "even",
            Parity::Odd => "odd",
            Parity::Boundary => "boundary",
        };
        Self {
            collides: parity.is_collision(),
            count: Some(Count::Parity(count)),
            toi: None,
        }
    }
}

/// The columns `contact`, `count` and `toi`.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = match self.count {
            None => String::new(),
            Some(Count::Number(number)) => number.to_string(),
            Some(Count::Parity(name)) => name.to_owned(),
        };
        let toi = self.toi.map_or(String::new(), shortest);
        write!(f, "{},{count},{toi}", u8::from(self.collides))
    }
}

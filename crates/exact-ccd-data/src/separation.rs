//! Queries with the times within a distance, computed in rational arithmetic.

use std::path::PathBuf;

use exact_ccd::{Kind, Separation};

use crate::error::{DataError, Problem};
use crate::fields::{field, flag, other, read_rows, time};

/// A query file whose ground truth is about a distance d: 1 if the primitives are at most d apart at some
/// time.
#[derive(Clone, Debug, PartialEq)]
pub struct SeparationFile {
    /// The query file, `KIND-FAMILY-dD.csv`.
    pub queries: PathBuf,
    /// The distance in its name.
    pub d: Separation,
}

impl SeparationFile {
    /// The file of this name, if it has queries of this kind.
    pub(crate) fn of_kind<K: Kind>(queries: PathBuf) -> Option<Self> {
        let stem = queries.file_name()?.to_str()?.strip_suffix(".csv")?;
        let (family, d) = stem
            .strip_prefix(K::KIND.short())?
            .strip_prefix('-')?
            .rsplit_once("-d")?;
        let d = Separation::new(d.parse().ok()?).ok()?;
        (!family.is_empty()).then_some(Self { queries, d })
    }

    /// The times within the distance of all queries whose ground truth is 1, in their order, from the file
    /// `….times.csv` beside the query file.
    ///
    /// # Errors
    /// If the file cannot be read or a row is not as expected.
    pub fn times(&self) -> Result<Vec<TimesWithin>, DataError> {
        read_rows(&self.queries.with_extension("times.csv"), times)
    }
}

/// The times at which the primitives of one query are at most a distance apart. All are rounded down to f64.
#[derive(Clone, Debug, PartialEq)]
pub struct TimesWithin {
    /// The index of the query in its file, from 0.
    pub query: usize,
    /// The number of maximal closed intervals of these times.
    pub count: usize,
    /// The first time.
    pub toi: f64,
    /// True if the first time is exactly an f64.
    pub toi_is_exact: bool,
    /// Start and end of each interval, in increasing order.
    pub intervals: Vec<[f64; 2]>,
}

fn times([query, count, toi, toi_is_exact, intervals]: [&str; 5]) -> Result<TimesWithin, Problem> {
    let interval = |text: &str| {
        let ends = text.split_once(':');
        let (start, end) = ends.ok_or_else(|| other(text, "intervals", "two times, as from:to"))?;
        Ok([time(start, "intervals")?, time(end, "intervals")?])
    };
    Ok(TimesWithin {
        query: field(query, "query", "an index")?,
        count: field(count, "count", "a number of intervals")?,
        toi: time(toi, "toi")?,
        toi_is_exact: flag(toi_is_exact, "toi_is_exact")?,
        intervals: intervals
            .split_whitespace()
            .map(interval)
            .collect::<Result<_, _>>()?,
    })
}

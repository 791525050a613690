//! Query files, rounded.

use std::path::Path;

use exact_ccd::{NonFinite, Query, Separation};
use exact_ccd_data::{DataKind, Record, Rounding, Seventh};
use exact_ccd_methods::parity::{Displacement, Rounded, RoundingError};
use rayon::prelude::*;

use super::arguments::Arguments;
use super::displacement::shared_displacement;
use super::report::Report;
use crate::messages::failure::Failure;
use crate::query_files::method::answered;
use crate::query_files::rows;

pub(super) fn round<K: DataKind>(arguments: &Arguments) -> Result<Report, Failure> {
    let inputs = arguments.inputs.iter();
    let mut files = inputs
        .map(|file| read::<K>(file))
        .collect::<Result<Vec<_>, _>>()?;
    let shared = if arguments.per_query {
        None
    } else {
        let records = files.iter().flatten();
        let points = records.flat_map(|record| record.sample.query.points().as_flattened());
        Some(shared_displacement(&points.copied().collect())?)
    };
    let mut report = Report::new(shared);
    for (file, records) in arguments.inputs.iter().zip(&mut files) {
        for (number, record) in records.iter_mut().enumerate() {
            let query = &mut record.sample.query;
            let displacement = shared.unwrap_or_else(|| Displacement::of_query(query));
            let rounded = shift(query, displacement).map_err(|source| rows::failed(file, number, source))?;
            report.add(displacement, query.points().as_flattened());
            *query = *rounded.query();
        }
    }
    if let Some(output) = &arguments.output {
        let mut records: Vec<_> = files.into_iter().flatten().collect();
        if arguments.roots {
            records = records
                .into_par_iter()
                .map(|record| answered(record, Separation::default()))
                .collect();
        }
        let seventh = rows::seventh(arguments.roots);
        rows::write(output, seventh, records.into_iter().map(Ok))?;
    }
    Ok(report)
}

/// The queries in a file without their answers, which are not those of the rounded queries.
fn read<K: DataKind>(file: &Path) -> Result<Vec<Record<K>>, Failure> {
    let records = rows::records(file, Rounding::Refuse, Seventh::Contact)?;
    let without_answers = |record: Result<Record<K>, _>| {
        let mut record = record?;
        (record.sample.truth, record.count, record.toi) = (None, None, None);
        Ok(record)
    };
    records.map(without_answers).collect()
}

/// The query, moved and rounded. Its corner differences are exact by construction; this is checked as well.
fn shift<K: DataKind>(query: &Query<K>, displacement: Displacement) -> Result<Rounded<K>, RoundingError> {
    let [t0, t1] = query
        .points()
        .map(|points| points.map(|point| displacement.apply(point)));
    let out_of_range = |NonFinite { axis, .. }| RoundingError::OutOfRange { axis };
    Rounded::check(Query::new(t0, t1).map_err(out_of_range)?)
}

//! Query files, rounded.

use std::path::Path;

use ccd_bench::{DataKind, Rounding, write_query};
use exact_ccd::parity::{Displacement, Rounded, RoundingError};
use exact_ccd::{Kind, NonFinite, Query};

use super::report::Report;
use super::{Arguments, shared_displacement};
use crate::failure::Failure;
use crate::output::write_file;
use crate::query_files;

pub(super) fn round<K: DataKind + 'static>(arguments: &Arguments) -> Result<Report, Failure> {
    let inputs = arguments.inputs.iter();
    let mut files = inputs
        .map(|file| read::<K>(file))
        .collect::<Result<Vec<_>, _>>()?;
    let shared = if arguments.per_query {
        None
    } else {
        let points = files
            .iter()
            .flatten()
            .flat_map(|query| query.points().as_flattened());
        Some(shared_displacement(&points.copied().collect())?)
    };
    let mut report = shared.map_or_else(Report::per_query, Report::shared);
    for (file, queries) in arguments.inputs.iter().zip(&mut files) {
        for (number, query) in queries.iter_mut().enumerate() {
            let displacement = shared.unwrap_or_else(|| Displacement::of_query(query));
            let rounded = shift(query, displacement)
                .map_err(|source| Failure::query(query_files::name(file), number, source))?;
            report.add(displacement, query.points().as_flattened());
            *query = *rounded.query();
        }
    }
    if let Some(output) = &arguments.output {
        let mut queries = files.iter().flatten();
        write_file(output, |writer| {
            queries.try_for_each(|query| write_query(writer, query))
        })?;
    }
    Ok(report)
}

fn read<K: DataKind + 'static>(file: &Path) -> Result<Vec<Query<K>>, Failure> {
    let queries = query_files::open::<K>(file, Rounding::Refuse)?.map(|sample| Ok(sample?.query));
    queries.collect()
}

/// The query, moved and rounded. That its corner differences are exact is checked, not only proved.
fn shift<K: Kind>(query: &Query<K>, displacement: Displacement) -> Result<Rounded<K>, RoundingError> {
    let [t0, t1] = query
        .points()
        .map(|points| points.map(|point| displacement.apply(point)));
    let out_of_range = |NonFinite { axis, .. }| RoundingError::OutOfRange { axis };
    Rounded::check(Query::new(t0, t1).map_err(out_of_range)?)
}

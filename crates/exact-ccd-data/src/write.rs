//! Query files out of queries.

use std::io::{self, Write};

use dashu_ratio::RBig;
use exact_ccd::{Kind, Point, Query};

use crate::query_points;
use crate::record::{Record, is_count};
use crate::rows::Seventh;

/// Writes a query file, in all rows with the seventh column or in none.
pub struct QueryWriter<W> {
    writer: W,
    seventh: Seventh,
    /// The number of queries that were written.
    queries: usize,
    /// True if the first query has a seventh column.
    has_seventh: bool,
}

impl<W: Write> QueryWriter<W> {
    /// Begins a file whose seventh column has this meaning.
    pub fn new(writer: W, seventh: Seventh) -> Self {
        Self {
            writer,
            seventh,
            queries: 0,
            has_seventh: false,
        }
    }

    /// Adds a query: its rows, as [`write_query`] writes them, with the ground truth or the
    /// count at the end of each. The other fields of the record are left out.
    ///
    /// # Errors
    /// The errors of the writer. If only some of the queries have a ground truth, or if a count is missing or
    /// below −1.
    pub fn write<K: Kind>(&mut self, record: &Record<K>) -> io::Result<()> {
        let value = match self.seventh {
            Seventh::Contact => record.sample.truth.map(i64::from),
            Seventh::Count => record.count,
        };
        if self.queries == 0 {
            self.has_seventh = value.is_some() || self.seventh == Seventh::Count;
        }
        if self.has_seventh != value.is_some() {
            return Err(self.mixed());
        }
        if let Some(count) = value.filter(|&count| !is_count(count)) {
            let query = self.queries;
            let message = format!("query {query} has {count} as number of contacts");
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        self.queries += 1;
        let ending = value.map_or(String::new(), |value| format!(",{value}"));
        write_rows(&mut self.writer, &record.sample.query, &ending)
    }

    /// Ends the file, and returns the writer.
    pub fn into_inner(self) -> W {
        self.writer
    }

    fn mixed(&self) -> io::Error {
        let query = self.queries;
        let message = match (self.seventh, self.has_seventh) {
            (Seventh::Count, _) => format!("query {query} has no number of contacts"),
            (Seventh::Contact, true) => format!("query {query} has no ground truth, but query 0 has"),
            (Seventh::Contact, false) => format!("query {query} has a ground truth, but query 0 has none"),
        };
        io::Error::new(io::ErrorKind::InvalidInput, message)
    }
}

/// Writes the rows of a query, without ground truth, as [`QueryReader`](crate::QueryReader) reads them.
///
/// Every coordinate is a fraction in lowest terms, which is exactly the `f64`; −0.0 becomes 0/1.
///
/// # Errors
/// The errors of the writer.
pub fn write_query<K: Kind>(writer: &mut impl Write, query: &Query<K>) -> io::Result<()> {
    write_rows(writer, query, "")
}

/// Writes the rows of a query, each with this ending.
fn write_rows<K: Kind>(writer: &mut impl Write, query: &Query<K>, ending: &str) -> io::Result<()> {
    query_points::points(query).try_for_each(|point| write_row(writer, point, ending))
}

fn write_row(writer: &mut impl Write, point: Point, ending: &str) -> io::Result<()> {
    let [x, y, z] = point.map(|x| RBig::try_from(x).expect("a query's coordinates are finite"));
    let row = [&x, &y, &z].map(|x| format!("{},{}", x.numerator(), x.denominator()));
    writeln!(writer, "{}{ending}", row.join(","))
}

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, Query, VertexEdge, VertexFace, VertexVertex};
    use proptest::prelude::*;

    use super::*;
    use crate::queries::QueryReader;
    use crate::rational::Rounding;

    fn text<K: Kind>(queries: &[Query<K>]) -> String {
        let mut bytes = Vec::new();
        for query in queries {
            write_query(&mut bytes, query).unwrap();
        }
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn fractions_are_in_lowest_terms_with_a_positive_denominator() {
        let mut points = [[[0.0; 3]; 4]; 2];
        points[0][0] = [-0.75, -0.0, 6.0];
        points[1][3] = [0.1, 2f64.powi(60), 5e-324];
        let written = text(&[Query::<VertexFace>::new(points[0], points[1]).unwrap()]);
        let lines: Vec<_> = written.lines().collect();
        assert_eq!(lines[0], "-3,4,0,1,6,1");
        assert_eq!(lines[1..7], ["0,1,0,1,0,1"; 6]);
        let least = format!("1,{}", dashu_int::UBig::ONE << 1074);
        assert_eq!(
            lines[7],
            format!("3602879701896397,36028797018963968,1152921504606846976,1,{least}")
        );
        assert_eq!(lines.len(), 8);
    }

    fn points() -> impl Strategy<Value = [Point; 8]> {
        let finite = prop::num::f64::ANY.prop_map(|x| if x.is_finite() { x } else { 0.0 });
        prop::array::uniform8(prop::array::uniform3(finite))
    }

    /// Of the eight points, each query has as many as its kind needs.
    fn assert_survive<K: Kind + PartialEq>(points: &[[Point; 8]]) {
        let queries: Vec<Query<K>> = points
            .iter()
            .map(|points| query_points::query(&points[..2 * K::KIND.point_names().len()]).unwrap())
            .collect();
        let read: Vec<_> = QueryReader::<K, _>::new("text", text(&queries).as_bytes(), Rounding::Refuse)
            .map(|record| record.unwrap().sample)
            .inspect(|sample| assert_eq!(sample.truth, None))
            .map(|sample| sample.query)
            .collect();
        assert_eq!(read, queries);
    }

    proptest! {
        #[test]
        fn every_query_reads_back(points in prop::collection::vec(points(), 0..4)) {
            assert_survive::<VertexFace>(&points);
            assert_survive::<EdgeEdge>(&points);
            assert_survive::<VertexEdge>(&points);
            assert_survive::<VertexVertex>(&points);
        }
    }
}

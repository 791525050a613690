//! Columns out of queries.

use std::io::{self, Write};
use std::sync::Arc;

use exact_ccd::Kind;
use exact_ccd_files::Budget;
use parquet::basic::{Compression, Encoding, GzipLevel};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::RowGroupMetaData;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::ColumnPath;

use super::row::is_time;
use super::{SCHEMA, coordinates};
use crate::query_points;
use crate::record::{Record, is_count};

/// The number of queries in a row group, except the last one. The writer keeps as many in memory.
const GROUP: usize = 1 << 16;

/// Writes queries as a Parquet file, row group by row group, so that a file of any size needs little memory.
///
/// Its columns are
/// - `kind`: `vf`, `ee`, `ve` or `vv`;
/// - `points`: a list of f64, which are x, y and z of the points at t = 0, then the same at t = 1, in the
///   order of the kind: 24 of [`VertexFace`](exact_ccd::VertexFace) and [`EdgeEdge`](exact_ccd::EdgeEdge),
///   18 of [`VertexEdge`](exact_ccd::VertexEdge), 12 of [`VertexVertex`](exact_ccd::VertexVertex);
/// - the fields of [`Record`], which can be null: `truth`, `count`, `toi`, `scene`, and the ids of
///   the pair, `id_a` and `id_b`.
///
/// Every f64 keeps its bits.
pub struct ColumnWriter<K: Kind, W: Write + Send> {
    file: SerializedFileWriter<W>,
    group: Vec<Record<K>>,
}

impl<K: Kind, W: Write + Send> ColumnWriter<K, W> {
    /// Begins a file.
    ///
    /// # Errors
    /// The errors of the writer.
    pub fn new(writer: W) -> io::Result<Self> {
        let schema = parse_message_type(SCHEMA).expect("the schema is well-formed");
        let file = SerializedFileWriter::new(writer, Arc::new(schema), Arc::new(properties::<K>()))
            .map_err(other)?;
        Ok(Self {
            file,
            group: Vec::new(),
        })
    }

    /// Adds a query.
    ///
    /// # Errors
    /// The errors of the writer, and if an id is too large for an i64, a count below −1, or a time of impact
    /// not in [0, 1].
    pub fn write(&mut self, record: Record<K>) -> io::Result<()> {
        let invalid = |message| Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        let is_large = |id: &u64| i64::try_from(*id).is_err();
        if let Some(id) = record.ids.and_then(|ids| ids.into_iter().find(is_large)) {
            return invalid(format!("the id {id} is out of the range of int64"));
        }
        if let Some(count) = record.count.filter(|&count| !is_count(count)) {
            return invalid(format!(
                "expected a number of contacts or -1 as count, found {count}"
            ));
        }
        if let Some(toi) = record.toi.filter(|&toi| !is_time(toi)) {
            return invalid(format!("expected a time from 0 to 1 as toi, found {toi}"));
        }
        self.group.push(record);
        if self.group.len() == GROUP {
            self.end_group()
        } else {
            Ok(())
        }
    }

    /// Ends the file, and returns the writer.
    ///
    /// # Errors
    /// The errors of the writer.
    pub fn finish(mut self) -> io::Result<W> {
        if !self.group.is_empty() {
            self.end_group()?;
        }
        self.pad()?;
        self.file.into_inner().map_err(other)
    }

    /// Adds zeros, which belong to no column, where queries repeat so often that a reader would refuse the
    /// file as too small for them.
    fn pad(&mut self) -> io::Result<()> {
        let groups = self.file.flushed_row_groups().iter();
        let rows: i64 = groups.map(RowGroupMetaData::num_rows).sum();
        let bytes = rows.unsigned_abs() * (coordinates::<K>() * size_of::<f64>()) as u64;
        let missing = (bytes / Budget::RATIO).saturating_sub(self.file.bytes_written() as u64);
        self.file.write_all(&vec![0; missing as usize])
    }

    fn end_group(&mut self) -> io::Result<()> {
        let mut group = self.file.next_row_group().map_err(other)?;
        write_group(&mut group, &self.group)
            .and_then(|()| group.close())
            .map_err(other)?;
        self.group.clear();
        Ok(())
    }
}

fn properties<K: Kind>() -> WriterProperties {
    let mut properties = WriterProperties::builder()
        .set_compression(Compression::GZIP(GzipLevel::default()))
        // Large enough for all coordinates of a row group.
        .set_dictionary_page_size_limit(GROUP * coordinates::<K>() * size_of::<f64>())
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for id in ["id_a", "id_b"].map(ColumnPath::from) {
        properties = properties
            .set_column_dictionary_enabled(id.clone(), false)
            .set_column_encoding(id, Encoding::DELTA_BINARY_PACKED);
    }
    properties
        .set_column_dictionary_enabled("toi".into(), false)
        .build()
}

/// The columns, in the order of the schema.
fn write_group<K: Kind, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    records: &[Record<K>],
) -> Result<(), ParquetError> {
    let kinds = vec![ByteArray::from(K::KIND.short()); records.len()];
    column::<ByteArrayType, _>(group, &kinds, None, None)?;

    let values: Vec<f64> = records
        .iter()
        .flat_map(|record| query_points::points(&record.sample.query))
        .flatten()
        .collect();
    // A list begins where the repetition level is 0.
    let repetition: Vec<i16> = (0..values.len())
        .map(|index| (index % coordinates::<K>() != 0).into())
        .collect();
    let definition = vec![1; values.len()];
    column::<DoubleType, _>(group, &values, Some(&definition), Some(&repetition))?;

    let scene = |record: &Record<K>| record.scene.as_deref().map(ByteArray::from);
    let id = |index: usize| move |record: &Record<K>| record.ids.map(|ids| ids[index] as i64);
    nullable::<BoolType, _, _>(group, records, |record| record.sample.truth)?;
    nullable::<Int64Type, _, _>(group, records, |record| record.count)?;
    nullable::<DoubleType, _, _>(group, records, |record| record.toi)?;
    nullable::<ByteArrayType, _, _>(group, records, scene)?;
    nullable::<Int64Type, _, _>(group, records, id(0))?;
    nullable::<Int64Type, _, _>(group, records, id(1))
}

pub(super) fn nullable<T: DataType, R, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    records: &[R],
    value: impl Fn(&R) -> Option<T::T>,
) -> Result<(), ParquetError> {
    let values: Vec<Option<T::T>> = records.iter().map(value).collect();
    let definition: Vec<i16> = values.iter().map(|value| value.is_some().into()).collect();
    let values: Vec<T::T> = values.into_iter().flatten().collect();
    column::<T, _>(group, &values, Some(&definition), None)
}

fn column<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[T::T],
    definition: Option<&[i16]>,
    repetition: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let mut column = group.next_column()?.expect("the schema has this column");
    column.typed::<T>().write_batch(values, definition, repetition)?;
    column.close()
}

pub(super) fn other(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast() {
            Ok(error) => *error,
            Err(source) => io::Error::other(source),
        },
        error => io::Error::other(error),
    }
}

//! Lists of contacts as Parquet files.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Compression, GzipLevel};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;

use super::cells::{COLUMNS, Cell, Type, row};
use super::record::ContactRecord;

/// The number of contacts in a row group, except the last one.
const GROUP: usize = 1 << 16;

/// Writes a row for each record.
pub(super) fn write(writer: impl Write + Send, records: &[ContactRecord]) -> io::Result<()> {
    let properties = WriterProperties::builder()
        .set_compression(Compression::GZIP(GzipLevel::default()))
        .build();
    let schema = parse_message_type(&schema()).expect("the schema is well-formed");
    let file = SerializedFileWriter::new(writer, Arc::new(schema), Arc::new(properties));
    let mut file = file.map_err(io::Error::other)?;
    for records in records.chunks(GROUP) {
        let mut group = file.next_row_group().map_err(io::Error::other)?;
        write_group(&mut group, records)
            .and_then(|()| group.close())
            .map_err(io::Error::other)?;
    }
    file.into_inner().map(|_| ()).map_err(io::Error::other)
}

fn schema() -> String {
    let columns = COLUMNS.map(|(name, kind)| match kind {
        Type::Text => format!("required binary {name} (STRING);"),
        Type::Integer => format!("optional int64 {name};"),
        Type::Real => format!("optional double {name};"),
    });
    format!("message contacts {{ {} }}", columns.concat())
}

fn write_group<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    records: &[ContactRecord],
) -> Result<(), ParquetError> {
    let rows: Vec<[Cell; COLUMNS.len()]> = records.iter().map(row).collect();
    for (index, (_, kind)) in COLUMNS.into_iter().enumerate() {
        let cells = rows.iter().map(|row| &row[index]);
        match kind {
            Type::Text => {
                let text = |cell: &Cell| match cell {
                    Cell::Text(text) => ByteArray::from(*text),
                    Cell::Integer(_) | Cell::Real(_) => ByteArray::from(""),
                };
                column::<ByteArrayType, _>(group, &cells.map(text).collect::<Vec<_>>(), None)?;
            }
            Type::Integer => {
                let integer = |cell: &Cell| {
                    if let Cell::Integer(value) = cell {
                        *value
                    } else {
                        None
                    }
                };
                optional::<Int64Type, _>(group, cells.map(integer))?;
            }
            Type::Real => {
                let real = |cell: &Cell| {
                    if let Cell::Real(value) = cell {
                        *value
                    } else {
                        None
                    }
                };
                optional::<DoubleType, _>(group, cells.map(real))?;
            }
        }
    }
    Ok(())
}

fn optional<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    cells: impl Iterator<Item = Option<T::T>> + Clone,
) -> Result<(), ParquetError> {
    let definition: Vec<i16> = cells.clone().map(|cell| cell.is_some().into()).collect();
    let values: Vec<T::T> = cells.flatten().collect();
    column::<T, _>(group, &values, Some(&definition))
}

fn column<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[T::T],
    definition: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let mut column = group.next_column()?.expect("the schema has this column");
    column.typed::<T>().write_batch(values, definition, None)?;
    column.close()
}

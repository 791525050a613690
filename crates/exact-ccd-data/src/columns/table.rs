//! Other tables than queries, as Parquet files.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Compression, GzipLevel};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;

use super::write::{nullable, other};

/// The values of a column of a table, one for each row. Absent ones are null.
pub enum TableColumn<'a> {
    /// Strings.
    Text(Vec<Option<&'a str>>),
    /// Integers of 64 bits.
    Integers(Vec<Option<i64>>),
    /// Numbers of 64 bits, bit for bit.
    Reals(Vec<Option<f64>>),
}

/// Writes a table of columns, each with its name, as a Parquet file.
///
/// # Errors
/// The errors of the writer, and if the columns do not have the same number of values.
///
/// # Panics
/// If a name is no identifier.
pub fn write_table<W: Write + Send>(writer: W, columns: &[(&str, TableColumn<'_>)]) -> io::Result<()> {
    let field = |(name, column): &(&str, TableColumn<'_>)| match column {
        TableColumn::Text(_) => format!("optional binary {name} (STRING);"),
        TableColumn::Integers(_) => format!("optional int64 {name};"),
        TableColumn::Reals(_) => format!("optional double {name};"),
    };
    let schema = format!(
        "message table {{ {} }}",
        columns.iter().map(field).collect::<String>()
    );
    let schema = parse_message_type(&schema).expect("the names are identifiers");
    let gzip = Compression::GZIP(GzipLevel::default());
    let properties = WriterProperties::builder().set_compression(gzip).build();
    let file = SerializedFileWriter::new(writer, Arc::new(schema), Arc::new(properties));
    let mut file = file.map_err(other)?;
    let mut group = file.next_row_group().map_err(other)?;
    for (_, column) in columns {
        match column {
            TableColumn::Text(texts) => {
                nullable::<ByteArrayType, _, _>(&mut group, texts, |text| text.map(ByteArray::from))
            }
            TableColumn::Integers(integers) => nullable::<Int64Type, _, _>(&mut group, integers, |x| *x),
            TableColumn::Reals(reals) => nullable::<DoubleType, _, _>(&mut group, reals, |x| *x),
        }
        .map_err(other)?;
    }
    group.close().map_err(other)?;
    file.into_inner().map(|_| ()).map_err(other)
}

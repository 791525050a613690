//! One column of a row group.

use std::sync::Arc;

use parquet::basic::Compression;
use parquet::column::reader::ColumnReaderImpl;
use parquet::data_type::DataType;
use parquet::file::metadata::RowGroupMetaData;
use parquet::file::serialized_reader::SerializedPageReader;
use parquet::schema::types::ColumnDescriptor;

use super::counted_file::CountedFile;
use super::guard::{GuardedPages, catch};
use super::problem::ColumnProblem;

/// The place and the name of a column.
#[derive(Clone, Copy)]
pub(super) struct Leaf {
    pub(super) index: usize,
    name: &'static str,
}

impl Leaf {
    /// The column of this name among all columns, of this type in words.
    pub(super) fn find<T: DataType>(
        columns: &[Arc<ColumnDescriptor>],
        name: &'static str,
        expected: &'static str,
    ) -> Result<Self, ColumnProblem> {
        let problem = |found: String| ColumnProblem::Column {
            column: name,
            expected,
            found,
        };
        let places = 0..columns.len();
        let named: Vec<usize> = places
            .filter(|&place| columns[place].path().parts()[0] == name)
            .collect();
        let Some(&index) = named.first() else {
            return Err(problem("none".into()));
        };
        let column = &columns[index];
        let depth = usize::from(column.max_rep_level() > 0);
        let is_alone = named.len() == 1;
        if column.physical_type() != T::get_physical_type()
            || column.max_rep_level() > 1
            || (depth == 1) != expected.starts_with("lists of ")
            || !is_alone
        {
            let list = ["", "lists of "][depth];
            let found = if is_alone {
                format!("{list}{}", column.physical_type())
            } else {
                "a group of columns".into()
            };
            return Err(problem(found));
        }
        Ok(Self { index, name })
    }
}

/// The rest of the values of a column in a row group.
pub(super) struct Column<T: DataType> {
    reader: ColumnReaderImpl<T>,
    name: &'static str,
    max_definition: i16,
}

impl<T: DataType> Column<T> {
    /// The column of a row group with this number of rows and at most this number of values in each.
    pub(super) fn open(
        file: &Arc<CountedFile>,
        group: &RowGroupMetaData,
        leaf: Leaf,
        rows: usize,
        values: usize,
    ) -> Result<Self, ColumnProblem> {
        let chunk = group.column(leaf.index);
        match chunk.compression() {
            Compression::UNCOMPRESSED | Compression::GZIP(_) | Compression::SNAPPY => {}
            other => return Err(ColumnProblem::Compression(other.to_string())),
        }
        if !file.holds(chunk) {
            return Err(ColumnProblem::parquet("a column is not within the file"));
        }
        let pages = catch(|| SerializedPageReader::new(file.clone(), chunk, rows, None))?;
        let descriptor = chunk.column_descr_ptr();
        Ok(Self {
            max_definition: descriptor.max_def_level(),
            reader: ColumnReaderImpl::new(
                descriptor,
                Box::new(GuardedPages::new((**file).clone(), pages, rows * values)),
            ),
            name: leaf.name,
        })
    }

    /// The values in the next rows.
    pub(super) fn values(&mut self, rows: usize) -> Result<Vec<Option<T::T>>, ColumnProblem> {
        let (definition, _, values) = self.levels(rows)?;
        let mut values = values.into_iter();
        if self.max_definition == 0 {
            return Ok(values.map(Some).collect());
        }
        let value = |level| (level == self.max_definition).then(|| values.next()).flatten();
        Ok(definition.into_iter().map(value).collect())
    }

    /// Levels of definition and of repetition, and values.
    #[expect(clippy::type_complexity, reason = "three lists, used once each")]
    fn levels(&mut self, rows: usize) -> Result<(Vec<i16>, Vec<i16>, Vec<T::T>), ColumnProblem> {
        let (mut definition, mut repetition, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let mut read = 0;
        while read < rows {
            let (records, ..) = catch(|| {
                let (definition, repetition) = (Some(&mut definition), Some(&mut repetition));
                self.reader
                    .read_records(rows - read, definition, repetition, &mut values)
            })?;
            if records == 0 {
                let problem = format!("column {} is cut short", self.name);
                return Err(ColumnProblem::parquet(problem));
            }
            read += records;
        }
        Ok((definition, repetition, values))
    }

    /// Checks that there is nothing left to read.
    pub(super) fn end(&mut self) -> Result<(), ColumnProblem> {
        let (mut definition, mut repetition, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let (records, ..) = catch(|| {
            let (definition, repetition) = (Some(&mut definition), Some(&mut repetition));
            self.reader.read_records(1, definition, repetition, &mut values)
        })?;
        if records > 0 {
            let problem = format!("column {} has too many values", self.name);
            return Err(ColumnProblem::parquet(problem));
        }
        Ok(())
    }
}

impl<T: DataType<T = f64>> Column<T> {
    /// The lists in the next rows. `None` is a null, or a list with a null in it.
    pub(super) fn lists(&mut self, rows: usize) -> Result<Vec<Option<Vec<f64>>>, ColumnProblem> {
        let (definition, repetition, values) = self.levels(rows)?;
        let starts = (0..repetition.len()).filter(|&index| repetition[index] == 0);
        let ends = starts.clone().skip(1).chain([repetition.len()]);
        let mut values = values.into_iter();
        let list = |(start, end): (usize, usize)| {
            let is_value = |level: &&i16| **level == self.max_definition;
            let present = definition[start..end].iter().filter(is_value).count();
            let list: Vec<f64> = values.by_ref().take(present).collect();
            (present == end - start).then_some(list)
        };
        Ok(starts.zip(ends).map(list).collect())
    }
}

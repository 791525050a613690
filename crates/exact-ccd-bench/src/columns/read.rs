//! Queries out of columns.

use std::fs::File;
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::vec;

use exact_ccd::Query;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader, RowGroupMetaData};

use super::COORDINATES;
use super::guard::{GuardedFile, catch};
use super::leaf::{Column, Expected, Leaf};
use crate::error::{ColumnProblem, DataError, RecordProblem};
use crate::excerpt::excerpt;
use crate::kind::DataKind;
use crate::queries::Sample;
use crate::record::Record;

/// How many queries are read at once.
const BATCH: usize = 1024;

/// How many rows a row group may have; usual writers make them smaller.
const GROUP: usize = 1 << 20;

/// Reads the queries of a Parquet file one after the other. It ends after the first error.
///
/// The columns are those that [`ColumnWriter`](crate::ColumnWriter) tells, by name, in any order, and other software may
/// have written them; further columns are skipped. Columns are plain or compressed with gzip or snappy.
pub struct ColumnReader<K> {
    path: PathBuf,
    file: Arc<GuardedFile>,
    metadata: ParquetMetaData,
    leaves: Leaves,
    /// The number of the row group to be opened next.
    next_group: usize,
    group: Option<Group>,
    batch: vec::IntoIter<Record<K>>,
    /// How many queries were read.
    queries: usize,
    done: bool,
    kind: PhantomData<K>,
}

/// Where the columns are.
struct Leaves {
    kind: Leaf,
    points: Leaf,
    truth: Leaf,
    count: Leaf,
    toi: Leaf,
    scene: Leaf,
    ids: [Leaf; 2],
}

/// The columns of a row group.
struct Group {
    rows_left: usize,
    kind: Column<ByteArrayType>,
    points: Column<DoubleType>,
    truth: Column<BoolType>,
    count: Column<Int64Type>,
    toi: Column<DoubleType>,
    scene: Column<ByteArrayType>,
    ids: [Column<Int64Type>; 2],
}

impl<K: DataKind> ColumnReader<K> {
    /// A reader of the queries in a file.
    ///
    /// # Errors
    /// If the file cannot be opened, is no Parquet file, or has not the right columns.
    pub fn open(path: &Path) -> Result<Self, DataError> {
        let file = File::open(path).map_err(|source| DataError::io(path, source))?;
        let file = Arc::new(GuardedFile(file));
        let metadata = catch(|| ParquetMetaDataReader::new().parse_and_finish(&*file))
            .map_err(|error| DataError::columns(path, ColumnProblem::from(error)))?;
        let leaves = Leaves::find(&metadata).map_err(|problem| DataError::columns(path, problem))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            metadata,
            leaves,
            next_group: 0,
            group: None,
            batch: Vec::new().into_iter(),
            queries: 0,
            done: false,
            kind: PhantomData,
        })
    }

    /// The queries with all that the file says of them.
    pub fn records(mut self) -> impl Iterator<Item = Result<Record<K>, DataError>> {
        std::iter::from_fn(move || self.next_record())
    }

    fn next_record(&mut self) -> Option<Result<Record<K>, DataError>> {
        if let Some(record) = self.batch.next() {
            return Some(Ok(record));
        }
        if self.done {
            return None;
        }
        match self.read_batch() {
            Ok(batch) => {
                self.batch = batch.into_iter();
                let next = self.batch.next();
                self.done = next.is_none();
                next.map(Ok)
            }
            Err(error) => {
                self.done = true;
                Some(Err(error))
            }
        }
    }

    /// The next queries, none if there are no more.
    fn read_batch(&mut self) -> Result<Vec<Record<K>>, DataError> {
        let wrong = |problem| DataError::columns(&self.path, problem);
        loop {
            let Some(group) = &mut self.group else {
                let Some(metadata) = self.metadata.row_groups().get(self.next_group) else {
                    return match usize::try_from(self.metadata.file_metadata().num_rows()) {
                        Ok(rows) if rows == self.queries => Ok(Vec::new()),
                        _ => Err(wrong(ColumnProblem::parquet(
                            "the number of rows is not that announced",
                        ))),
                    };
                };
                self.group = Some(Group::open(&self.file, metadata, &self.leaves).map_err(wrong)?);
                self.next_group += 1;
                continue;
            };
            if group.rows_left == 0 {
                group.end().map_err(wrong)?;
                self.group = None;
                continue;
            }
            let rows = group.rows_left.min(BATCH);
            group.rows_left -= rows;
            let rows = group.read(rows).map_err(wrong)?;
            let first = self.queries;
            self.queries += rows.len();
            return rows
                .into_iter()
                .enumerate()
                .map(|(index, row)| {
                    row.record().map_err(|problem| DataError::Record {
                        file: self.path.clone(),
                        query: first + index,
                        problem,
                    })
                })
                .collect();
        }
    }
}

impl<K: DataKind> Iterator for ColumnReader<K> {
    type Item = Result<Sample<K>, DataError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_record()
            .map(|record| record.map(|record| record.sample))
    }
}

impl Leaves {
    fn find(metadata: &ParquetMetaData) -> Result<Self, ColumnProblem> {
        let columns = metadata.file_metadata().schema_descr().columns();
        let expected = |name, type_name, is_list| Expected {
            name,
            type_name,
            is_list,
        };
        let text = |name| Leaf::find::<ByteArrayType>(columns, &expected(name, "strings", false));
        let double = |name| Leaf::find::<DoubleType>(columns, &expected(name, "DOUBLE", false));
        let integer = |name| Leaf::find::<Int64Type>(columns, &expected(name, "INT64", false));
        Ok(Self {
            kind: text("kind")?,
            points: Leaf::find::<DoubleType>(columns, &expected("points", "lists of 24 DOUBLE", true))?,
            truth: Leaf::find::<BoolType>(columns, &expected("truth", "BOOLEAN", false))?,
            count: integer("count")?,
            toi: double("toi")?,
            scene: text("scene")?,
            ids: [integer("id_a")?, integer("id_b")?],
        })
    }
}

impl Group {
    fn open(
        file: &Arc<GuardedFile>,
        group: &RowGroupMetaData,
        leaves: &Leaves,
    ) -> Result<Self, ColumnProblem> {
        let rows = usize::try_from(group.num_rows())
            .ok()
            .filter(|&rows| rows <= GROUP);
        let Some(rows) = rows else {
            let rows = group.num_rows();
            let problem = format!("a row group of {rows} rows, which is not from 0 to {GROUP}");
            return Err(ColumnProblem::parquet(problem));
        };
        let integer = |leaf| Column::open(file, group, leaf, rows, 1);
        Ok(Self {
            rows_left: rows,
            kind: Column::open(file, group, leaves.kind, rows, 1)?,
            // Lists of another length, if not far from it, are told with the query.
            points: Column::open(file, group, leaves.points, rows, 2 * COORDINATES)?,
            truth: Column::open(file, group, leaves.truth, rows, 1)?,
            count: integer(leaves.count)?,
            toi: Column::open(file, group, leaves.toi, rows, 1)?,
            scene: Column::open(file, group, leaves.scene, rows, 1)?,
            ids: [integer(leaves.ids[0])?, integer(leaves.ids[1])?],
        })
    }

    fn read(&mut self, rows: usize) -> Result<Vec<Row>, ColumnProblem> {
        let kinds = self.kind.values(rows)?;
        let mut points = self.points.lists(rows)?.into_iter();
        let mut truths = self.truth.values(rows)?.into_iter();
        let mut counts = self.count.values(rows)?.into_iter();
        let mut tois = self.toi.values(rows)?.into_iter();
        let mut scenes = self.scene.values(rows)?.into_iter();
        let mut ids_a = self.ids[0].values(rows)?.into_iter();
        let mut ids_b = self.ids[1].values(rows)?.into_iter();
        let row = |kind| Row {
            kind,
            points: points.next().flatten(),
            truth: truths.next().flatten(),
            count: counts.next().flatten(),
            toi: tois.next().flatten(),
            scene: scenes.next().flatten(),
            ids: [ids_a.next().flatten(), ids_b.next().flatten()],
        };
        Ok(kinds.into_iter().map(row).collect())
    }

    fn end(&mut self) -> Result<(), ColumnProblem> {
        let [a, b] = &mut self.ids;
        self.kind
            .end()
            .and_then(|()| self.points.end())
            .and_then(|()| self.truth.end())
            .and_then(|()| self.count.end())
            .and_then(|()| self.toi.end())
            .and_then(|()| self.scene.end())
            .and_then(|()| a.end())
            .and_then(|()| b.end())
    }
}

/// A row as it stands in the file. `None` is a null, or a list of coordinates of another length.
struct Row {
    kind: Option<ByteArray>,
    points: Option<[f64; COORDINATES]>,
    truth: Option<bool>,
    count: Option<i64>,
    toi: Option<f64>,
    scene: Option<ByteArray>,
    ids: [Option<i64>; 2],
}

impl Row {
    fn record<K: DataKind>(self) -> Result<Record<K>, RecordProblem> {
        let kind = self.kind.as_ref().map(ByteArray::data);
        if kind != Some(K::SHORT.as_bytes()) {
            let found = kind.map_or("null".into(), excerpt);
            return Err(RecordProblem::field("kind", K::SHORT, found));
        }
        let Some(coordinates) = self.points else {
            let found = "null or another number";
            return Err(RecordProblem::field("points", "24 coordinates", found));
        };
        let (points, _) = coordinates.as_chunks::<3>();
        let (times, _) = points.as_chunks::<4>();
        let count_is_wrong = |count: &i64| *count < -1;
        if let Some(count) = self.count.filter(count_is_wrong) {
            return Err(RecordProblem::field("count", "a number of contacts or -1", count));
        }
        if let Some(toi) = self.toi.filter(|toi| !(0.0..=1.0).contains(toi)) {
            return Err(RecordProblem::field("toi", "a time from 0 to 1", toi));
        }
        let scene = self.scene.as_ref().map(|name| {
            let text = str::from_utf8(name.data());
            text.map_err(|_| RecordProblem::field("scene", "UTF-8", excerpt(name.data())))
        });
        let ids = match self.ids {
            [None, None] => None,
            [Some(a @ 0..), Some(b @ 0..)] => Some([a, b].map(i64::unsigned_abs)),
            ids => {
                let found = ids.map(|id| id.map_or("null".to_owned(), |id| id.to_string()));
                let expected = "two ids of 0 or more, or none";
                return Err(RecordProblem::field(
                    "id_a and id_b",
                    expected,
                    found.join(" and "),
                ));
            }
        };
        Ok(Record {
            sample: Sample {
                query: Query::new(times[0], times[1])?,
                truth: self.truth,
            },
            count: self.count,
            toi: self.toi,
            scene: scene.transpose()?.map(Arc::from),
            ids,
        })
    }
}

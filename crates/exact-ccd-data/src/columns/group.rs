//! The columns of a row group.

use std::sync::Arc;

use parquet::data_type::{BoolType, ByteArrayType, DoubleType, Int64Type};
use parquet::file::metadata::{ParquetMetaData, RowGroupMetaData};

use super::counted_file::CountedFile;
use super::leaf::{Column, Leaf};
use super::problem::ColumnProblem;
use super::row::Row;

/// The largest number of rows of a row group; usual writers make smaller ones.
const GROUP: usize = 1 << 20;

/// The places of the columns.
pub(super) struct Leaves {
    kind: Leaf,
    points: Leaf,
    truth: Leaf,
    count: Leaf,
    toi: Leaf,
    scene: Leaf,
    ids: [Leaf; 2],
}

/// The columns of a row group.
pub(super) struct Group {
    pub(super) rows_left: usize,
    kind: Column<ByteArrayType>,
    points: Column<DoubleType>,
    truth: Column<BoolType>,
    count: Column<Int64Type>,
    toi: Column<DoubleType>,
    scene: Column<ByteArrayType>,
    ids: [Column<Int64Type>; 2],
}

impl Leaves {
    pub(super) fn find(metadata: &ParquetMetaData) -> Result<Self, ColumnProblem> {
        let columns = metadata.file_metadata().schema_descr().columns();
        let text = |name| Leaf::find::<ByteArrayType>(columns, name, "strings");
        let double = |name| Leaf::find::<DoubleType>(columns, name, "DOUBLE");
        let integer = |name| Leaf::find::<Int64Type>(columns, name, "INT64");
        Ok(Self {
            kind: text("kind")?,
            points: Leaf::find::<DoubleType>(columns, "points", "lists of DOUBLE")?,
            truth: Leaf::find::<BoolType>(columns, "truth", "BOOLEAN")?,
            count: integer("count")?,
            toi: double("toi")?,
            scene: text("scene")?,
            ids: [integer("id_a")?, integer("id_b")?],
        })
    }
}

impl Group {
    /// The columns of a row group of queries with this number of coordinates.
    pub(super) fn open(
        file: &Arc<CountedFile>,
        group: &RowGroupMetaData,
        leaves: &Leaves,
        coordinates: usize,
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
            // Twice the length: a list of a slightly wrong length is an error of its query, not of the file.
            points: Column::open(file, group, leaves.points, rows, 2 * coordinates)?,
            truth: Column::open(file, group, leaves.truth, rows, 1)?,
            count: integer(leaves.count)?,
            toi: Column::open(file, group, leaves.toi, rows, 1)?,
            scene: Column::open(file, group, leaves.scene, rows, 1)?,
            ids: [integer(leaves.ids[0])?, integer(leaves.ids[1])?],
        })
    }

    pub(super) fn read(&mut self, rows: usize) -> Result<Vec<Row>, ColumnProblem> {
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

    pub(super) fn end(&mut self) -> Result<(), ColumnProblem> {
        let [a, b] = &mut self.ids;
        self.kind.end()?;
        self.points.end()?;
        self.truth.end()?;
        self.count.end()?;
        self.toi.end()?;
        self.scene.end()?;
        a.end()?;
        b.end()
    }
}

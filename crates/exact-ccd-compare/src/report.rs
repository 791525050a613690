//! The tables of a comparison as Markdown, CSV and JSON, and its plots.

use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};

use serde::Serialize;

use crate::charts;
use crate::contestant::Contestant;
use crate::peer::Peer;
use crate::setting::Setting;
use crate::table::{Row, Sizes, Table};

/// The results of a comparison.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct Report {
    /// The machine and the build.
    pub setting: Setting,
    /// Remarks, a sentence each.
    pub notes: Vec<String>,
    /// A table for each data set and kind of query.
    pub tables: Vec<Table>,
}

impl Report {
    /// A report without tables, with a note on each peer.
    #[must_use]
    pub fn new(contestants: &[Contestant]) -> Self {
        let peers = contestants.iter().filter_map(|contestant| match contestant {
            Contestant::Method(_) => None,
            Contestant::Peer(peer) => Some(peer),
        });
        Self {
            setting: Setting::here(),
            notes: peers.map(note).collect(),
            tables: Vec::new(),
        }
    }

    /// Writes `report.md`, `report.csv`, `report.json`, and for each table `tails-….svg` and
    /// `accuracy-….svg`, into a folder, which is created if it does not exist. The files of an
    /// earlier report are replaced.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        fs::create_dir_all(folder)?;
        let json = serde_json::to_string_pretty(self)?;
        for (name, text) in [
            ("report.md", self.markdown()),
            ("report.csv", self.csv()?),
            ("report.json", json + "\n"),
        ] {
            replace(&folder.join(name), &text)?;
        }
        for table in &self.tables {
            let name = file_name(table);
            replace(&folder.join(format!("tails-{name}.svg")), &charts::tails(table))?;
            replace(
                &folder.join(format!("accuracy-{name}.svg")),
                &charts::accuracy(table),
            )?;
        }
        Ok(())
    }

    /// The setting, the notes, and all tables.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut text = format!("{}.\n\n", self.setting);
        text += "Times in µs: T is the mean over all queries, TP over queries that collide, TN over the others. \
                 FP and FN are wrong answers among those given. t is the error of the times of impact, in time steps.\n\n";
        for note in &self.notes {
            text += note;
            text += "\n\n";
        }
        for table in &self.tables {
            text += &table.markdown();
            text += "\n";
        }
        text
    }

    fn csv(&self) -> io::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(COLUMNS.map(|(name, _)| name))?;
        for table in &self.tables {
            for row in &table.rows {
                writer.write_record(COLUMNS.map(|(_, value)| value(table, row)))?;
            }
        }
        let bytes = writer
            .into_inner()
            .map_err(|error| io::Error::other(error.to_string()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

fn note(peer: &Peer) -> String {
    let (name, microseconds) = (peer.name(), peer.call_nanoseconds() / 1e3);
    format!("{name} runs in another process; each of its times includes {microseconds:.2} µs for the call.")
}

/// A column of the CSV file: its name, and its value in the row of a table.
type Column = (&'static str, fn(&Table, &Row) -> String);

const COLUMNS: [Column; 18] = [
    ("data_set", |table, _| table.data_set.clone()),
    ("kind", |table, _| table.kind.to_owned()),
    ("queries", |table, _| table.queries.to_string()),
    ("colliding", |table, _| table.colliding.to_string()),
    ("method", |_, row| row.method.clone()),
    ("answered_colliding", |_, row| row.answered.colliding.to_string()),
    ("answered_free", |_, row| row.answered.free.to_string()),
    ("mean_us", |_, row| decimal(row.mean)),
    ("mean_colliding_us", |_, row| decimal(row.mean_colliding)),
    ("mean_free_us", |_, row| decimal(row.mean_free)),
    ("median_us", |_, row| decimal(row.median)),
    ("percentile_99_us", |_, row| decimal(row.percentile_99)),
    ("worst_us", |_, row| decimal(row.worst)),
    ("false_positives", |_, row| row.false_positives.to_string()),
    ("false_negatives", |_, row| row.false_negatives.to_string()),
    ("time_error_median", |_, row| {
        text(row.time_error.map(|error| error.median))
    }),
    ("time_error_worst", |_, row| {
        text(row.time_error.map(|error| error.worst))
    }),
    ("late", |_, row| text(row.time_error.map(|error| error.late))),
];

/// A time with three decimals; empty if there is none.
fn decimal(time: Option<f64>) -> String {
    text(time.map(|time| format!("{time:.3}")))
}

fn text(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

impl Table {
    pub(super) fn kind_in_words(&self) -> &'static str {
        match self.kind {
            "vf" => "vertex-face",
            _ => "edge-edge",
        }
    }

    /// A table under a heading.
    #[must_use]
    pub fn markdown(&self) -> String {
        let kind = self.kind_in_words();
        let Sizes { colliding, free } = self.sample;
        let mut text = format!(
            "### {}, {kind}\n\n{} queries, {} in contact",
            self.data_set, self.queries, self.colliding
        );
        if colliding + free < self.queries {
            let _ = write!(
                text,
                "; the methods answer a random sample of {}, {colliding} of them in contact",
                colliding + free
            );
        }
        text += ".\n\n| method | answered | T | TP | TN | 99 % | worst | FP | FN | t: median | worst | late |\n\
             |---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
        for row in &self.rows {
            text += &markdown_row(row, self.sample);
        }
        text
    }
}

fn markdown_row(row: &Row, sample: Sizes) -> String {
    let (answered, about) = if row.answered == sample {
        ("all".to_owned(), "")
    } else {
        let Sizes { colliding, free } = row.answered;
        (format!("{colliding} + {free}"), "≈ ")
    };
    let [mean, colliding, free, tail, worst] = [
        row.mean,
        row.mean_colliding,
        row.mean_free,
        row.percentile_99,
        row.worst,
    ]
    .map(microseconds);
    let error = row.time_error.map_or(" |  | ".to_owned(), |error| {
        let [median, worst] = [error.median, error.worst].map(power);
        format!("{median} | {worst} | {}", error.late)
    });
    format!(
        "| {} | {answered} | {about}{mean} | {about}{colliding} | {about}{free} | {tail} | {worst} | {} | {} | {error} |\n",
        row.method.replace('|', "\\|"),
        row.false_positives,
        row.false_negatives,
    )
}

/// A time with three significant digits, but no more than two decimals.
fn microseconds(time: Option<f64>) -> String {
    time.map_or("–".to_owned(), |time| match time {
        ..10.0 => format!("{time:.2}"),
        10.0..100.0 => format!("{time:.1}"),
        100.0..1000.0 => format!("{time:.0}"),
        _ => {
            let unit = 10f64.powi(time.log10().floor() as i32 - 2);
            format!("{:.0}", (time / unit).round() * unit)
        }
    })
}

fn power(error: f64) -> String {
    if error == 0.0 {
        "0".to_owned()
    } else {
        format!("{error:.1e}")
    }
}

fn file_name(table: &Table) -> String {
    let words: Vec<_> = table
        .data_set
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .collect();
    format!("{}-{}", words.join("-"), table.kind)
}

/// Replaces a file at once: if the program stops, the file is the old one or the new one.
fn replace(file: &Path, text: &str) -> io::Result<()> {
    let mut part = file.as_os_str().to_owned();
    part.push(".part");
    fs::write(&part, text)?;
    fs::rename(&part, file)
}

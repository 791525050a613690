//! The answers to queries, in rows of CSV or as JSON lines.

use std::io::{self, Write};

use serde::Serialize;

use crate::query_files::method::{Answer, Count};
use crate::text::json::to_json;

/// A writer of answers.
pub(crate) struct AnswerRows<W> {
    output: W,
    json: bool,
}

/// An answer, in the shape of the JSON object.
#[derive(Serialize)]
struct Row {
    query: usize,
    contact: bool,
    count: Option<Count>,
    toi: Option<f64>,
}

impl<W: Write> AnswerRows<W> {
    /// Writes the header of CSV.
    pub(crate) fn new(mut output: W, json: bool) -> io::Result<Self> {
        if !json {
            writeln!(output, "query,contact,count,toi")?;
        }
        Ok(Self { output, json })
    }

    /// Writes the answer to a query.
    pub(crate) fn write(&mut self, query: usize, answer: &Answer) -> io::Result<()> {
        if !self.json {
            return writeln!(self.output, "{query},{answer}");
        }
        let row = Row {
            query,
            contact: answer.collides,
            count: answer.count,
            toi: answer.toi,
        };
        writeln!(self.output, "{}", to_json("queries", &row))
    }
}

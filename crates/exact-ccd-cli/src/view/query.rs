//! The page of one of many queries.

use std::path::{Path, PathBuf};

use exact_ccd::{Kind, Query, Separation};
use exact_ccd_view::Page;

use crate::files::inputs::name;
use crate::files::outputs::page;
use crate::messages::failure::Failure;

/// The options `--view` and `--view-query`.
#[derive(clap::Args)]
pub(crate) struct QueryView {
    /// Write an HTML file that shows a query and its exact answer in a browser. It contains all it needs.
    #[arg(long, value_name = "FILE.html", value_parser = page())]
    view: Option<PathBuf>,
    /// The number of the query to show, from 0 over all files [default: the first one in contact, or 0]
    #[arg(long, value_name = "N", requires = "view")]
    view_query: Option<usize>,
}

/// The query of a page, chosen as the queries come, if there is to be a page.
pub(crate) struct ChosenQuery<K: Kind> {
    file: Option<PathBuf>,
    number: Option<usize>,
    chosen: Option<Chosen<K>>,
}

struct Chosen<K: Kind> {
    title: String,
    query: Query<K>,
    collides: bool,
}

impl QueryView {
    /// Returns true if there is to be a page.
    pub(crate) fn is_asked_for(&self) -> bool {
        self.view.is_some()
    }

    /// The choice, before the first query.
    pub(crate) fn choice<K: Kind>(&self) -> ChosenQuery<K> {
        ChosenQuery {
            file: self.view.clone(),
            number: self.view_query,
            chosen: None,
        }
    }
}

impl<K: Kind> ChosenQuery<K> {
    /// The next query, with its number over all files and its answer.
    pub(crate) fn see(&mut self, file: &Path, number: usize, query: &Query<K>, collides: bool) {
        let is_better = match (self.number, &self.chosen) {
            (Some(chosen), _) => chosen == number,
            (None, None) => true,
            (None, Some(chosen)) => collides && !chosen.collides,
        };
        if self.file.is_some() && is_better {
            self.chosen = Some(Chosen {
                title: format!("Query {number} in {}", name(file)),
                query: *query,
                collides,
            });
        }
    }

    /// Writes the page. Primitives at most `separation` apart count as touching.
    pub(crate) fn finish(self, separation: Separation) -> Result<(), Failure> {
        let Some(file) = &self.file else { return Ok(()) };
        let Some(Chosen { title, query, .. }) = self.chosen else {
            let number = self.number.unwrap_or_default();
            return Err(Failure::new(format_args!(
                "there is no query {number} to show: expected a number from 0 below that of the queries"
            )));
        };
        super::write(file, &Page::of_query(title, &query, separation))
    }
}

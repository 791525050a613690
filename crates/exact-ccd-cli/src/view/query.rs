//! The page of one of many queries.

use std::path::PathBuf;

use exact_ccd::Query;
use exact_ccd_view::{Page, PageKind};

use crate::failure::Failure;

/// The options of a page of one query.

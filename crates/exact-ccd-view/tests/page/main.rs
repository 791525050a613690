//! The data of pages, read back from the HTML, against the input.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod html;
mod queries;
mod size;
mod steps;

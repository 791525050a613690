//! The program from outside: arguments and files in; status, standard output and standard error out.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod examples;
mod folder;
mod meshes;
mod queries;
mod queries_errors;
mod query_rows;
mod step;
mod step_errors;
mod streams;
mod usage;

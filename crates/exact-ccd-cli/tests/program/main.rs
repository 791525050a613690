//! Tests of the program through its arguments and files, its exit status, standard output and
//! standard error.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod audit;
mod bench;
mod certificates;
mod certified_scenes;
mod contact_lists;
mod convert;
mod distances;
mod examples;
mod files_in_use;
mod folder;
mod golden;
mod half_spaces;
mod ids;
mod import;
mod inputs;
mod meshes;
mod methods;
mod octocats;
mod parts;
mod queries;
mod queries_curved;
mod queries_errors;
mod queries_separation;
mod query_rows;
mod recognised;
mod repair;
mod repeatable;
mod reports;
mod round_errors;
mod round_meshes;
mod round_queries;
mod rounding_report;
mod scene_groups;
mod scenes;
mod schema;
mod simulate;
mod simulate_bodies;
mod simulate_errors;
mod simulate_pictures;
mod simulate_queries;
mod simulate_resume;
mod split_vertices;
mod start_check;
mod step;
mod step_errors;
mod streams;
mod usage;
mod verdicts;
mod view;

//! The table of the bodies of a system, to which the numbers of bodies in other files refer.

use std::path::Path;

use exact_ccd_sim::System;
use serde::Serialize;

use super::log::write_rows;
use crate::messages::failure::Failure;

/// A body, or a half space, which has no vertices.
#[derive(Serialize)]
struct Row {
    body: usize,
    name: String,
    kind: &'static str,
    /// The first of its consecutive vertices in the files of all vertices.
    first_vertex: u32,
    vertex_count: u32,
}

/// Writes the table of all bodies, followed by the half spaces.
pub(crate) fn write(file: &Path, system: &System) -> Result<(), Failure> {
    let vertices = system.mesh_vertices();
    let place = |vertex: u32| vertices.partition_point(|&other| other < vertex) as u32;
    let names = system.body_names().into_iter().zip(system.body_kinds());
    let mut rows: Vec<Row> = (0..)
        .zip(names.zip(system.body_vertices()))
        .map(|(body, ((name, kind), vertices))| Row {
            body,
            name,
            kind,
            first_vertex: place(vertices.start),
            vertex_count: place(vertices.end) - place(vertices.start),
        })
        .collect();
    for (number, half_space) in system.half_spaces().iter().enumerate() {
        rows.push(Row {
            body: rows.len(),
            name: match half_space.name.as_str() {
                "" => format!("half-space-{number}"),
                name => name.to_owned(),
            },
            kind: "half-space",
            first_vertex: vertices.len() as u32,
            vertex_count: 0,
        });
    }
    write_rows(file, &rows)
}

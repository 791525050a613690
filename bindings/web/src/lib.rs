//! The kernel in a browser: functions for a page, compiled for WebAssembly.
//!
//! Each answer is a JSON text. It has the data of a page of `exact-ccd-view`, so that the viewer of
//! the repository shows it, and beside it the answer of a floating-point root finder.

mod error;
mod mesh_step;
mod query;
mod root_finder;

use wasm_bindgen::prelude::{JsError, wasm_bindgen};

use crate::mesh_step::MeshStep;
use crate::root_finder::RootFinder;

/// The answer to a query.
///
/// `kind` is `vertex-face`, `edge-edge`, `vertex-edge` or `vertex-vertex`; `coordinates` has the points at
/// t = 0, then at t = 1, in the order of the kind. Primitives at most `distance` apart count as touching.
/// The root finder adds `tolerance` to that distance.
///
/// # Errors
/// If the kind is unknown, the number of coordinates does not fit the kind, a coordinate is not finite, or a
/// distance is negative or not finite.
#[wasm_bindgen(js_name = answerQuery)]
pub fn answer_query(
    kind: &str,
    coordinates: &[f64],
    distance: f64,
    tolerance: f64,
) -> Result<String, JsError> {
    Ok(query::answer(kind, coordinates, distance, tolerance)?)
}

/// The motion of a mesh between two files.
#[wasm_bindgen]
pub struct Motion(MeshStep);

#[wasm_bindgen]
impl Motion {
    /// Reads two mesh files by their names and contents.
    ///
    /// # Errors
    /// The message names the file and the place in it, or the first difference of the two meshes.
    #[wasm_bindgen(constructor)]
    pub fn new(start_name: &str, start: &[u8], end_name: &str, end: &[u8]) -> Result<Self, JsError> {
        let files = [(start_name, start), (end_name, end)];
        Ok(Self(MeshStep::read(files)?))
    }

    /// All contacts of the step, exactly.
    ///
    /// # Errors
    /// If the distance is negative or not finite.
    pub fn contacts(&mut self, distance: f64) -> Result<String, JsError> {
        Ok(self.0.contacts(distance)?)
    }

    /// The earliest contact of the step according to the root finder, among the pairs that the last call
    /// of `contacts` has examined. Primitives at most `distance` apart count as touching.
    ///
    /// # Errors
    /// If the distance is negative or not finite.
    #[wasm_bindgen(js_name = rootFinder)]
    pub fn root_finder(&self, distance: f64) -> Result<String, JsError> {
        Ok(self.0.root_finder(RootFinder::new(distance)?)?)
    }

    /// The coordinates of the query with these vertices of the mesh, at t = 0 and then at t = 1.
    ///
    /// # Errors
    /// If the mesh has no such vertex.
    pub fn coordinates(&self, vertices: &[u32]) -> Result<Vec<f64>, JsError> {
        Ok(self.0.coordinates(vertices)?)
    }
}

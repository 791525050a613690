//! The elements in an array: the vertices of faces, edges or tetrahedra.

use super::array::Array;
use super::roles::Form;
use crate::error::{Fault, ParseError, Place, quoted};

/// Elements of one role.
#[derive(Debug)]
pub(in super::super) struct Elements {
    /// The number of vertices of each element and the vertices, or those of all elements after each other.
    vertices: Vec<i64>,
    form: Form,
}

impl Elements {
    /// The elements in the array with this name.
    ///
    /// # Errors
    /// If a list does not have its form throughout, or rows or a list may have counts of corners that their
    /// form does not have.
    pub(super) fn read(array: &Array, name: &str, form: Form) -> Result<Self, ParseError> {
        let vertices = array.integers();
        let is_list = array.shape.len() == 1;
        let fault = |expected: &str| {
            let expected = format!("{expected} in {}", quoted(name.as_bytes()));
            let found = format!(
                "integers that begin with {:?}",
                &vertices[..vertices.len().min(8)]
            );
            Err(Fault::expected(expected, found).at(Place::File))
        };
        match form {
            Form::Counts if !has_counts(&vertices) => {
                return fault(
                    "a row for each element (reshape(-1, 3) for triangles), or the number of corners before \
                     the corners of each element, as pyvista has them,",
                );
            }
            Form::Rows(size) if is_list && !vertices.len().is_multiple_of(size) => {
                return fault(&format!("{size} vertices for each element"));
            }
            Form::Rows(size) if is_list && !vertices.is_empty() && has_counts(&vertices) => {
                return fault(&format!(
                    "a row for each element (reshape(-1, {size})), not a list that may have the number of \
                     corners before the corners of each element,"
                ));
            }
            Form::Rows(size @ 4..) if !is_list && begin_with_count(&vertices, size) => {
                return fault(
                    "rows that do not all begin with the number of the other corners (remove this column, \
                     [:, 1:], or begin a face at another corner)",
                );
            }
            _ => {}
        }
        Ok(Self { vertices, form })
    }

    /// The vertices of each element.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[i64]> {
        let mut rest = &self.vertices[..];
        std::iter::from_fn(move || match self.form {
            Form::Rows(size) => rest.split_off(..size),
            Form::Counts => split_counted(&mut rest),
        })
    }
}

/// Removes the next element, its number of corners and the corners.
fn split_counted<'a>(rest: &mut &'a [i64]) -> Option<&'a [i64]> {
    let (&count, after) = rest.split_first()?;
    let count = usize::try_from(count).ok().filter(|&count| count >= 2)?;
    let corners = after.get(..count)?;
    *rest = &after[count..];
    Some(corners)
}

/// Returns true if there are counts and corners throughout.
fn has_counts(vertices: &[i64]) -> bool {
    let mut rest = vertices;
    while split_counted(&mut rest).is_some() {}
    rest.is_empty()
}

/// Returns true if each of the rows, of which there is one at least, begins with the number of the others.
fn begin_with_count(vertices: &[i64], size: usize) -> bool {
    let count = size as i64 - 1;
    !vertices.is_empty() && vertices.chunks(size).all(|row| row[0] == count)
}

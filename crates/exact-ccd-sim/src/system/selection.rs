//! The unknowns that a selection of vertices stands for.

use std::collections::BTreeSet;

use super::bodies::Bodies;
use super::body_error::{BodyError, Selecting};
use super::error::SystemError;
use crate::carriers::Carriers;

/// The selected vertices, each once, with the nodes of affine bodies in place of the vertices that they
/// carry. The error names their selection, `what`.
///
/// # Errors
/// [`BodyError::Partly`], if some vertices of an affine body are selected, but not all.
pub(super) fn unknowns(
    carriers: &Carriers,
    bodies: &Bodies,
    vertices: &[u32],
    what: Selecting,
) -> Result<Vec<u32>, SystemError> {
    let mut selected: BTreeSet<u32> = vertices.iter().copied().collect();
    for carried in carriers.bodies() {
        let (found, expected) = (selected.range(carried.clone()).count(), carried.len());
        if found == 0 {
            continue;
        }
        if found < expected {
            return Err(SystemError::Body {
                body: bodies.designation(bodies.of(carried.start)),
                source: BodyError::Partly {
                    what,
                    found,
                    expected,
                },
            });
        }
        selected.retain(|vertex| !carried.contains(vertex));
        selected.extend(carriers.nodes(carried));
    }
    Ok(selected.into_iter().collect())
}

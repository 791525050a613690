//! Continuous collision detection in the line search: how far a step may go.

mod bisection;
mod by_method;
mod exact;
mod increment;
mod parity;

pub use bisection::Bisection;
pub use by_method::ByMethod;
pub use exact::Exact;
pub use increment::Increment;
pub use parity::Parity;

use exact_ccd_mesh::{Aabb, Point};

/// A method of continuous collision detection, as a line search uses it.
pub trait StepFilter: Send + Sync {
    /// The name by which it is chosen.
    fn name(&self) -> &str;

    /// How much of the increment is free of contact, from 0 to 1, according to this method: 1 only if all of it is, at most
    /// [`LAST`] if there is a contact, even one at the very end.
    fn largest(&self, increment: &Increment<'_>) -> f64;

    /// Whether the step from the start of the increment to these positions is free of contact, according to this method.
    /// The positions lie between the start and the end of the increment.
    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool;
}

/// The greatest part of a step that is not all of it.
pub const LAST: f64 = 1.0_f64.next_down();

/// No method has the name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no method `{name}` of continuous collision detection, expected one of: {}", known.join(", "))]
pub struct UnknownFilter {
    /// The name.
    pub name: String,
    /// The names that there are.
    pub known: Vec<String>,
}

/// All names: `exact`, `bisection` with the exact decision, `parity`, and those of [`exact_ccd_methods::all`] in lower case, where
/// they are not taken.
#[must_use]
pub fn names() -> Vec<String> {
    let own = ["exact", "bisection", "parity"].map(str::to_owned);
    let methods = exact_ccd_methods::all()
        .into_iter()
        .map(|method| method.name().to_lowercase());
    let mut names = own.to_vec();
    for name in methods {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The filter of a name, in upper or lower case, for a scene that lies in a box.
///
/// # Errors
/// [`UnknownFilter`] has the names that there are.
pub fn by_name(name: &str, scene: Aabb) -> Result<Box<dyn StepFilter>, UnknownFilter> {
    let name = name.to_lowercase();
    match name.as_str() {
        "exact" => return Ok(Box::new(Exact)),
        "bisection" => return Ok(Box::new(Bisection::exact())),
        "parity" => return Ok(Box::new(Parity::within(scene))),
        _ => {}
    }
    let mut methods = exact_ccd_methods::all().into_iter();
    match methods.find(|method| method.name().to_lowercase() == name) {
        Some(method) => Ok(Box::new(ByMethod::new(&name, method))),
        None => Err(UnknownFilter { name, known: names() }),
    }
}

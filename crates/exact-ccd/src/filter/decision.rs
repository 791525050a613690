//! The statements that filters prove.

use super::contact::Contact;
use crate::values::{ContactTime, Stage};

/// The outcome of the filters.
pub(crate) enum Decision {
    /// The primitives do not touch until the last time that counts, proved at this stage.
    Free(Stage),
    /// The primitives touch.
    Collision(Proved),
    /// The filters prove neither.
    Unknown,
}

/// The proof that primitives touch.
pub(crate) enum Proved {
    Contact(Contact),
    /// The first time within a separation above 0, and the stage that found it.
    Within(ContactTime, Stage),
}

//! Ten published methods of continuous collision detection, and the exact one, behind one trait.
//!
//! Each is implemented from the literature, as published, with its published parameters as the defaults: what it
//! misses and what it invents is part of it. They are here to be compared with; the method to use is [`Exact`].

mod exact;
mod interval;
mod method;
mod parity;

pub use exact::Exact;
pub use method::{Answer, Method, Promise, Time};
pub use parity::RootParity;

//! The public interface: impacts, derivatives, close calls, kinds, types of other crates; and the rooms.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod close_calls;
mod gradient;
mod impact;
mod interoperability;
mod kinds;
mod rooms;

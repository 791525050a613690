//! Queries of curved motion: answers against the definition, and laws.

mod cases;
mod errors;
mod filters;
mod laws;
mod numbers;
mod oracle;
mod places;

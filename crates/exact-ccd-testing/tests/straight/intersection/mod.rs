//! Predicates of an edge and a face at rest, compared with rational arithmetic.

mod named_cases;
mod random;

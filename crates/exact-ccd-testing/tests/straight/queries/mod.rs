//! The answers to queries, compared with their definition, their symmetries, and independent truth.

mod agreement;
mod batch;
mod cuts;
mod each_kind;
mod families;
mod invariance;
mod known_contacts;
mod named_cases;
mod non_finite;
mod radicals;
mod rational;
mod rational_times;
mod separated;
mod subdivision;
mod until;
mod within;

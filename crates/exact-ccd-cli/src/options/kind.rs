//! The kinds of query on the command line, by their short names.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use exact_ccd::AnyKind;

/// The parser of the short names of some kinds, such as `vf`.
pub(crate) fn parser(kinds: &'static [AnyKind]) -> impl TypedValueParser<Value = AnyKind> {
    let of_name = |name: String| kinds.iter().copied().find(|kind| kind.short() == name);
    PossibleValuesParser::new(kinds.iter().map(|kind| kind.short()))
        .map(move |name| of_name(name).expect("a possible value is the name of a kind"))
}

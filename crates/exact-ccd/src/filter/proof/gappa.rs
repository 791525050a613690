//! Scripts for Gappa, which proves bounds of absolute errors by interval arithmetic.
//!
//! A script has the operations of a value twice, with and without rounding. It is made from the record of the
//! code of the filters, and is a file of the folder `proof` of this crate. `scripts/check bounds` runs Gappa
//! on them. After a change of that code, `UPDATE_EXPECT=1 cargo test -p exact-ccd --lib proof` writes them
//! anew.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::String;
use core::fmt::Write;
use std::path::Path;

use super::symbol::{Operation, Symbol, record};
use crate::numbers::double_double::ROUNDOFF;
use crate::numbers::roundoff::UNIT;

/// The statement of a script: if all inputs are at most 1 in magnitude, a value is off by at most some error.
pub(in crate::filter) struct Script<'a> {
    /// The name of the file.
    pub(in crate::filter) name: &'a str,
    /// The statement in words.
    pub(in crate::filter) about: &'a str,
    /// True for [`Precise<true>`](super::Precise): each operation has an error of at most [`ROUNDOFF`]
    /// relative to its operands. Otherwise, each operation has the error of f64.
    pub(in crate::filter) is_twice: bool,
    /// Numbers that stand for all in [0, 1].
    pub(in crate::filter) parameters: &'a [f64],
    /// Values that are at most 1 in magnitude, for other reasons than the operations.
    pub(in crate::filter) bounded: &'a [Symbol],
    /// The value.
    pub(in crate::filter) value: Symbol,
    /// The error, in units of u or of [`ROUNDOFF`].
    pub(in crate::filter) units: u32,
}

impl Script<'_> {
    /// Asserts that the script is the file of its name, or writes the file.
    pub(in crate::filter) fn check(&self) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("proof/{}.g", self.name));
        let text = self.text();
        if std::env::var_os("UPDATE_EXPECT").is_some() {
            std::fs::write(&path, &text).unwrap();
        }
        let file = std::fs::read_to_string(&path).unwrap();
        assert!(
            file == text,
            "{} is not that of the code: see {}",
            path.display(),
            file!()
        );
    }

    fn text(&self) -> String {
        let exponent = exponent(if self.is_twice { ROUNDOFF } else { UNIT });
        let record = record();
        let mut places = BTreeSet::new();
        let mut open = alloc::vec![self.value.place];
        while let Some(place) = open.pop() {
            if places.insert(place) {
                open.extend(operands(record[place]));
            }
        }
        let first = *places.first().unwrap();
        let mut text = format!("# {}\n", self.about);
        text +=
            "# n is a value as it is computed, e without any rounding. Written by a test: see gappa.rs.\n";
        if !self.is_twice {
            text += "@rnd = float<ieee_64, ne>;\n";
        }
        let (mut given, mut hints) = (String::new(), String::new());
        let name = |prefix: &str, place: usize| match record[place] {
            Operation::Input => format!("x{}", place - first),
            Operation::Rounded(input) if prefix == "e" => format!("x{}", input - first),
            Operation::Constant(x) => match self.parameters.iter().position(|&parameter| parameter == x) {
                Some(index) => format!("p{index}"),
                None => format!("{x:?}"),
            },
            _ => format!("{prefix}{}", place - first),
        };
        for &place in &places {
            let (n, e) = (name("n", place), name("e", place));
            let expression = |prefix: &str| match record[place] {
                Operation::Input | Operation::Constant(_) => String::new(),
                Operation::Rounded(a) | Operation::Magnitude(a) => name(prefix, a),
                Operation::Sum(a, b) => format!("{} + {}", name(prefix, a), name(prefix, b)),
                Operation::Difference(a, b) => format!("{} - {}", name(prefix, a), name(prefix, b)),
                Operation::Product(a, b) => format!("{} * {}", name(prefix, a), name(prefix, b)),
                Operation::Quotient(a, b) => format!("{} / {}", name(prefix, a), name(prefix, b)),
                Operation::Negative(a) => format!("-{}", name(prefix, a)),
                Operation::Root(a) => format!("sqrt({})", name(prefix, a)),
            };
            if matches!(record[place], Operation::Input) {
                write!(given, "|{n}| <= 1 /\\ ").unwrap();
                continue;
            }
            if matches!(record[place], Operation::Constant(_)) {
                continue;
            }
            if !matches!(record[place], Operation::Rounded(_)) {
                writeln!(text, "{e} = {};", expression("e")).unwrap();
            }
            if matches!(record[place], Operation::Negative(_)) {
                writeln!(text, "{n} = {};", expression("n")).unwrap();
            } else if self.is_twice {
                let of = place - first;
                let [error, inherited] = error_of_one(record[place], of, name);
                writeln!(text, "{n} = ({}) + ({error});", expression("n")).unwrap();
                writeln!(hints, "{n} - {e} -> ({inherited}) + ({error});").unwrap();
                write!(given, "|a{of}| <= 1b{exponent} /\\ ").unwrap();
                if !matches!(record[place], Operation::Product(..)) {
                    write!(given, "|b{of}| <= 1b{exponent} /\\ ").unwrap();
                }
            } else {
                writeln!(text, "{n} = rnd({});", expression("n")).unwrap();
            }
            if self.bounded.iter().any(|value| value.place == place) {
                write!(given, "|{e}| <= 1 /\\ ").unwrap();
            }
        }
        for index in 0..self.parameters.len() {
            write!(given, "p{index} in [0, 1] /\\ ").unwrap();
        }
        let given = given.trim_end_matches(" /\\ ").replace(" /\\ ", " /\\\n  ");
        let (value, units) = (self.value.place - first, self.units);
        write!(
            text,
            "{{ {given}\n  -> |n{value} - e{value}| <= {units}b{exponent} }}\n{hints}"
        )
        .unwrap();
        text
    }
}

/// The exponent of a power of two.
pub(super) fn exponent(power: f64) -> i32 {
    power.log2() as i32
}

/// The error of one operation in twice the precision, and the error of its operands, in terms of the
/// operands' names and of factors of at most [`ROUNDOFF`].
fn error_of_one(operation: Operation, place: usize, name: impl Fn(&str, usize) -> String) -> [String; 2] {
    let of = |x: usize| [name("n", x), name("e", x)];
    match operation {
        Operation::Sum(a, b) | Operation::Difference(a, b) => {
            let ([na, ea], [nb, eb]) = (of(a), of(b));
            let sign = if matches!(operation, Operation::Sum(..)) {
                '+'
            } else {
                '-'
            };
            [
                format!("{na} * a{place} + {nb} * b{place}"),
                format!("({na} - {ea}) {sign} ({nb} - {eb})"),
            ]
        }
        Operation::Product(a, b) => {
            let ([na, ea], [nb, eb]) = (of(a), of(b));
            [
                format!("({na} * {nb}) * a{place}"),
                format!("({na} - {ea}) * {eb} + {ea} * ({nb} - {eb}) + ({na} - {ea}) * ({nb} - {eb})"),
            ]
        }
        _ => unreachable!("only sums and products have twice the precision"),
    }
}

fn operands(operation: Operation) -> impl Iterator<Item = usize> {
    let (a, b) = match operation {
        Operation::Input | Operation::Constant(_) => (None, None),
        Operation::Rounded(a) | Operation::Negative(a) | Operation::Magnitude(a) | Operation::Root(a) => {
            (Some(a), None)
        }
        Operation::Sum(a, b)
        | Operation::Difference(a, b)
        | Operation::Product(a, b)
        | Operation::Quotient(a, b) => (Some(a), Some(b)),
    };
    a.into_iter().chain(b)
}

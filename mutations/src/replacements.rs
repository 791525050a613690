//! The operators, methods and values that take the place of others.

use quote::ToTokens;
use syn::{Expr, Lit, Type};

/// The operators in place of a binary one.
pub fn operators(name: &str) -> &'static [&'static str] {
    match name {
        "+" => &["-", "*"],
        "-" => &["+", "/"],
        "*" => &["+", "/"],
        "/" => &["*", "%"],
        "%" => &["/", "+"],
        "<" => &["<=", "==", ">"],
        "<=" => &["<", ">"],
        ">" => &[">=", "==", "<"],
        ">=" => &[">", "<"],
        "==" => &["!="],
        "!=" => &["=="],
        "&" => &["|", "^"],
        "|" => &["&", "^"],
        "^" => &["|", "&"],
        "<<" => &[">>"],
        ">>" => &["<<"],
        _ => &[],
    }
}

/// The method in place of another one, in an expression.
pub fn method(name: &str, expression: &str) -> Option<&'static str> {
    Some(match name {
        "min" => "max",
        "max" => "min",
        "any" => "all",
        "all" => "any",
        "next_down" => "next_up",
        "next_up" => "next_down",
        "is_some_and" => "is_none_or",
        "is_none_or" => "is_some_and",
        "lower" if expression.contains("time") => "upper",
        "upper" if expression.contains("time") => "lower",
        _ => return None,
    })
}

/// The literals in place of another one.
pub fn literals(lit: &Lit) -> Vec<String> {
    match lit {
        Lit::Int(literal) => {
            let Ok(number) = literal.base10_parse::<u64>() else {
                return Vec::new();
            };
            [number.checked_add(1), number.checked_sub(1)]
                .into_iter()
                .flatten()
                .map(|other| format!("{other}{}", literal.suffix()))
                .collect()
        }
        Lit::Float(literal) => match literal.base10_parse::<f64>() {
            Ok(0.0) => vec!["1.0".into()],
            Ok(number) => vec![format!("{:?}", 2.0 * number), format!("{:?}", 0.5 * number)],
            Err(_) => Vec::new(),
        },
        Lit::Bool(literal) => vec![(!literal.value).to_string()],
        _ => Vec::new(),
    }
}

/// The values that a function with this type may return at once.
pub fn values(output: &Type) -> Vec<Expr> {
    let name = output.to_token_stream().to_string().replace(' ', "");
    let values: &[&str] = match name.as_str() {
        "bool" => &["true", "false"],
        "f64" | "f32" => &["0.0", "1.0", "-1.0"],
        "usize" | "u32" | "u64" => &["0", "1"],
        "Point" => &["[0.0; 3]", "[1.0; 3]"],
        "ControlFlow<()>" => &["ControlFlow::Continue(())", "ControlFlow::Break(())"],
        _ if name.starts_with("Option<") => &["None"],
        _ if name.starts_with("Vec<") => &["Vec::new()"],
        _ if name.starts_with("ArrayVec<") => &["ArrayVec::new()"],
        _ => &[],
    };
    values
        .iter()
        .map(|value| syn::parse_str(value).expect("the table has expressions"))
        .collect()
}

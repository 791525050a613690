//! Texts in XML.

use std::io;

use super::check::invalid;

/// A text as the value of an attribute, with its meaning for the error if XML 1.0 does not allow one of its
/// characters.
pub(super) fn attribute(meaning: &str, text: &str) -> io::Result<String> {
    escaped(text).ok_or_else(|| invalid(format!("the {meaning} {text:?} does not fit into XML")))
}

/// The escaped text, or none if XML 1.0 does not allow one of its characters.
fn escaped(text: &str) -> Option<String> {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '"' => escaped += "&quot;",
            '\t' | '\n' | '\r' => escaped += &format!("&#{};", u32::from(character)),
            '\0'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => return None,
            _ => escaped.push(character),
        }
    }
    Some(escaped)
}

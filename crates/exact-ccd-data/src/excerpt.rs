//! Excerpts of files in messages.

/// The beginning of a field, on one line.
pub(crate) fn excerpt(field: &[u8]) -> String {
    const LENGTH: usize = 40;
    let text = String::from_utf8_lossy(&field[..field.len().min(LENGTH)]);
    let mark = if field.len() > LENGTH { "…" } else { "" };
    format!("{}{mark}", text.escape_debug())
}

#[cfg(test)]
mod tests {
    use super::excerpt;

    #[test]
    fn excerpts_are_short_and_on_one_line() {
        assert_eq!(excerpt(b"1\n2\xff"), "1\\n2\u{fffd}");
        assert_eq!(excerpt(&[b'9'; 1000]).chars().count(), 41);
    }
}

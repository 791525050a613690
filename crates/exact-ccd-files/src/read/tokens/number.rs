//! Numbers as text.

/// A number as text.
pub(in super::super) trait Number: Sized {
    /// The number in this text, as the standard library reads it.
    fn parse(text: &[u8]) -> Option<Self>;
}

/// The nearest number.
impl Number for f64 {
    fn parse(text: &[u8]) -> Option<Self> {
        std::str::from_utf8(text).ok()?.parse().ok()
    }
}

impl Number for u64 {
    fn parse(text: &[u8]) -> Option<Self> {
        digits(text.strip_prefix(b"+").unwrap_or(text))
    }
}

impl Number for i64 {
    fn parse(text: &[u8]) -> Option<Self> {
        match text.strip_prefix(b"-") {
            Some(magnitude) => 0_i64.checked_sub_unsigned(digits(magnitude)?),
            None => u64::parse(text)?.try_into().ok(),
        }
    }
}

/// Bytes, because most words of a file are indices: text in UTF-8 takes twice as long.
fn digits(text: &[u8]) -> Option<u64> {
    let append = |number: u64, &byte: &u8| {
        let digit = byte.wrapping_sub(b'0');
        (digit < 10).then(|| number.checked_mul(10)?.checked_add(digit.into()))?
    };
    text.first()?;
    text.iter().try_fold(0, append)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::Number;

    fn assert_same(text: &str) {
        assert_eq!(u64::parse(text.as_bytes()), text.parse().ok(), "{text}");
        assert_eq!(i64::parse(text.as_bytes()), text.parse().ok(), "{text}");
    }

    #[test]
    fn the_ends_of_the_range_are_those_of_the_standard_library() {
        for number in [0, i128::from(i64::MIN), i64::MAX.into(), u64::MAX.into()] {
            (number - 2..=number + 2).for_each(|number| assert_same(&number.to_string()));
        }
        for text in [
            "", "+", "-", "-0", "+-1", "--1", "007", "1.", "1e3", " 1", "1 ", "٣",
        ] {
            assert_same(text);
        }
    }

    proptest! {
        #[test]
        fn integers_are_those_of_the_standard_library(text in "[+-]{0,2}[0-9]{0,21}[/:a-]?") {
            assert_same(&text);
        }
    }
}

//! The share of the frames that one process of several examines.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// The part `number` of `count`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Share {
    number: usize,
    count: usize,
}

impl Share {
    /// All frames.
    pub(super) const WHOLE: Self = Self { number: 1, count: 1 };

    /// The frames of the part. The parts of one count have each frame once, and nearly as many as each other.
    pub(super) fn of(self, frames: usize) -> Range<usize> {
        // No product overflows: it is below 2⁶⁴ times the number of parts, which is below 2³².
        let first = |number: usize| (frames as u128 * number as u128 / self.count as u128) as usize;
        first(self.number - 1)..first(self.number)
    }

    /// The name of the file of the results.
    pub(super) fn file_name(self) -> String {
        format!("part-{}-of-{}.jsonl", self.number, self.count)
    }
}

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text
            .split_once('/')
            .and_then(|(number, count)| Some((number.parse::<u32>().ok()?, count.parse::<u32>().ok()?)));
        match numbers {
            Some((number, count)) if (1..=count).contains(&number) => Ok(Self {
                number: number as usize,
                count: count as usize,
            }),
            _ => Err("expected a part of several, from 1/N to N/N".to_owned()),
        }
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "part {} of {}", self.number, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::Share;

    #[test]
    fn the_parts_have_each_frame_once() {
        for frames in [1, 2, 7, 100, 2400] {
            for count in [1, 2, 3, 7, 11] {
                let mut next = 0;
                for number in 1..=count {
                    let share: Share = format!("{number}/{count}").parse().unwrap();
                    let range = share.of(frames);
                    assert_eq!(range.start, next);
                    assert!(range.len().abs_diff(frames / count) <= 1);
                    next = range.end;
                }
                assert_eq!(next, frames);
            }
        }
    }

    #[test]
    fn other_texts_are_no_parts() {
        for text in [
            "",
            "1",
            "0/2",
            "3/2",
            "1/0",
            "-1/2",
            "1/2/3",
            "a/b",
            "1/4294967296",
        ] {
            assert!(text.parse::<Share>().is_err(), "{text}");
        }
    }
}

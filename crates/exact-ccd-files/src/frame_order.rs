//! The order of frames by the numbers in their names.

use std::cmp::Ordering;
use std::fmt;
use std::path::{Path, PathBuf};

/// Files in the order of the numbers in their names, as a shell does not give them.
///
/// ```
/// use exact_ccd_files::FrameOrder;
///
/// let order = FrameOrder::of(["f1.ply", "f10.ply", "f2.ply"].map(Into::into).to_vec());
/// assert_eq!(order.files, ["f1.ply", "f2.ply", "f10.ply"].map(std::path::PathBuf::from));
/// assert!(order.is_changed);
/// assert_eq!(order.missing.iter().map(ToString::to_string).collect::<Vec<_>>(), ["3 to 9"]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FrameOrder {
    /// The files in order. Runs of digits compare as numbers, everything between them as text.
    pub files: Vec<PathBuf>,
    /// True if the files were given in another order.
    pub is_changed: bool,
    /// The numbers that are missing in the row, if the names differ in one number only.
    pub missing: Vec<Missing>,
}

/// Missing numbers in a row of files: `first`, `first + stride`, … up to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The first missing number.
    pub first: u64,
    /// The last missing number before the next file.
    pub last: u64,
    /// The difference of consecutive numbers: the greatest one that divides all differences.
    pub stride: u64,
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { first, last, stride } = self;
        match (first == last, stride) {
            (true, _) => write!(f, "{first}"),
            (false, 1) => write!(f, "{first} to {last}"),
            (false, _) => write!(f, "{first} to {last} in steps of {stride}"),
        }
    }
}

impl FrameOrder {
    /// Orders files that are a row, that is, whose names differ in one number only. Others keep their order:
    /// it says what the names do not.
    ///
    /// ```
    /// use exact_ccd_files::FrameOrder;
    ///
    /// let order = |names: [&str; 3]| FrameOrder::of_row(names.map(Into::into).to_vec());
    /// assert!(order(["f1.ply", "f10.ply", "f2.ply"]).is_changed);
    /// assert!(!order(["start.ply", "middle.ply", "end.ply"]).is_changed);
    /// assert!(!order(["f1.ply", "f0.ply", "f1.ply"]).is_changed);
    /// ```
    #[must_use]
    pub fn of_row(given: Vec<PathBuf>) -> Self {
        let ordered = Self::of(given.clone());
        let is_row = numbers(&ordered.files).is_some_and(|row| row.windows(2).all(|pair| pair[0] < pair[1]));
        if is_row {
            ordered
        } else {
            let (is_changed, missing) = (false, Vec::new());
            Self {
                files: given,
                is_changed,
                missing,
            }
        }
    }

    /// Orders files. Equal numbers with other zeros before them, and other ties, are in the order
    /// of the paths; the same path twice stays twice.
    #[must_use]
    pub fn of(given: Vec<PathBuf>) -> Self {
        let mut files = given.clone();
        files.sort_by(|a, b| by_number(a, b));
        let missing = numbers(&files).map_or(Vec::new(), |numbers| gaps(&numbers));
        Self {
            is_changed: files != given,
            files,
            missing,
        }
    }
}

/// A piece of a path. Numbers are compared by the number of their digits, then by the digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece<'a> {
    Number(usize, &'a [u8]),
    Text(&'a [u8]),
}

/// The order in which `frame2` is before `frame10`.
fn by_number(a: &Path, b: &Path) -> Ordering {
    pieces(a).cmp(pieces(b)).then_with(|| a.cmp(b))
}

fn pieces(path: &Path) -> impl Iterator<Item = Piece<'_>> {
    let bytes = path.as_os_str().as_encoded_bytes();
    let runs = bytes.chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    runs.map(|run| {
        if !run[0].is_ascii_digit() {
            return Piece::Text(run);
        }
        let zeros = run.iter().take_while(|&&digit| digit == b'0').count();
        Piece::Number(run.len() - zeros, &run[zeros..])
    })
}

/// The numbers of files whose names differ in one number only.
fn numbers(files: &[PathBuf]) -> Option<Vec<u64>> {
    let first: Vec<Piece> = pieces(files.first()?).collect();
    let mut place = None;
    let mut numbers = Vec::new();
    for file in files {
        let file: Vec<Piece> = pieces(file).collect();
        if file.len() != first.len() {
            return None;
        }
        for (at, (a, b)) in first.iter().zip(&file).enumerate() {
            if a != b && *place.get_or_insert(at) != at {
                return None;
            }
        }
    }
    let place = place?;
    for file in files {
        let Piece::Number(_, digits) = pieces(file).nth(place)? else {
            return None;
        };
        let digits = std::str::from_utf8(digits).ok()?;
        numbers.push(if digits.is_empty() {
            0
        } else {
            digits.parse().ok()?
        });
    }
    Some(numbers)
}

/// The gaps in increasing numbers.
fn gaps(numbers: &[u64]) -> Vec<Missing> {
    let pairs = || numbers.windows(2).map(|pair| (pair[0], pair[1]));
    let stride = pairs().fold(0, |stride, (a, b)| greatest_common_divisor(stride, b - a));
    let wide = pairs().filter(|(a, b)| b - a > stride);
    wide.map(|(a, b)| Missing {
        first: a + stride,
        last: b - stride,
        stride,
    })
    .collect()
}

fn greatest_common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 {
        a
    } else {
        greatest_common_divisor(b, a % b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(names: &[&str]) -> FrameOrder {
        FrameOrder::of(names.iter().map(PathBuf::from).collect())
    }

    #[test]
    fn names_are_ordered_by_the_numbers_in_them() {
        let ordered = [
            "2.ply",
            "10.ply",
            "a1b2.ply",
            "a1b10.ply",
            "a02.ply",
            "a2.ply",
            "a10.ply",
            "a.ply",
            "b0.ply",
        ];
        let mut names = ordered;
        names.reverse();
        assert_eq!(order(&names).files, ordered.map(PathBuf::from));
        assert!(order(&names).is_changed && !order(&ordered).is_changed);
    }

    #[test]
    fn missing_numbers_follow_from_the_common_step() {
        let missing = |names: &[&str]| {
            let missing = order(names).missing;
            missing.iter().map(Missing::to_string).collect::<Vec<_>>()
        };
        assert_eq!(
            missing(&["f08.ply", "f10.ply", "f11.ply", "f15.ply"]),
            ["9", "12 to 14"]
        );
        assert_eq!(
            missing(&["f0.ply", "f10.ply", "f50.ply", "f70.ply"]),
            ["20 to 40 in steps of 10", "60"]
        );
        for complete in [
            &["f1.ply", "f2.ply", "f3.ply"][..],
            &["f0.ply", "f5.ply"],
            &["f1.ply"],
            &[],
        ] {
            assert!(missing(complete).is_empty(), "{complete:?}");
        }
        // Names that differ in text, in two numbers, or not at all are not a row.
        for other in [
            ["a1.ply", "b9.ply"],
            ["a1b1.ply", "a9b9.ply"],
            ["a1.ply", "a1.ply"],
        ] {
            assert!(missing(&other).is_empty(), "{other:?}");
        }
        assert!(missing(&["f1.ply", "f99999999999999999999.ply"]).is_empty());
    }
}

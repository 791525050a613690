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
    /// The files in order. Runs of digits compare as numbers, and two runs with a point between them as a
    /// decimal; everything else compares as text.
    pub files: Vec<PathBuf>,
    /// Two files whose order is not certain: the second one would be before the first one if a point between
    /// digits were text between two numbers, as in `v2.9` and `v2.10`.
    pub uncertain: Option<[PathBuf; 2]>,
    /// The first two consecutive files whose names, without their extensions, differ in more than numbers, as
    /// the files of two recordings do.
    pub unlike: Option<[PathBuf; 2]>,
    /// True if the files were given in another order.
    pub is_changed: bool,
    /// The numbers that are missing, if the names differ in whole numbers only: in the first place where they
    /// differ, as the time steps in `000012-003.ply`, and in the second place among names with the same
    /// number in the first one, as the increments of a time step. Both must be in increasing order.
    pub missing: Vec<Missing>,
}

/// Missing numbers in the names of files: `first`, `first + stride`, … up to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The number in the first place where names differ, if the missing numbers are in the second one.
    pub within: Option<u64>,
    /// The first missing number.
    pub first: u64,
    /// The last missing number before the next file.
    pub last: u64,
    /// The difference of consecutive numbers: the greatest one that divides all differences in this place.
    pub stride: u64,
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            within,
            first,
            last,
            stride,
        } = self;
        if let Some(within) = within {
            write!(f, "in {within}: ")?;
        }
        match (first == last, stride) {
            (true, _) => write!(f, "{first}"),
            (false, 1) => write!(f, "{first} to {last}"),
            (false, _) => write!(f, "{first} to {last} in steps of {stride}"),
        }
    }
}

impl FrameOrder {
    /// Orders files that are a row, that is, whose names differ in one number only. The order given is
    /// kept if the names differ in anything else.
    ///
    /// ```
    /// use exact_ccd_files::FrameOrder;
    ///
    /// let order = |names: [&str; 3]| FrameOrder::of_row(names.map(Into::into).to_vec());
    /// assert!(order(["f1.ply", "f10.ply", "f2.ply"]).is_changed);
    /// assert!(!order(["start.ply", "middle.ply", "end.ply"]).is_changed);
    /// assert!(!order(["f1.ply", "f0.ply", "f1.ply"]).is_changed);
    /// assert!(order(["t1.0.ply", "t0.50.ply", "t0.25.ply"]).is_changed);
    /// assert!(order(["t0.25.ply", "t0.5.ply", "t0.75.ply"]).uncertain.is_some());
    /// ```
    #[must_use]
    pub fn of_row(given: Vec<PathBuf>) -> Self {
        let ordered = Self::of(given.clone());
        let is_row = match columns(&ordered.files).as_deref() {
            Some([row]) => row.windows(2).all(|pair| pair[0] < pair[1]),
            _ => false,
        };
        if is_row {
            ordered
        } else {
            Self {
                missing: missing(&given),
                unlike: first_pair(&given, are_unlike),
                files: given,
                uncertain: None,
                is_changed: false,
            }
        }
    }

    /// Orders files. Equal numbers with other zeros before them, and other ties, are in the order
    /// of the paths; the same path twice stays twice.
    #[must_use]
    pub fn of(given: Vec<PathBuf>) -> Self {
        let mut files = given.clone();
        files.sort_by(|a, b| by_number(Reading::Decimals, a, b));
        Self {
            is_changed: files != given,
            uncertain: first_pair(&files, is_uncertain),
            unlike: first_pair(&files, are_unlike),
            missing: missing(&files),
            files,
        }
    }
}

/// The meaning of a point between two runs of digits.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reading {
    /// The decimal point of a number, unless there are more points, as in a date.
    Decimals,
    /// Text between two numbers.
    Numbers,
}

/// A piece of a path. Numbers are compared by the number of digits before the point, by these digits, then
/// by the digits after the point, without zeros at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece<'a> {
    Number(usize, &'a [u8], &'a [u8]),
    Text(&'a [u8]),
}

impl<'a> Piece<'a> {
    fn number(whole: &'a [u8], fraction: &'a [u8]) -> Self {
        let zeros = whole.iter().take_while(|&&digit| digit == b'0').count();
        let zeros_at_end = fraction.iter().rev().take_while(|&&digit| digit == b'0').count();
        let fraction = &fraction[..fraction.len() - zeros_at_end];
        Self::Number(whole.len() - zeros, &whole[zeros..], fraction)
    }

    /// The value of a number without a fraction.
    fn whole(&self) -> Option<u64> {
        match self {
            Self::Number(0, _, []) => Some(0),
            Self::Number(_, digits, []) => std::str::from_utf8(digits).ok()?.parse().ok(),
            _ => None,
        }
    }
}

/// The order in which `frame2` is before `frame10`.
fn by_number(reading: Reading, a: &Path, b: &Path) -> Ordering {
    let by_pieces = pieces(reading, a).cmp(&pieces(reading, b));
    by_pieces.then_with(|| a.cmp(b))
}

/// The first two consecutive files for which a condition holds.
fn first_pair(files: &[PathBuf], holds: impl Fn(&Path, &Path) -> bool) -> Option<[PathBuf; 2]> {
    let mut pairs = files.iter().zip(files.iter().skip(1));
    let pair = pairs.find(|(a, b)| holds(a, b));
    pair.map(|(a, b)| [a.clone(), b.clone()])
}

/// Returns true if two names have the same pieces but for the numbers.
fn are_alike(reading: Reading, a: &Path, b: &Path) -> bool {
    let texts = |path| {
        let pieces = pieces(reading, path).into_iter();
        pieces.map(|piece| match piece {
            Piece::Text(text) => Some(text),
            Piece::Number(..) => None,
        })
    };
    texts(a).eq(texts(b))
}

/// Returns true if two names without their extensions differ in more than numbers.
fn are_unlike(a: &Path, b: &Path) -> bool {
    let [a, b] = [a, b].map(|path| path.with_extension(""));
    !are_alike(Reading::Decimals, &a, &b)
}

/// Returns true if the order of two files that are alike depends on the meaning of a point.
fn is_uncertain(a: &Path, b: &Path) -> bool {
    are_alike(Reading::Numbers, a, b) && by_number(Reading::Numbers, a, b) == Ordering::Greater
}

fn pieces(reading: Reading, path: &Path) -> Vec<Piece<'_>> {
    let bytes = path.as_os_str().as_encoded_bytes();
    let runs = bytes.chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    let runs: Vec<_> = runs.collect();
    let is_point = |at: Option<usize>| at.and_then(|at| runs.get(at)) == Some(&&b"."[..]);
    let mut pieces = Vec::new();
    let mut at = 0;
    while let Some(&run) = runs.get(at) {
        let is_decimal = reading == Reading::Decimals
            && run[0].is_ascii_digit()
            && is_point(Some(at + 1))
            && !is_point(at.checked_sub(1))
            && !is_point(Some(at + 3));
        match runs.get(at + 2) {
            Some(fraction) if is_decimal => {
                pieces.push(Piece::number(run, fraction));
                at += 3;
                continue;
            }
            _ if run[0].is_ascii_digit() => pieces.push(Piece::number(run, &[])),
            _ => pieces.push(Piece::Text(run)),
        }
        at += 1;
    }
    pieces
}

/// The numbers of all files, for each place in which names differ that differ in numbers only.
fn columns(files: &[PathBuf]) -> Option<Vec<Vec<Piece<'_>>>> {
    let files: Vec<_> = files.iter().map(|file| pieces(Reading::Decimals, file)).collect();
    let length = files.first()?.len();
    if files.iter().any(|file| file.len() != length) {
        return None;
    }
    let column = |at: usize| -> Vec<Piece> { files.iter().map(|file| file[at]).collect() };
    let columns = (0..length).map(column);
    let columns: Vec<_> = columns
        .filter(|column| column.iter().any(|piece| *piece != column[0]))
        .collect();
    let is_number = |piece: &Piece| matches!(piece, Piece::Number(..));
    columns.iter().flatten().all(is_number).then_some(columns)
}

/// The numbers that are missing in the first two places in which the names differ.
fn missing(files: &[PathBuf]) -> Vec<Missing> {
    let columns = columns(files).unwrap_or_default();
    let whole = |column: &Vec<Piece>| column.iter().map(Piece::whole).collect::<Option<Vec<u64>>>();
    let mut columns = columns.iter().map_while(whole);
    let Some(first) = columns.next() else {
        return Vec::new();
    };
    let mut missing = gaps(&[(None, &first)]);
    if let Some(second) = columns.next()
        && first.is_sorted()
    {
        let mut rest = &second[..];
        let runs = first.chunk_by(|a, b| a == b).map(|run| {
            let (numbers, others) = rest.split_at(run.len());
            rest = others;
            (Some(run[0]), numbers)
        });
        missing.extend(gaps(&runs.collect::<Vec<_>>()));
    }
    missing
}

/// The gaps in runs of numbers, if no run decreases.
fn gaps(runs: &[(Option<u64>, &[u64])]) -> Vec<Missing> {
    if !runs.iter().all(|(_, run)| run.is_sorted()) {
        return Vec::new();
    }
    let pairs = || {
        runs.iter()
            .flat_map(|&(within, run)| run.windows(2).map(move |pair| (within, pair[0], pair[1])))
    };
    let stride = pairs().fold(0, |stride, (_, a, b)| greatest_common_divisor(stride, b - a));
    let wide = pairs().filter(|(_, a, b)| b - a > stride);
    wide.map(|(within, a, b)| Missing {
        within,
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

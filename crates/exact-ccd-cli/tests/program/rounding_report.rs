//! The report and the plot of `exact-ccd round`.

use crate::folder::Run;

/// The parts of a report.
#[derive(Debug, PartialEq)]
pub(crate) struct Report {
    /// The name of the displacement in the first line.
    pub(crate) name: String,
    pub(crate) displacement: [f64; 3],
    pub(crate) coordinates: usize,
    pub(crate) largest: f64,
    pub(crate) rows: Vec<Row>,
}

/// A line of the histogram.
#[derive(Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) first: f64,
    /// None for the zeros.
    pub(crate) below: Option<f64>,
    pub(crate) count: usize,
    pub(crate) bar: usize,
}

impl Report {
    #[track_caller]
    pub(crate) fn of(run: &Run) -> Self {
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
        let mut lines = run.stdout.lines();
        let (name, displacement) = lines.next().unwrap().split_once(" along x, y, z: ").unwrap();
        let displacement: Vec<_> = displacement.split(", ").map(|e| e.parse().unwrap()).collect();
        let summary = lines.next().unwrap().strip_suffix(':').unwrap();
        let summary = summary
            .strip_prefix("rounding errors |x + e - fl(x + e)| of ")
            .unwrap();
        let (coordinates, largest) = summary.split_once(" coordinates, at most ").unwrap();
        Self {
            name: name.to_owned(),
            displacement: displacement.try_into().unwrap(),
            coordinates: coordinates.parse().unwrap(),
            largest: largest.parse().unwrap(),
            rows: lines.map(Row::of).collect(),
        }
    }

    /// True if the histogram counts these errors and no others.
    #[track_caller]
    pub(crate) fn assert_counts(&self, errors: &[f64]) {
        assert_eq!(self.coordinates, errors.len());
        assert_eq!(self.largest, errors.iter().copied().fold(0.0, f64::max));
        assert_eq!(self.rows.iter().map(|row| row.count).sum::<usize>(), errors.len());
        for row in &self.rows {
            let is_here = |error: &&f64| match row.below {
                None => **error == 0.0,
                Some(below) => row.first <= **error && **error < below,
            };
            assert_eq!(row.count, errors.iter().filter(is_here).count(), "{row:?}");
            assert!(row.count > 0 && row.bar > 0, "{row:?}");
        }
        assert!(self.rows.is_sorted_by(|a, b| a.first < b.first));
        assert!(
            self.rows
                .iter()
                .all(|a| self.rows.iter().all(|b| a.count > b.count || a.bar <= b.bar))
        );
    }
}

impl Row {
    fn of(line: &str) -> Self {
        let words: Vec<_> = line.split_whitespace().collect();
        let (first, below, count, bar) = match words[..] {
            ["0", count, bar] => (0.0, None, count, bar),
            [first, "to", below, count, bar] => {
                (first.parse().unwrap(), Some(below.parse().unwrap()), count, bar)
            }
            _ => panic!("{line}"),
        };
        assert_eq!(bar, "#".repeat(bar.len()));
        Self {
            first,
            below,
            count: count.parse().unwrap(),
            bar: bar.len(),
        }
    }
}

/// True if a plot has the rows as bars: in their places on the axis, side by side, with heights in
/// proportion.
#[track_caller]
pub(crate) fn assert_drawn(drawing: &str, rows: &[Row]) {
    assert!(
        drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n"),
        "{drawing}"
    );
    let texts: Vec<_> = elements(drawing, "text").collect();
    let text = |content: &str| texts.iter().find(|text| text.content() == content);
    assert!(text("number of coordinates").is_some());
    assert!(text("log₁₀ ε").is_some());
    let zero = text("ε = 0").unwrap();

    // The first rectangle is the white ground.
    let bars: Vec<_> = elements(drawing, "rect").skip(1).collect();
    assert_eq!(bars.len(), rows.len());
    for (bar, row) in bars.iter().zip(rows) {
        let [left, width] = ["x", "width"].map(|name| bar.number(name));
        assert!(width > 0, "a bar that cannot be seen: {drawing}");
        let exponent = row.below.map(|below| below.log10().round() - 1.0);
        let distance = match exponent {
            None => left + width / 2 - zero.number("x"),
            Some(k) => texts
                .iter()
                .find(|label| label.content() == k.to_string() && label.number("y") == zero.number("y"))
                .map_or(0, |label| left - label.number("x")),
        };
        // In pixels.
        assert!(distance.abs() <= 1, "{row:?} in {drawing}");
    }
    assert!(bars.is_sorted_by(|a, b| a.number("x") + a.number("width") <= b.number("x")));
    let highest = rows.iter().map(|row| row.count).max().unwrap_or(0);
    let tallest = bars.iter().map(|bar| bar.number("height")).max();
    for (bar, row) in bars.iter().zip(rows) {
        let expected = f64::from(tallest.unwrap()) * row.count as f64 / highest as f64;
        assert!(
            (f64::from(bar.number("height")) - expected).abs() <= 1.0,
            "{row:?}"
        );
    }
}

/// An element of a drawing, from its first attribute on.
struct Element<'a>(&'a str);

fn elements<'a>(drawing: &'a str, name: &str) -> impl Iterator<Item = Element<'a>> {
    let start = format!("<{name} ");
    let places: Vec<_> = drawing.match_indices(&start).map(|(place, _)| place).collect();
    places
        .into_iter()
        .map(move |place| Element(&drawing[place + start.len() - 1..]))
}

impl Element<'_> {
    fn number(&self, attribute: &str) -> i32 {
        let (_, value) = self.0.split_once(&format!(" {attribute}=\"")).unwrap();
        value.split_once('"').unwrap().0.parse().unwrap()
    }

    fn content(&self) -> &str {
        let (_, content) = self.0.split_once(">\n").unwrap();
        content.split_once("\n</").unwrap().0
    }
}

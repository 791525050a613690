//! The measurements as a table in text.

use std::fmt::Write;

use crate::curve::{Cost, Curve};
use crate::memory::mebibytes;

/// A table in Markdown, and the slopes below it.
pub(crate) fn markdown(curve: &Curve) -> String {
    let mut text = format!("## {}\n\n", curve.question.title());
    text += "| triangles | primitives | candidates | colliding | ms | ns a candidate | MiB | bytes a primitive |\n";
    text += "|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for point in &curve.points {
        let bytes = point.memory.map(|bytes| bytes as f64 / point.primitives as f64);
        writeln!(
            text,
            "| {} | {} | {} | {} | {:.1} | {:.1} | {} | {} |",
            point.triangles,
            point.primitives,
            point.candidates,
            point.colliding,
            1e3 * point.seconds,
            1e9 * point.seconds / point.candidates as f64,
            or_unknown(point.memory.map(mebibytes), 1),
            or_unknown(bytes, 0),
        )
        .expect("a string takes all");
    }
    for (name, cost) in [("time", Cost::Seconds), ("memory", Cost::Mebibytes)] {
        if let [before, last] = curve.slopes(cost)[..] {
            writeln!(
                text,
                "\nSlope of the {name}: {last:.2} in the last decade, {before:.2} in the one before."
            )
            .expect("a string takes all");
        }
    }
    text
}

pub(crate) fn or_unknown(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "not known".into(), |value| format!("{value:.digits$}"))
}

//! The drawing area and its axes.

use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;

/// An area to draw on.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The result of drawing.
pub type Drawn<'a, T = ()> = Result<T, DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// A chart with its axes, to draw series on.
pub type Chart<'a, 'b, X, Y> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>;

/// The text of an SVG file with a size in pixels and the drawing on a white background.
#[must_use]
#[expect(clippy::missing_panics_doc, reason = "drawing into a string cannot fail")]
pub fn svg(size: (u32, u32), draw: impl for<'a> FnOnce(&Area<'a>) -> Drawn<'a>) -> String {
    let mut drawing = String::new();
    let root = SVGBackend::with_string(&mut drawing, size).into_drawing_area();
    let drawn = root
        .fill(&WHITE)
        .and_then(|()| draw(&root))
        .and_then(|()| root.present());
    drawn.expect("drawing into a string cannot fail");
    drop(root);
    drawing
}

/// Writes a text at a place in pixels from the top left corner.
///
/// # Errors
/// Never, into a string.
pub fn write<'a>(area: &Area<'a>, text: &str, place: (i32, i32)) -> Drawn<'a> {
    area.draw(&Text::new(text.to_owned(), place, ("sans-serif", 16)))
}

/// The title of an axis and the format of its numbers.
#[derive(Clone, Copy)]
pub struct Axis<'a, T> {
    /// The quantity and its unit.
    pub title: &'a str,
    /// The format of its numbers.
    pub label: &'a dyn Fn(&T) -> String,
}

/// Two axes with a title above them and space for a legend beside them.
#[derive(Clone, Copy)]
pub struct Frame<'a, X, Y> {
    /// The title, or an empty text for none.
    pub title: &'a str,
    /// The horizontal axis.
    pub x: Axis<'a, X>,
    /// The vertical axis.
    pub y: Axis<'a, Y>,
    /// The space on the right, in pixels.
    pub legend: i32,
}

impl<A, B> Frame<'_, A, B> {
    /// Draws the axes over their ranges.
    ///
    /// # Errors
    /// Never, into a string.
    pub fn draw<'a, 'b, X, Y>(
        &self,
        area: &'a Area<'b>,
        x: X,
        y: Y,
    ) -> Drawn<'b, Chart<'a, 'b, X::CoordDescType, Y::CoordDescType>>
    where
        X: AsRangedCoord<Value = A, CoordDescType: Ranged<ValueType = A> + ValueFormatter<A>>,
        Y: AsRangedCoord<Value = B, CoordDescType: Ranged<ValueType = B> + ValueFormatter<B>>,
    {
        let mut builder = ChartBuilder::on(area);
        builder
            .margin(15)
            .margin_right(self.legend)
            .x_label_area_size(55)
            .y_label_area_size(95);
        if !self.title.is_empty() {
            builder.caption(self.title, ("sans-serif", 24));
        }
        let mut chart = builder.build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .label_style(("sans-serif", 16))
            .axis_desc_style(("sans-serif", 18))
            .x_label_formatter(&self.x.label)
            .y_label_formatter(&self.y.label)
            .x_desc(self.x.title)
            .y_desc(self.y.title)
            .draw()?;
        Ok(chart)
    }
}
